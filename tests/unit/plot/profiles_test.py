"""Slip every few years and every second of rupture: the times, the values, and what is doubtful."""

import tempfile
import unittest
from dataclasses import replace
from pathlib import Path

import h5py
import numpy as np
from matplotlib import pyplot
from matplotlib.colors import to_hex

import synthetic_cycle as cycle
import synthetic_run
from asperity_plot import along, profiles, slip, slip_profiles, slip_rate, style, windows
from asperity.history import History
from asperity_plot.windows import Options
from asperity.run import Run
from asperity.tables import Table
from folders import SharedFolderCase

YEAR = cycle.YEAR


def catalogue(onsets, durations) -> Table:
    columns = {"onset": np.array(onsets, dtype=float), "duration": np.array(durations, dtype=float)}
    return Table(Path("events.csv"), columns, {})


class Times(unittest.TestCase):
    def test_every_five_years_but_not_in_an_event(self):
        times = profiles.between_events((0.0, 22.0), 5.0, catalogue([9.9, 19.0], [0.2, 0.5]))
        np.testing.assert_array_equal(times, [0.0, 5.0, 15.0, 20.0])
        np.testing.assert_array_equal(profiles.between_events((2.0, 12.0), 5.0, None), [2, 7, 12])

    def test_the_last_line_is_not_lost_to_rounding(self):
        times = profiles.between_events((0.0, 0.3), 0.1, None)
        np.testing.assert_allclose(times, [0.0, 0.1, 0.2, 0.3])
        self.assertLessEqual(times[-1], 0.3)

    def test_every_second_of_each_rupture(self):
        events = catalogue([10.0, 100.5], [2.5, 1.0])
        np.testing.assert_array_equal(profiles.in_events((0.0, 200.0), 1.0, events),
                                      [10.0, 11.0, 12.0, 100.5])
        np.testing.assert_array_equal(profiles.in_events((11.5, 99.0), 1.0, events), [12.0])
        self.assertEqual(profiles.in_events((0.0, 9.0), 1.0, None).size, 0)

    def test_the_rows_around_a_time(self):
        rows = np.array([0.0, 1.0, 4.0, 4.5])
        before, after = profiles.enclosing(rows, np.array([0.0, 0.5, 1.0, 2.0, 4.2, 4.5]))
        np.testing.assert_array_equal(before, [0, 0, 1, 1, 4, 4.5])
        np.testing.assert_array_equal(after, [0, 1, 1, 4, 4.5, 4.5])

    def test_intervals_suit_short_runs_and_events(self):
        events = catalogue([1.0, 2.0, 3.0], [30.0, 60.0, 90.0])
        self.assertEqual(profiles.intervals((0.0, 500 * YEAR), events), (5 * YEAR, 1.0))
        between, during = profiles.intervals((0.0, 1800.0), catalogue([1.0], [0.12]))
        self.assertAlmostEqual(between, 50.0)
        self.assertAlmostEqual(during, 0.02)


class Profiles(SharedFolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cycle.write_run(cls.folder / "cycle")
        style.use()

    def tearDown(self):
        pyplot.close("all")

    def test_values_are_linear_between_rows_of_uneven_times(self):
        path = self.folder / "uneven" / "fault.h5"
        rows = np.array([0.0, 4.0, 12.0, 13.0, 30.0]) * YEAR
        slip = np.random.default_rng(3).uniform(0.0, 5.0, (5, 3)).cumsum(axis=0)
        coordinates = np.stack((np.arange(3.0), np.zeros(3)), axis=1)
        synthetic_run.write_history(path, rows, coordinates, {"slip": slip})
        times = profiles.between_events((0.0, 30.0 * YEAR), 5.0 * YEAR, None)
        expected = np.stack([np.interp(times, rows, slip[:, node]) for node in range(3)], axis=1)
        found = profiles.family(History(path), times, 5.0 * YEAR)
        self.assertEqual(found.slip.shape, (7, 3))
        np.testing.assert_allclose(found.slip, expected, rtol=1e-12)
        # 5, 10, 15, 20 and 25 years lie in gaps of 8 and 17 years; 0 and 30 are rows.
        self.assertEqual(found.num_doubtful, 5)
        synthetic_run.write_history(path, rows, coordinates, {"slip": -slip})
        found = profiles.family(History(path), times, 9.0 * YEAR)
        np.testing.assert_allclose(found.slip, expected, rtol=1e-12)
        self.assertEqual(found.num_doubtful, 3)

    def view(self, window=None, **options):
        run = Run(self.folder / "cycle")
        return run, windows.choose(run, window, Options(**options))

    def test_lines_of_a_run_are_its_slip_at_their_times(self):
        run, view = self.view()
        between, during = slip_profiles.lines(run, view)
        np.testing.assert_allclose(between.times, np.arange(0.0, 451.0, 5.0) * YEAR, rtol=1e-12)
        self.assertEqual(during.times.size, 4 * 10)
        np.testing.assert_allclose(during.times[10:20], cycle.ONSETS[1] + np.arange(10.0))
        for family in (between, during):
            expected = cycle.slip(family.times, cycle.depths(97))
            np.testing.assert_allclose(family.slip, expected, atol=1e-6)
            self.assertEqual(family.num_doubtful, 0)

    def test_intervals_of_the_user_and_doubts_about_them(self):
        run, view = self.view(intervals=(0.1 * YEAR, 0.2003))
        between, during = slip_profiles.lines(run, view)
        self.assertEqual(between.times.size, 4501 - 4)  # the onsets fall on lines
        self.assertEqual(during.times.size, 4 * 50)
        # Rows are half a year apart, in which nothing moves that can be seen, and in events 0.25 s.
        self.assertEqual(between.num_doubtful, 0)
        moved = 0
        for onset in cycle.ONSETS:
            rows = 0.25 * np.floor(np.arange(0.2003, 10.0, 0.2003) / 0.25)
            before, after = (cycle.slip(onset + rows + more, cycle.depths(97))
                             for more in (0.0, 0.25))
            moved += np.sum((after - before).max(axis=1) > 0.01 * during.slip.max())
        self.assertEqual(during.num_doubtful, moved)
        self.assertGreater(moved, 100)
        text = slip_profiles.doubts([replace(between, num_doubtful=7), during])
        self.assertIn("7 of the 4497 lines between events are interpolated", text)
        self.assertIn(f" and {during.num_doubtful} of the 200 lines in events", text)
        self.assertIn("more than 200.3 ms apart: let", text)
        self.assertIn(slip_profiles.ADVICE, text)
        self.assertEqual(slip_profiles.doubts([replace(between, num_doubtful=0),
                                               replace(during, num_doubtful=0)]), "")
        figure = slip_profiles.draw(run, replace(view, sequence=(195 * YEAR, 197 * YEAR)))
        self.assertTrue(any("more than 200.3 ms" in text.get_text() for text in figure.texts))

    def test_slip_counts_from_the_start_of_the_window(self):
        window = (300.0 * YEAR, 400.0 * YEAR)
        run, view = self.view(window)
        between, during = slip_profiles.lines(run, view)
        start = cycle.slip(np.array(window[:1]), cycle.depths(97))
        self.assertEqual(during.times.size, 10)
        for family in (between, during):
            expected = cycle.slip(family.times, cycle.depths(97)) - start
            np.testing.assert_allclose(family.slip, expected, atol=1e-6)

    def test_the_figure_has_depth_downwards_and_slip_across(self):
        run, view = self.view()
        axes = slip_profiles.draw(run, view).axes[0]
        self.assertEqual(len(axes.lines), 91 + 40)
        line = axes.lines[91 + 12]
        np.testing.assert_allclose(line.get_ydata(), cycle.depths(97) / 1e3)
        expected = cycle.slip(np.array([cycle.ONSETS[1] + 2.0]), cycle.depths(97))[0]
        np.testing.assert_allclose(line.get_xdata(), expected, atol=1e-6)
        self.assertEqual([to_hex(axes.lines[number].get_color()) for number in (0, 100)],
                         [style.BLUE, style.ORANGE])
        self.assertEqual(axes.get_ylim(), (40.0, 0.0))
        labels = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(labels, ["every 5 yr", "every 1 s"])
        self.assertEqual((axes.get_xlabel(), axes.get_ylabel()), ("Slip [m]", "Depth [km]"))


class Axes(unittest.TestCase):
    def axis(self, coordinates, deck: str = "", fields=None, place: str = "fault",
             parts=None) -> along.Axis:
        with tempfile.TemporaryDirectory() as name:
            folder = Path(name)
            synthetic_run.write_history(folder / "fault.h5", np.array([0.0, 1.0]),
                                        np.array(coordinates, dtype=float), fields or {})
            if parts:
                with h5py.File(folder / "fault.h5", "a") as file:
                    file["geometry/part_names"] = list(parts)
                    file["geometry/part_ends"] = list(parts.values())
            if deck:
                (folder / "parameters.xml").write_text(deck)
            run = Run(folder)
            return along.axis(run, run.fault, place)

    def test_several_faults_on_one_axis(self):
        axis = self.axis([(0.0, 0.0), (20e3, -5e3), (24e3, -1e3)],
                         parts={"main": (0.0, 20616.0), "splay": (20616.0, 26273.0)})
        self.assertEqual(axis.label,
                         "Distance from the upper end of the fault [km]\n(splay from 20.6)")

    def test_each_of_several_faults_counts_from_its_own_upper_end(self):
        """A main fault and a splay, whose upper end is at the surface."""
        main, splay = [(0.0, 0.0), (3e3, -4e3), (6e3, -8e3)], [(2e3, 0.0), (2.6e3, -0.8e3)]
        with tempfile.TemporaryDirectory() as name:
            path = Path(name) / "fault.h5"
            rows = np.arange(5.0)[None] * np.ones((2, 1))
            synthetic_run.write_history(path, np.array([0.0, 1.0]), np.array(main + splay),
                                        {"slip": rows, "slip_rate": rows + 1e-9})
            with h5py.File(path, "a") as file:
                file["geometry/positions"][:] = [0.0, 5e3, 10e3, 10e3, 11e3]
                file["geometry/part_names"] = ["main", "splay"]
                file["geometry/part_ends"] = [[0.0, 10e3], [10e3, 11e3]]
            run = Run(Path(name))
            faults = along.faults(run, run.fault)
            panels = slip.draw(run, windows.choose(run, None)).axes[:2]
            maps_of = slip_rate.draw(run, windows.choose(run, None)).axes[:2]
        self.assertEqual([axis.title for axis in faults], ["main", "splay"])
        self.assertEqual([axis.range for axis in faults], [(10.0, 0.0), (1.0, 0.0)])
        self.assertEqual(faults[1].label, "Distance from the upper end of the fault [km]")
        for panel, last in zip(panels, (10.0, 1.0)):  # no line from one fault to the other
            np.testing.assert_allclose(panel.lines[-1].get_xdata()[[0, -1]], [0.0, last])
        self.assertEqual([panel.get_ylim() for panel in maps_of], [(10.0, 0.0), (1.0, 0.0)])
        self.assertEqual([panel.get_ylabel().partition("\n")[0] for panel in maps_of],
                         ["main", "splay"])

    def test_depth_on_a_vertical_fault(self):
        axis = self.axis([(5.0, 0.0), (5.0, -10e3), (5.0, -40e3)])
        self.assertEqual((axis.label, axis.is_downwards), ("Depth [km]", True))
        np.testing.assert_allclose(axis([0.0, 10e3, 40e3]), [0.0, 10.0, 40.0])
        np.testing.assert_allclose(axis.positions([1e3, 40e3]), [1e3, 40e3])
        self.assertEqual(axis.range, (40.0, 0.0))

    def test_a_buried_fault_counts_from_its_upper_end(self):
        """As receivers and the files do, and not from the surface."""
        axis = self.axis([(5.0, -1e3), (5.0, -10e3), (5.0, -40e3)])
        self.assertEqual((axis.label, axis.is_downwards),
                         ("Distance from the upper end of the fault [km]", True))
        np.testing.assert_allclose(axis([0.0, 9e3, 39e3]), [0.0, 9.0, 39.0])
        np.testing.assert_allclose(axis.positions([0.0, 9e3, 39e3]), [0.0, 9e3, 39e3])
        self.assertEqual(axis.range, (39.0, 0.0))

    def test_no_depth_above_the_surface_or_on_a_slope(self):
        """The distance from the upper end."""
        for coordinates in ([(0.0, 5.0), (0.0, 0.0)], [(0.0, 0.0), (-4.0, -3.0)],
                            [(0.0, 0.0), (4.0, -3.0)]):
            axis = self.axis(coordinates)
            self.assertEqual((axis.name, axis.is_downwards),
                             ("Distance from the upper end of the fault", True))
            np.testing.assert_allclose(axis.metres([0.0, 5.0]), [0.0, 5.0])

    def test_a_level_fault_counts_from_its_end_with_the_smaller_x(self):
        axis = self.axis([(-3e3, 0.0), (9e3, 0.0)])
        self.assertEqual((axis.label, axis.is_downwards),
                         ("Distance from the upper end of the fault (smaller x) [km]", False))
        np.testing.assert_allclose(axis([0.0, 12e3]), [0.0, 12.0])
        np.testing.assert_allclose(axis.positions([3e3]), [3e3])

    def test_x_on_a_level_surface(self):
        axis = self.axis([(-3e3, 0.0), (9e3, 0.0)], place="surface")
        self.assertEqual(axis.label, "x [km]")
        np.testing.assert_allclose(axis([0.0, 12e3]), [-3.0, 9.0])

    def test_distance_from_the_trench_on_the_wedge(self):
        axis = self.axis([(-3e3, 0.0), (9e3, 0.0)], synthetic_run.PARAMETERS)
        self.assertEqual(axis.label, "Distance from the trench along the base [km]")
        np.testing.assert_allclose(axis([0.0, 12e3]), [0.0, 12.0])

    def test_what_is_prescribed_is_not_shown(self):
        axis = self.axis([(0.0, -4.0), (0.0, -3.0), (0.0, -2.0), (0.0, 0.0)],
                         fields={"prescribed": np.array([[1.0, 0.0, 0.0, 0.0]] * 2)})
        self.assertEqual(axis.limits, (1.0, 4.0))
