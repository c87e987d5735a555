"""A run that is stopped, killed or continued ends with the very bytes of one that was not."""

import shutil
import signal
import time
import unittest

import asperity_run
import runs
from asperity_run import go_on, settings
from comparisons import assert_same_results

# Some 550 steps, three events, about two seconds.
RUN = [*runs.RUN, *settings("Time Stepping/Final Time=20", "Output/Checkpoint Every n Steps=40")]
# Some 80 steps with the multigrid correction.
SHORT_RUN = [*runs.SHORT_RUN, *settings("Time Stepping/Final Time=5")]

# TPV101 with cells of 800 m on the fault.
RUPTURE = [asperity_run.SOURCE / "xml" / "tpv101_2d.xml", *settings(
    "Mesh/Rectangle/Cell Size Factor=8", "Time Stepping/Final Time=3",
    "Output/Checkpoint Every n Steps=40")]

# A body in equilibrium, condensed to its fault, with a receiver at a distance along it.
CONDENSED = [asperity_run.SOURCE / "tests" / "verification" / "back_slip" / "strip.xml", *settings(
    "Boundary Conditions/Fault/Plate Rate=1e-4", "Time Stepping/Final Time=40",
    "Output/Receivers/On Fault/near={0.2}", "Output/Checkpoint Every n Steps=40")]


class Restarting(unittest.TestCase):
    def stopped(self, name, deck=RUN, number=signal.SIGTERM):
        """The folder of a run that a signal ended after its first checkpoint."""
        folder = runs.fresh(name)
        runs.stop(self, runs.begin(folder, *deck), number)
        return folder


class Restart(Restarting):
    @classmethod
    def setUpClass(cls):
        cls.whole = asperity_run.run_to_end("whole", *RUN)

    def test_the_run_is_worth_the_trouble(self):
        steps = asperity_run.table(self.whole / "steps.csv")
        self.assertGreater(len(steps), 400)
        self.assertGreater(len({row["step_size"] for row in steps}), 5)
        self.assertGreaterEqual(len(asperity_run.table(self.whole / "events.csv")), 3)

    def test_stopped_once(self):
        folder = self.stopped("stopped_once")
        steps = asperity_run.table(folder / "steps.csv")
        self.assertLess(len(steps), len(asperity_run.table(self.whole / "steps.csv")))
        # the directory alone says what is to go on
        result = asperity_run.run("--restart", folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        assert_same_results(self.whole, folder)
        self.assertIn("Restarted from", (folder / "run.log").read_text())
        # the wall time goes on
        wall = [row["wall_time"] for row in asperity_run.table(folder / "steps.csv")]
        self.assertEqual(wall[:len(steps)], [row["wall_time"] for row in steps])
        self.assertEqual(wall, sorted(wall))

    def test_stopped_in_an_event(self):
        """What has happened of it has its row, and a restart takes that back."""
        always = [*RUN, *settings("Output/Event Catalogue/Threshold=1e-30")]
        whole = asperity_run.run_to_end("one_event", *always)
        folder = self.stopped("stopped_in_an_event", always)
        row, = asperity_run.table(folder / "events.csv")
        self.assertEqual(row["complete"], 0)
        self.assertEqual(row["end"], asperity_run.table(folder / "steps.csv")[-1]["time"])
        go_on(folder, *always)
        assert_same_results(whole, folder)

    def test_stopped_twice(self):
        folder = self.stopped("stopped_twice")
        runs.stop(self, runs.begin(folder, *RUN, "--restart", folder / "checkpoint.h5"))
        go_on(folder, *RUN)
        assert_same_results(self.whole, folder)

    def test_killed(self):
        folder = runs.fresh("killed")
        process = runs.begin(folder, *RUN)
        time.sleep(0.03)  # well into the steps that no checkpoint has
        runs.stop(self, process, signal.SIGKILL)
        go_on(folder, *RUN)
        assert_same_results(self.whole, folder)

    def test_killed_twice_from_the_same_checkpoint(self):
        folder = self.stopped("killed_twice", number=signal.SIGKILL)
        kept = folder / "kept.h5"
        shutil.copy(folder / "checkpoint.h5", kept)
        runs.stop(self, runs.begin(folder, *RUN, "--restart", kept), signal.SIGKILL)
        go_on(folder, *RUN, checkpoint=kept)
        assert_same_results(self.whole, folder)

    def test_restarted_from_the_completed_parameters(self):
        folder = self.stopped("completed_parameters")
        go_on(folder, folder / "parameters.xml")
        assert_same_results(self.whole, folder)

    def test_with_multigrid(self):
        whole = asperity_run.run_to_end("multigrid_whole", *SHORT_RUN)
        folder = self.stopped("multigrid", SHORT_RUN)
        go_on(folder, *SHORT_RUN)
        assert_same_results(whole, folder)

    def test_continued_beyond_its_end(self):
        """As if the end had been an instant: the last steps have met it."""
        run = [*RUN, *settings("Time Stepping/Instants={6}")]
        whole = asperity_run.run_to_end("with_instant", *run)
        folder = asperity_run.run_to_end("continued", *run,
                                         *settings("Time Stepping/Final Time=6"))
        go_on(folder, *run)
        assert_same_results(whole, folder, series=())

    def test_to_an_end_that_has_passed(self):
        folder = asperity_run.run_to_end("at_its_end", *SHORT_RUN)
        steps = (folder / "steps.csv").read_bytes()
        self.assertNotIn("nothing to do", (folder / "run.log").read_text())
        for end, with_parts in (("5", ()), ("4.5", settings("Time Stepping/Final Time=4.5"))):
            result = asperity_run.run(*SHORT_RUN, *with_parts, "--restart",
                                      folder / "checkpoint.h5", "--output", folder)
            self.assertEqual((result.returncode, result.stderr), (0, ""))
            for text in (result.stdout, (folder / "run.log").read_text()):
                self.assertIn(f"The final time, {end} s, has passed: there is nothing to do. Give "
                              "a later 'Time Stepping / Final Time' to go on.", text)
                self.assertEqual("beyond 'Time Stepping / Final Time' = 4.5 s: the state of "
                                 f"{folder / 'checkpoint.h5'} is that at t = 5 s" in text,
                                 end == "4.5")
            self.assertEqual((folder / "steps.csv").read_bytes(), steps)

    def test_refuses_another_deck(self):
        folder = self.stopped("other_deck")
        before = asperity_run.checksums(folder)
        for change in ("Friction/L=25.000001e-6", "Mesh/Wedge/Cell Size=0.012",
                       "Time Stepping/Largest Step=2"):
            result = asperity_run.run(*RUN, *settings(change), "--restart",
                                      folder / "checkpoint.h5", "--output", folder)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"^asperity: .*checkpoint\.h5 belongs to another deck")
            self.assertEqual(result.stderr.count("\n"), 1)
            self.assertEqual(asperity_run.checksums(folder), before)
        go_on(folder, *RUN)
        assert_same_results(self.whole, folder)


class RestartOfARupture(Restarting):
    """A rupture under a stress that varies in time: generalised alpha, Richardson's control, an
    antisymmetric fault, and receivers."""

    def test_stopped_and_killed(self):
        whole = asperity_run.run_to_end("rupture_whole", *RUPTURE)
        steps = asperity_run.table(whole / "steps.csv")
        self.assertGreater(len(steps), 300)
        self.assertGreater(max(row["peak_slip_rate"] for row in steps), 1)
        folder = self.stopped("rupture", RUPTURE)
        restarted = runs.begin(folder, *RUPTURE, "--restart", folder / "checkpoint.h5")
        runs.stop(self, restarted, signal.SIGKILL)
        go_on(folder, *RUPTURE)
        assert_same_results(whole, folder, ["fault.h5", "receivers.h5", "rupture.h5"],
                            ["steps.csv", "events.csv", "global.csv"])

    def test_refusals_leave_the_log_and_the_parameters(self):
        folder = self.stopped("rupture_refused", RUPTURE)
        kept = [(folder / name).read_bytes() for name in ("run.log", "parameters.xml")]
        for change, message in (
                ("Output/Receivers/Fault Fields={slip}", "with other receivers or fields"),
                ("Output/Step Table/Quantities={tnnmg_iterations}", "its header is '")):
            result = asperity_run.run(*RUPTURE, *settings(change), "--restart",
                                      folder / "checkpoint.h5", "--output", folder)
            self.assertEqual(result.returncode, 2)
            self.assertIn(message, result.stderr)
            for name, before in zip(("run.log", "parameters.xml"), kept):
                self.assertEqual((folder / name).read_bytes(), before, change)


class CondensedRestart(Restarting):
    def test_condensed_to_the_fault(self):
        whole = asperity_run.run_to_end("condensed", *CONDENSED)
        self.assertIn("condensed to its fault", (whole / "run.log").read_text())
        folder = self.stopped("condensed_stopped", CONDENSED)
        go_on(folder, *CONDENSED)
        assert_same_results(whole, folder, ["fault.h5", "receivers.h5"], ["steps.csv"])


if __name__ == "__main__":
    unittest.main()
