"""The displacement of the surface before and in an event, on both sides of a fault that cuts it."""

import tempfile
from pathlib import Path

import numpy as np
from matplotlib import pyplot

import synthetic_run
from asperity_plot import deformation, raster, style, surface, windows
from asperity.errors import InputError, NothingToShow
from asperity.run import Run
from folders import FolderCase

EVENTS = 4
X = np.array([-2.0, -1.0, 0.0, 0.0, 0.5, 2.0])   # [m]; the fault comes up at 0
FOOT = np.array([[0.2, 0.1], [0.4, 0.2], [0.6, 0.3], [0.0, 0.0], [0.0, 0.0], [0.0, 0.0]])
WALL = np.array([[0.0, 0.0], [0.0, 0.0], [0.0, 0.0], [3.0, -1.0], [2.0, -0.5], [1.0, 0.0]])
RATES = FOOT - WALL                               # (nodes, 2) [m/s] between events


class Deformation(FolderCase):
    def setUp(self):
        super().setUp()
        synthetic_run.write_run(self.folder, EVENTS, nodes=20, wedge=False)
        self.run_ = Run(self.folder)
        style.use()
        self.addCleanup(pyplot.close, "all")

    def write(self, coordinates=X):
        """Displacement grows from event to event, and returns within each."""
        events = self.run_.complete_events
        onsets, ends = events["onset"], events["onset"] + events["duration"]
        # The run ends before the waves of the last event have left.
        final = ends[-1] + 2.0 * events["duration"][-1]
        times = np.unique(np.concatenate(([0.0], onsets, ends, [final])))
        # Time between events until `times`, since the last of them.
        since = np.array([time - max([0.0, *ends[ends <= time]]) for time in times])
        since[np.isin(times, ends)] = 0.0
        synthetic_run.write_history(self.folder / "surface.h5", times,
                                    np.stack((coordinates, 0.0 * coordinates), axis=1),
                                    {"displacement": since[:, None, None] * RATES})
        return Run(self.folder)

    def panels(self, run, window=None):
        view = windows.choose(run, window)
        axes = deformation.draw(run, view).axes
        return view, [{line.get_label(): line for line in panel.lines} for panel in axes]

    def test_each_side_has_its_own_displacement(self):
        run = self.write()
        events, row = run.complete_events, 2
        onset, duration = events["onset"], events["duration"]
        view, (before, during) = self.panels(run, (onset[row] - 1.0, onset[row] + 1.0))
        self.assertEqual(view.number, row + 1)
        # Waves are given five durations to leave.
        start = onset[row - 1] + 6 * duration[row - 1]
        grown = onset[row] - start
        returned = onset[row] - onset[row - 1] - duration[row - 1] - 5 * duration[row]
        for name, component in (("horizontal", 0), ("up", 1)):
            for lines, time in ((before, grown), (during, -returned)):
                x, y = lines[name].get_data()
                self.assertEqual(np.flatnonzero(np.isnan(x)).tolist(), [3])
                kept = ~np.isnan(x)
                np.testing.assert_allclose(x[kept], X)
                np.testing.assert_allclose(y[kept], time * RATES[:, component],
                                           rtol=1e-6, atol=1e-9)

    def test_the_first_event_counts_from_the_start(self):
        run = self.write()
        onset = run.complete_events["onset"][0]
        view, (before, _) = self.panels(run, (0.0, onset + 0.1))
        self.assertEqual(view.number, 1)
        y = before["up"].get_ydata()
        self.assertAlmostEqual(y[4], onset * RATES[3, 1], delta=1e-6 * onset)

    def test_what_follows_the_only_event_of_a_run(self):
        synthetic_run.write_run(self.folder, 1, nodes=20, wedge=False)
        events = Run(self.folder).complete_events
        onset, duration = events["onset"][0], events["duration"][0]
        settled, final = onset + 6.0 * duration, onset + 100.0 * duration
        displacement = np.stack([0.0 * WALL, 0.0 * WALL, WALL, 3.0 * WALL])
        synthetic_run.write_history(self.folder / "surface.h5",
                                    np.array([0.0, onset, settled, final]),
                                    np.stack((X, 0.0 * X), axis=1), {"displacement": displacement})
        run = Run(self.folder)
        axes = deformation.draw(run, windows.choose(run, None)).axes
        self.assertEqual(len(axes), 2)
        for panel, words, factor in zip(axes, ("from the onset of event 1", "after it"), (1, 2)):
            self.assertTrue(panel.get_title().endswith(words), panel.get_title())
            y = panel.lines[1].get_ydata()
            np.testing.assert_allclose(y[~np.isnan(y)], factor * WALL[:, 1], atol=1e-9)

    def test_the_last_event_ends_with_the_run_at_the_latest(self):
        run = self.write()
        events = run.complete_events
        onset, last = events["onset"][-1], events["duration"][-1]
        view, (_, during) = self.panels(run, (onset - 1.0, onset + 1.0))
        self.assertEqual(view.number, EVENTS)
        gap = onset - events["onset"][-2] - events["duration"][-2]
        self.assertAlmostEqual(during["up"].get_ydata()[1], (2 * last - gap) * RATES[1, 1],
                               places=6)

    def test_without_an_event_it_says_so(self):
        run = self.write()
        onset = run.complete_events["onset"][0]
        with self.assertRaisesRegex(NothingToShow, "no event ended"):
            self.panels(run, (0.0, 0.5 * onset))

    def test_a_run_without_events_shows_all_its_time(self):
        self.write()
        (self.folder / "events.csv").unlink()
        run = Run(self.folder)
        view, (lines,) = self.panels(run)
        self.assertEqual(view.number, 0)
        first, last = run.surface.at("displacement", view.cycles[0]), run.surface.at(
            "displacement", view.cycles[1])
        x, y = lines["up"].get_data()
        in_cm = 100.0 * (last - first)[:, 1]
        np.testing.assert_allclose(y[~np.isnan(x)], in_cm, rtol=1e-6, atol=1e-9)

    def test_beside_an_antisymmetric_fault_both_halves_are_drawn(self):
        """Also where the surface begins beside the fault, and its positions away from it."""
        for side, gap in ((1.0, 0.0), (-1.0, 0.0), (1.0, 0.25)):
            with self.subTest(side=side, gap=gap), tempfile.TemporaryDirectory() as name:
                folder = Path(name)
                x = np.sort(side * (np.array([0.0, 1.0, 2.0, 4.0]) + gap))
                moved = np.array([[0.3, -0.2], [0.2, 0.1], [0.1, 0.4], [0.02, 0.5]])
                for file, nodes, values in (
                        ("fault.h5", np.stack((np.zeros(3), [0.0, -1.0, -2.0]), axis=1),
                         {"slip": np.zeros((3, 3))}),
                        ("surface.h5", np.stack((x, 0.0 * x), axis=1),
                         {"displacement": np.array([0, 1, 2])[:, None, None] * moved})):
                    synthetic_run.write_history(folder / file, np.arange(3.0), nodes, values)
                synthetic_run.add_condition(folder, "Antisymmetric Fault")
                run = Run(folder)
                panel = deformation.draw(run, windows.choose(run, None)).axes[0]
                for line, component, sign in zip(panel.lines, (0, 1), (1.0, -1.0)):
                    shown, values = (each[~np.isnan(each)] for each in line.get_data())
                    expected = {True: 200.0, False: 2.0}["[cm]" in panel.get_ylabel()] * moved
                    np.testing.assert_allclose(shown, np.sort(np.concatenate((-x, x))), atol=1e-12)
                    np.testing.assert_allclose(
                        values, np.concatenate((sign * expected[::-1, component],
                                                expected[:, component])) if side > 0 else
                        np.concatenate((expected[:, component], sign * expected[::-1, component])))

    def test_beside_a_fault_of_another_type_there_is_no_image(self):
        run = self.write()
        synthetic_run.add_condition(self.folder, "Two-Sided Fault")
        _, (before, _) = self.panels(run)
        x = before["up"].get_xdata()
        np.testing.assert_allclose(x[~np.isnan(x)], X)

    def test_without_a_file_of_the_fault_the_half_is_named(self):
        self.write()
        synthetic_run.add_condition(self.folder, "Antisymmetric Fault")
        (self.folder / "fault.h5").unlink()
        run = Run(self.folder)
        figure = deformation.draw(run, windows.choose(run, None))
        self.assertIn("modelled half", figure._suptitle.get_text())

    def test_the_map_of_the_surface_jumps_at_the_fault(self):
        run = self.write()
        self.assertIsNotNone(surface.draw(run, windows.choose(run, None)))
        values = np.array([[1.0, 2.0, 3.0, -5.0, -4.0, -1.0]])
        shown = raster.along(run.surface.position, values, np.array([0.0, 1.5, 2.0, 2.25, 4.0]))
        np.testing.assert_allclose(shown, [[1.0, 2.5, 3.0, -4.5, -1.0]])

    def test_nodes_at_one_place_alone_are_no_curve(self):
        run = self.write(np.zeros(6))
        with self.assertRaisesRegex(InputError, "no two nodes"):
            run.surface.position  # pylint: disable=pointless-statement
