"""Runs that go on, or were killed: what is whole is read, and nothing that is half written."""

import h5py
import numpy as np

import asperity
import synthetic_run
from folders import FolderCase


class Unfinished(FolderCase):
    def setUp(self):
        super().setUp()
        synthetic_run.write_run(self.folder, 3, nodes=20)

    def test_a_row_without_its_end_is_left_out(self):
        path = self.folder / "steps.csv"
        whole = asperity.Run(self.folder).steps
        text = path.read_text()
        for kept in (len(text) - 1, len(text) - 5, len(text) - 60):
            path.write_text(text[:kept])
            steps = asperity.Run(self.folder).steps
            self.assertEqual(len(steps), text[:kept].count("\n") - 1)
            np.testing.assert_array_equal(steps["time"], whole["time"][:len(steps)])

    def test_a_header_without_its_end_is_no_table_yet(self):
        (self.folder / "steps.csv").write_text("step,time [s],step_si")
        with self.assertRaisesRegex(asperity.InputError, "not complete"):
            asperity.Run(self.folder).steps

    def test_a_damaged_row_is_still_an_error(self):
        with open(self.folder / "steps.csv", "a", encoding="utf-8") as file:
            file.write("17,not a number\n")
        with self.assertRaisesRegex(asperity.InputError, "damaged"):
            asperity.Run(self.folder).steps

    def test_no_event_yet(self):
        path = self.folder / "events.csv"
        path.write_text(path.read_text().splitlines()[0] + "\n")
        self.assertEqual(asperity.Run(self.folder).events["onset"].size, 0)

    def test_before_the_first_checkpoint(self):
        for path in self.folder.glob("*.h5"):
            path.unlink()
        run = asperity.Run(self.folder)
        self.assertGreater(len(run.steps), 10)
        with self.assertRaisesRegex(asperity.InputError, "fault.h5 does not exist.*checkpoint"):
            run.fault

    def test_a_run_with_nothing_but_its_log(self):
        for path in self.folder.iterdir():
            if path.is_file():
                path.unlink()
        (self.folder / "run.log").write_text("Asperity\n")
        self.assertFalse(asperity.Run(self.folder).has("steps.csv"))

    def test_reading_again_shows_what_was_added(self):
        run = asperity.Run(self.folder)
        before = len(run.steps)
        with open(self.folder / "steps.csv", "a", encoding="utf-8") as file:
            file.write((self.folder / "steps.csv").read_text().splitlines()[-1] + "\n")
        self.assertEqual(len(run.steps), before)
        self.assertEqual(len(run.reloaded().steps), before + 1)

    def test_a_rewritten_history_is_left_as_it_was_opened(self):
        run = asperity.Run(self.folder)
        rows = run.fault.time.size
        other = self.folder / "new.h5"
        with h5py.File(other, "w") as file:
            file["time"] = np.arange(2.0)
        other.replace(self.folder / "fault.h5")
        self.assertEqual(run.fault["slip"].shape[0], rows)
        self.assertEqual(run.reloaded().fault.time.size, 2)
