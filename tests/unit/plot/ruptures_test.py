"""Arrival times and moments of events, as the figures show them."""

import h5py
import numpy as np
from matplotlib import pyplot

import synthetic_cycle as cycle
from asperity_plot import moment_rate, rupture_times, style, units, windows
from asperity.errors import InputError, NothingToShow
from asperity.run import Run
from folders import FolderCase


class Ruptures(FolderCase):
    def setUp(self):
        super().setUp()
        times = cycle.row_times()
        cycle.write_ruptures(self.folder / "rupture.h5", cycle.depths(97))
        cycle.write_totals(self.folder / "global.csv", times)
        cycle.write_events(self.folder / "events.csv")
        cycle.write_steps(self.folder / "steps.csv", times)
        style.use()
        self.addCleanup(pyplot.close, "all")

    def view(self, window=None):
        run = Run(self.folder)
        return run, windows.choose(run, window)

    def test_arrivals_count_from_the_onset_of_each_event(self):
        numbers, arrivals = rupture_times.after_onset(*self.view())
        np.testing.assert_array_equal(numbers, [1, 2, 3, 4])
        expected = np.tile(cycle.arrivals(cycle.depths(97)), (4, 1))
        np.testing.assert_allclose(arrivals, expected, atol=1e-5)

    def test_the_window_chooses_events(self):
        run, view = self.view((300 * cycle.YEAR, 440 * cycle.YEAR))
        np.testing.assert_array_equal(rupture_times.after_onset(run, view)[0], [3, 4])
        self.assertEqual([number for number, *_ in moment_rate.curves(run, view)], [3, 4])
        run, view = self.view((1.0, 2.0))
        for module in (rupture_times, moment_rate):
            with self.assertRaises(NothingToShow):
                module.draw(run, view)

    def test_events_that_reached_no_node_are_left_out(self):
        with h5py.File(self.folder / "rupture.h5", "a") as file:
            file["rupture_time"][1] = np.nan
        np.testing.assert_array_equal(rupture_times.after_onset(*self.view())[0], [1, 3, 4])

    def test_arrivals_over_depth(self):
        axes = rupture_times.draw(*self.view()).axes[0]
        depth = cycle.depths(97)
        reached = np.isfinite(cycle.arrivals(depth))
        self.assertEqual(len(axes.lines), 4)
        np.testing.assert_allclose(axes.lines[2].get_ydata(), depth[reached] / 1e3)
        np.testing.assert_allclose(axes.lines[2].get_xdata(), cycle.arrivals(depth)[reached],
                                   atol=1e-5)
        self.assertGreater(*axes.get_ylim())
        self.assertEqual(axes.figure._suptitle.get_text(), "First time with V ≥ 1 mm/s")
        labels = [text.get_text() for text in axes.get_legend().get_texts()]
        self.assertEqual(labels, ["event 1", "event 2", "event 3", "event 4"])

    def test_arrivals_on_a_buried_and_on_a_level_fault_count_from_the_upper_end(self):
        depth = cycle.depths(97)
        reached = np.isfinite(cycle.arrivals(depth))
        places = depth[reached] / 1e3
        with h5py.File(self.folder / "rupture.h5", "a") as file:
            file["geometry/coordinates"][:, 1] -= 2e3
        axes = rupture_times.draw(*self.view()).axes[0]
        np.testing.assert_allclose(axes.lines[0].get_ydata(), places)
        self.assertEqual(axes.get_ylabel(), "Distance from the upper end of the fault [km]")
        with h5py.File(self.folder / "rupture.h5", "a") as file:
            x = file["geometry/positions"][:] - 20e3
            file["geometry/coordinates"][:] = np.stack((x, 0.0 * x), axis=1)
        axes = rupture_times.draw(*self.view()).axes[0]
        np.testing.assert_allclose(axes.lines[0].get_xdata(), places)
        self.assertEqual(axes.get_xlabel(),
                         "Distance from the upper end of the fault (smaller x) [km]")

    def test_many_events_have_a_colour_bar(self):
        figure, axes = style.panels(1, 1, (4, 3))
        colour = style.event_colours(axes[0, 0], np.arange(1, 20))
        self.assertIsNone(axes[0, 0].get_legend())
        self.assertEqual(figure.axes[1].get_ylabel(), "Event")
        self.assertNotEqual(colour(1), colour(19))

    def test_moment_rate_and_moment_since_the_onset(self):
        depth = np.arange(50.0, 18e3, 100.0)
        for number, time, rate, moment in moment_rate.curves(*self.view()):
            onset = cycle.ONSETS[number - 1]
            inside = (time > 1e-3) & (time < cycle.duration() - 1e-3)
            self.assertEqual(np.count_nonzero(inside), 39)
            np.testing.assert_allclose(
                rate[inside], 3.2e12 * cycle.slip_rate(time[inside] + onset, depth).sum(axis=1),
                rtol=1e-6)
            slip = cycle.slip(time + onset, depth) - cycle.slip(np.array([onset]), depth)
            np.testing.assert_allclose(moment, 3.2e12 * slip.sum(axis=1), rtol=1e-5, atol=1e7)
            self.assertEqual(moment[np.searchsorted(time, 0.0)], 0.0)
            self.assertAlmostEqual(time[-1], cycle.duration(), places=5)

    def test_the_figure_has_both(self):
        axes = moment_rate.draw(*self.view()).axes
        events = list(moment_rate.curves(*self.view()))
        for panel, column, factor in ((axes[0], 2, 1e12), (axes[1], 3, 1e15)):
            for line, event in zip(panel.lines, events):
                shown = event[1] >= (-np.inf if panel is axes[0] else 0.0)
                np.testing.assert_allclose(line.get_xdata(), event[1][shown])
                np.testing.assert_allclose(line.get_ydata(), event[column][shown] / factor)
            self.assertGreaterEqual(panel.lines[0].get_ydata().min(), 0.0)
        self.assertEqual(axes[1].get_ylabel(), "Moment per length [$10^{15}$ N]")

    def test_the_axis_ends_with_the_pulse_and_not_with_the_creep_after_it(self):
        text = (self.folder / "events.csv").read_text()
        self.assertIn(f",{cycle.duration()},18000,", text)
        (self.folder / "events.csv").write_text(
            text.replace(f",{cycle.duration()},18000,", ",300,18000,"))
        for _, time, rate, _ in moment_rate.curves(*self.view()):
            self.assertAlmostEqual(time[-1], 300.0, places=5)
            self.assertAlmostEqual(moment_rate.pulse_end(time, rate), cycle.duration(), delta=0.3)
        for panel in moment_rate.draw(*self.view()).axes:
            self.assertTrue(panel.get_xlabel().endswith("[s]"), panel.get_xlabel())
            np.testing.assert_allclose(panel.get_xlim(), (-1.0, 11.0), rtol=0.03)

    def test_a_rate_after_the_onset_that_is_small_throughout_is_shown_to_its_end(self):
        time = np.array([-1.0, 0.0, 300.0])
        self.assertEqual(moment_rate.pulse_end(time, np.array([9.0, 5.0, 0.01])), 300.0)

    def test_the_figure_has_the_moments_of_the_catalogue_too(self):
        """Which count a node only while it is fast."""
        run, view = self.view()
        figure = moment_rate.draw(run, view)
        self.assertTrue(any("events.csv, to which a node" in text.get_text()
                            for text in figure.texts))
        circles = [line for line in figure.axes[1].lines if line.get_marker() == "o"][:-1]
        np.testing.assert_allclose([line.get_ydata()[0] * 1e15 for line in circles],
                                   run.complete_events["moment_per_length"])
        np.testing.assert_allclose([line.get_xdata()[0] for line in circles], cycle.duration(),
                                   rtol=1e-6)

    def test_totals_without_a_moment(self):
        text = (self.folder / "global.csv").read_text()
        (self.folder / "global.csv").write_text(text.replace("moment_rate_per_length", "other"))
        with self.assertRaisesRegex(InputError, "global.csv has no column 'moment_rate_per_len"):
            moment_rate.draw(*self.view())

    def test_a_row_between_onset_and_the_first_step(self):
        rows = (self.folder / "global.csv").read_text().splitlines()
        inside = [row for row in rows if row.startswith(f"{float(cycle.ONSETS[0])!r},")]
        self.assertEqual(len(inside), 1)
        rows.remove(inside[0])
        (self.folder / "global.csv").write_text("\n".join(rows) + "\n")
        _, time, rate, moment = next(moment_rate.curves(*self.view()))
        self.assertEqual((time[0], moment[0]), (0.0, 0.0))
        self.assertTrue(np.isfinite(rate[0]) and units.largest(moment) > 1e15)
