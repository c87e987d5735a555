"""Series at receivers and of other codes: read, compared in time, and drawn as they are."""

import unittest

import h5py
import numpy as np
from matplotlib import pyplot

import synthetic_cycle as cycle
from asperity_plot import receivers, reference, style, units, windows
from asperity.errors import InputError, NothingToShow
from asperity_plot.windows import Options
from asperity.run import Run
from asperity.series import Series
from folders import FolderCase

HEADER = "# a comment\nt slip slip_rate shear_stress state\n"
# V passes 1 mm/s at 2e9 s + 2.5 s.
ROWS = ("2e9 1.0 -4.0 30.0 9.0\n 0.2000000005D+10 1.5 -2.0 31.0 8.0\n"
        "2.00000001e9 2.0 -1.0 32.0 7.0\n")


class References(FolderCase):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "other_dp075_code.txt"
        self.path.write_text(HEADER + ROWS)

    def test_columns_become_si(self):
        series = reference.read(self.path)
        np.testing.assert_array_equal(series.time, [2e9, 2e9 + 5.0, 2e9 + 10.0])
        np.testing.assert_allclose(series.values["slip"], [1.0, 1.5, 2.0])
        np.testing.assert_allclose(series.values["slip_rate"], [1e-4, 1e-2, 1e-1])
        np.testing.assert_allclose(series.values["traction"], [30e6, 31e6, 32e6])
        np.testing.assert_allclose(series.values["theta"], [1e9, 1e8, 1e7])

    def test_named_columns_may_have_others_between(self):
        self.path.write_text("t slip slip_rate shear_stress normal_stress state\n"
                             "1e9 1.0 -4.0 30.0 50.0 9.0\n")
        values = reference.read(self.path).values
        self.assertEqual((values["traction"][0], values["theta"][0]), (30e6, 1e9))

    def test_which_receiver_it_belongs_to(self):
        def receiver(entry, names):
            return reference.read_all([entry], names)[0].receiver
        self.assertEqual(receiver(str(self.path), ["dp000", "dp07", "dp075"]), "dp075")
        self.assertEqual(receiver(f"dp000={self.path}", ["dp000", "dp075"]), "dp000")
        self.assertEqual(receiver(str(self.path), ["centre"]), "centre")
        self.assertIsNone(receiver(str(self.path), ["dp000", "dp100"]))
        with self.assertRaisesRegex(InputError, "no receiver 'dp1' is shown. There are dp000, dp"):
            receiver(f"dp1={self.path}", ["dp000", "dp075"])

    def test_what_is_no_such_file(self):
        for text in (HEADER, "", HEADER + "1 2 3 4\n", HEADER + ROWS + "1 2 3 4 end\n",
                     ROWS + "1 2 3 4 5 6\n"):
            self.path.write_text(text)
            with self.assertRaisesRegex(InputError, "needs five columns of numbers, t "):
                reference.read(self.path)
        with self.assertRaisesRegex(InputError, "nowhere.txt cannot be read"):
            reference.read(self.path.parent / "nowhere.txt")

    def test_the_rise_is_linear_in_log_v_and_the_closest(self):
        times = np.array([0.0, 4.0, 5.0, 6.0, 10.0])
        rate = np.array([1e-5, 1e-1, 1e-9, 0.0, 1.0])
        series = Series("one", times, {"slip_rate": rate})
        self.assertAlmostEqual(series.rise(1e-3, 0.0), 2.0)
        self.assertGreater(series.rise(1e-3, 9.0), 9.9)
        self.assertIsNone(series.rise(2.0, 0.0))
        self.assertIsNone(Series("none", times, {}).rise(1e-3, 0.0))

    def test_aligned_at_the_rise_of_its_receiver(self):
        mine = Series("dp075", np.array([0.0, 10.0]), {"slip_rate": np.array([1e-4, 1e-2])})
        other = reference.read(self.path, "dp075")
        moved = receivers.aligned(other, [mine], 1e-3, 4.0)
        self.assertAlmostEqual(moved.time[0], 5.0 - 2.5, places=5)
        self.assertIn("shown 63.4 yr earlier", moved.label)
        unpaired = reference.read(self.path)
        self.assertIs(receivers.aligned(unpaired, [mine], 1e-3, 4.0), unpaired)
        self.assertIs(receivers.aligned(other, [mine], 1.0, 4.0), other)

    def test_a_part_has_the_times_around_the_window(self):
        series = Series("one", np.arange(6.0), {"slip": np.arange(6.0) ** 2})
        part = series.within((1.5, 3.5))
        np.testing.assert_array_equal(part.time, [1.0, 2.0, 3.0, 4.0])
        np.testing.assert_array_equal(part.values["slip"], [1.0, 4.0, 9.0, 16.0])
        np.testing.assert_array_equal(series.within((-9.0, 9.0)).time, series.time)


class Receivers(FolderCase):
    def setUp(self):
        super().setUp()
        self.times = cycle.row_times()
        cycle.write_receivers(self.folder / "receivers.h5", self.times)
        cycle.write_events(self.folder / "events.csv")
        cycle.write_steps(self.folder / "steps.csv", self.times)
        cycle.write_parameters(self.folder / "parameters.xml")
        style.use()
        self.addCleanup(pyplot.close, "all")

    def draw(self, window=None, **options):
        run = Run(self.folder)
        return receivers.draw(run, windows.choose(run, window, Options(**options)))

    def expected(self, field: str) -> np.ndarray:
        depth = np.array(list(cycle.RECEIVERS.values()))
        return cycle.fields(self.times, depth)[field]

    def test_lines_are_the_series(self):
        figure = self.draw()
        panels = np.array(figure.axes[:-1]).reshape(4, 2)  # the last one has the legend
        for panel, (field, factor) in zip(panels[:, 0], (("slip_rate", 1.0), ("traction", 1e6),
                                                         ("theta", 1.0), ("slip", 1.0))):
            self.assertEqual(len(panel.lines), 7 + (field == "slip_rate"))  # the mark of the zoom
            for line, values in zip(panel.lines, self.expected(field).T):
                np.testing.assert_allclose(line.get_xdata(), self.times / units.YEAR)
                np.testing.assert_allclose(line.get_ydata(), values / factor)
        labels = [panel.get_ylabel() for panel in panels[:, 0]]
        self.assertEqual(labels, ["Slip rate V [m/s]", "Shear traction τ [MPa]", "State θ [s]",
                                  "Slip [m]"])
        self.assertEqual([panel.get_yscale() for panel in panels[:, 0]],
                         ["log", "linear", "log", "linear"])
        self.assertEqual(panels[3, 0].get_xlabel(), "Time [yr]")

    def test_the_zoom_counts_seconds_from_the_onset(self):
        line = self.draw().axes[7].lines[0]
        rows = (self.times >= cycle.ONSETS[2]) & (self.times <= cycle.ONSETS[2] + 10.0)
        shown = line.get_xdata()
        inside = (shown >= -1e-6) & (shown <= 10.0 + 1e-6)
        np.testing.assert_allclose(shown[inside], np.arange(0.0, 10.1, 0.25), atol=1e-6)
        np.testing.assert_allclose(line.get_ydata()[inside], self.expected("slip")[rows, 0])

    def test_slip_counts_in_its_direction(self):
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            for field in ("slip", "traction"):
                file[f"on_fault/fields/{field}"][...] *= -1.0
        figure = self.draw()
        np.testing.assert_allclose(figure.axes[6].lines[2].get_ydata(),
                                   self.expected("slip")[:, 2])
        np.testing.assert_allclose(figure.axes[2].lines[2].get_ydata(),
                                   self.expected("traction")[:, 2] / 1e6)

    def test_vectors_have_magnitudes(self):
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            slip = file["on_fault/fields/slip"][:]
            del file["on_fault/fields/slip"]
            file["on_fault/fields/slip"] = np.stack((-0.6 * slip, 0.8 * slip), axis=2)
        np.testing.assert_allclose(self.draw().axes[6].lines[3].get_ydata(),
                                   self.expected("slip")[:, 3])

    def test_choice_of_receivers_and_a_reference(self):
        path = self.folder / "dp100_other.txt"
        path.write_text(HEADER + ROWS)
        figure = self.draw(receivers=("dp100", "dp000"), references=(str(path),))
        panel = figure.axes[6]
        self.assertEqual(len(panel.lines), 3)
        np.testing.assert_allclose(panel.lines[0].get_ydata(), self.expected("slip")[:, 4])
        np.testing.assert_allclose(panel.lines[2].get_xdata() * units.YEAR,
                                   [2e9, 2e9 + 5, 2e9 + 10])
        self.assertEqual(panel.lines[2].get_color().tolist(), panel.lines[0].get_color().tolist())
        labels = [text.get_text() for text in figure.axes[-1].get_legend().get_texts()]
        self.assertEqual(labels[:2], ["dp100", "dp000"])
        self.assertIn("later", labels[2])
        with self.assertRaisesRegex(InputError, "no receiver 'dp1' on the fault or in the body. "
                                                "There are dp000"):
            self.draw(receivers=("dp1",))

    def test_names_of_the_other_figure_are_left_out(self):
        names = ("far", "dp100")
        self.assertEqual(len(self.draw(receivers=names).axes[6].lines), 1)
        with self.assertRaisesRegex(NothingToShow, "no receiver named far lies on the fault"):
            self.draw(receivers=("far",))

    def test_fields_that_the_deck_left_out_have_no_panel(self):
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file["on_fault/fields/theta"]
        self.assertEqual(len(self.draw().axes), 6 + 1)
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file["on_fault/fields"]
        with self.assertRaisesRegex(NothingToShow, "none of the fields slip_rate, traction"):
            self.draw()

    def test_no_receiver_on_the_fault(self):
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file["on_fault"]
        with self.assertRaisesRegex(NothingToShow, "no receiver on the fault"):
            self.draw()


class Labels(unittest.TestCase):
    def test_long_names_break(self):
        self.assertEqual(style.wrapped("dp075"), "dp075")
        self.assertEqual(style.wrapped("bp1_code_dp075_first\nshown 3 s later", 12),
                         "bp1_code_\ndp075_first\nshown 3 s\nlater")
