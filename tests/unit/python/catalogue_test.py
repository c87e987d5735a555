"""Which events count, and where their places count from."""

import re
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import numpy as np
from matplotlib import pyplot

import asperity
import asperity_plot.cli
import asperity_report.cli
import asperity_study.cli
import synthetic_cycle
import synthetic_run
from asperity import selection
from asperity.selection import Selection
from asperity_plot import events as boxes
from asperity_plot import windows
from asperity_study import results
from asperity_study.runner import Job
from asperity_study.study import Study, Variable
from folders import FolderCase, told

YEAR, DAY = 365.25 * 86400.0, 86400.0
RECURRENCE = np.array([29.0, 41.0, 77.0, 53.0]) * YEAR  # between main events
AFTERSHOCKS = np.array([2.0, 9.0, 26.0]) * DAY          # after each of them
HEADER = ("number,onset [s],end [s],duration [s],width [m],peak_slip [m],peak_slip_rate [m/s],"
          "moment_per_length [N],nucleation_from_upper_end [m],complete,friction_work [J/m]")


def rows():
    """Main events of 60 s, 10 km and 4e13 N, aftershocks of 5 s, 800 m and 1e10 N."""
    table = []
    for main in np.concatenate(([YEAR], YEAR + np.cumsum(RECURRENCE))):
        table.append([main, main + 60.0, 60.0, 10e3, 2.0, 1.0, 4e13, 12e3, 1, 5e9])
        table += [[main + delay, main + delay + 5.0, 5.0, 800.0, 0.1, 0.02, 1e10, 9e3, 1, 1e6]
                  for delay in AFTERSHOCKS]
    return [[number, *row] for number, row in enumerate(table, start=1)]


def write(folder: Path, header: str = HEADER) -> None:
    folder.mkdir(exist_ok=True)
    lines = [header] + [",".join(f"{float(value)!r}" for value in row) for row in rows()]
    (folder / "events.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


class Choosing(FolderCase):
    def setUp(self):
        super().setUp()
        write(self.folder)
        self.run_ = asperity.Run(self.folder)

    def median(self, run: asperity.Run) -> float:
        return float(np.median(boxes.samples(run)["recurrence"]))

    def test_all_events_count_without_a_choice(self):
        self.assertEqual(len(self.run_.events), 20)
        self.assertLess(self.median(self.run_), 27.0 * DAY)

    def test_without_small_ones_recurrence_is_that_of_the_main_events(self):
        run = self.run_.select(smallest_width=1e3)
        np.testing.assert_allclose(np.diff(run.events["onset"]), RECURRENCE)
        self.assertAlmostEqual(self.median(run) / YEAR, 47.0)
        np.testing.assert_array_equal(run.events["number"], [1, 5, 9, 13, 17])

    def test_merged_events_are_one(self):
        events = self.run_.select(merging_time=30.0 * DAY).events
        np.testing.assert_allclose(np.diff(events["onset"]), RECURRENCE)
        np.testing.assert_allclose(events["moment_per_length"], 4e13 + 3e10)
        np.testing.assert_allclose(events["friction_work"], 5e9 + 3e6)
        np.testing.assert_array_equal(events["width"], 10e3)
        np.testing.assert_array_equal(events["nucleation"], 12e3)
        np.testing.assert_allclose(events["duration"], 26.0 * DAY + 5.0)
        np.testing.assert_allclose(events["end"] - events["onset"], events["duration"])

    def test_a_pause_of_the_merging_time_separates(self):
        self.assertEqual(len(self.run_.select(merging_time=7.0 * DAY - 5.0).events), 15)
        self.assertEqual(len(self.run_.select(merging_time=7.0 * DAY - 4.0).events), 10)

    def test_earlier_events_are_left_out(self):
        """A main event counts from its onset on; a merged one has the onset of its first part."""
        second = YEAR + RECURRENCE[0]
        for start in (second, 20.0 * YEAR):
            events = self.run_.select(start=start).events
            np.testing.assert_array_equal(events["number"], np.arange(5, 21))
        run = self.run_.select(smallest_width=1e3, start=second)
        np.testing.assert_allclose(boxes.samples(run)["recurrence"], RECURRENCE[1:])
        self.assertEqual(len(self.run_.select(start=second + 1.0).events), 15)
        merged = self.run_.select(merging_time=30.0 * DAY, start=second + 1.0).events
        np.testing.assert_array_equal(merged["number"], [9, 13, 17])

    def test_again_keeps_the_choice(self):
        self.assertEqual(len(self.run_.select(smallest_width=1e3).reloaded().events), 5)

    def test_magnitudes_need_a_surface(self):
        with self.assertRaisesRegex(asperity.InputError, "no magnitudes.*smallest width"):
            len(self.run_.select(smallest_magnitude=5.0).events)

    def test_magnitudes(self):
        write(self.folder, HEADER.replace("moment_per_length [N]", "moment [N m]")
              .replace("nucleation_from_upper_end [m]", "magnitude"))
        table = self.run_.reloaded().select(merging_time=30.0 * DAY).events
        np.testing.assert_allclose(table["magnitude"], (np.log10(4e13 + 3e10) - 9.1) / 1.5)
        self.assertEqual(len(self.run_.select(smallest_magnitude=1e4).events), 5)

    def test_it_says_what_was_chosen(self):
        self.assertEqual(str(Selection(1e3, None, 60.0 * DAY)), "Events less than 60 d apart are "
                         "one, narrower than 1000 m are left out.")
        self.assertEqual(str(Selection(start=200.0 * YEAR)),
                         "Events before 200 yr are left out.")
        self.assertFalse(Selection())


class Studies(Choosing):
    def test_the_table_of_a_study_counts_what_is_chosen_and_has_moments(self):
        what = Study(Path("deck.xml"), "Grid", (Variable("a", ("F/a",), values=("1",)),))
        (self.folder / "run.log").write_text("")
        jobs = [Job(1, self.folder, [], "finished")]
        table = {name: (unit, values[0]) for name, unit, values in results.columns(
            what, jobs, what.runs(), Selection(smallest_width=1e3))}
        self.assertEqual(table["events"], ("", 5))
        self.assertAlmostEqual(table["recurrence_median"][1] / YEAR, 47.0)
        self.assertEqual(table["moment_per_length_median"], ("N", 4e13))
        self.assertNotIn("magnitude_median", table)


class Programs(FolderCase):
    """What --from leaves out of each program that tells of events."""

    FROM = ("--from", "20yr")

    def setUp(self):
        super().setUp()
        write(self.folder)
        synthetic_run.write_history(self.folder / "fault.h5", np.array([0.0, 300.0 * YEAR]),
                                    np.array([(0.0, 0.0), (0.0, -40e3)]),
                                    {"slip": np.array([[0.0, 0.0], [1.0, 1.0]]),
                                     "slip_rate": np.array([[1e-9, 1e-9], [1e-3, 1e-3]])})
        synthetic_cycle.write_parameters(self.folder / "parameters.xml")
        (self.folder / "run.log").write_text("Asperity 0.1.0 on Serial, 1 rank.\n")

    def test_of_the_table_of_plot(self):
        for arguments, first in (((), "| 1 | 1.00000 |"), (self.FROM, "| 5 | 30.0000 |")):
            _, out, _ = told(asperity_plot.cli.main, self.folder, "--events", *arguments)
            self.assertEqual("Events before 20 yr are left out." in out, bool(arguments))
            self.assertTrue(out.split("| ---: |\n")[1].startswith(first), out)

    def test_of_the_boxes(self):
        run = asperity.Run(self.folder).select(start=20.0 * YEAR)
        figure = boxes.draw(run, windows.choose(run, None))
        self.addCleanup(pyplot.close, figure)
        self.assertEqual(figure._suptitle.get_text(), "Recurrence, size and speed of 16 events")
        self.assertTrue(any("before 20 yr" in text.get_text() for text in figure.texts))

    def test_of_the_report(self):
        _, _, err = told(asperity_report.cli.main, self.folder, *self.FROM)
        self.assertEqual(err, "")
        page = (self.folder / "report.html").read_text(encoding="utf-8")
        self.assertIn("Events before 20 yr are left out.", page)
        durations = page[page.index("Duration"):]
        self.assertEqual(re.search(r"<td[^>]*>(\d+)</td>", durations)[1], "16")

    def test_of_the_study(self):
        what = Study(Path("deck.xml"), "Grid", (Variable("a", ("F/a",), values=("1",)),))
        chosen = selection.chosen(asperity_study.cli._parse(["study.xml", *self.FROM]))
        jobs = [Job(1, self.folder, [], "finished")]
        table = results.columns(what, jobs, what.runs(), chosen)
        self.assertEqual([values[0] for name, _, values in table if name == "events"], [16])

    def test_a_time_before_the_run_is_refused(self):
        with mock.patch("sys.stderr"), self.assertRaises(SystemExit):
            asperity_plot.cli._parse(["DIR", "--from", "-1"])


class Origin(unittest.TestCase):
    """Of positions along a fault whose events begin 12 km below its upper end."""

    def test_nucleation_counts_from_the_upper_end(self):
        with tempfile.TemporaryDirectory() as name:
            write(Path(name), HEADER)
            self.assertEqual(asperity.Run(name).events["nucleation"][0], 12e3)
