"""A run that is stopped, killed or continued ends with the very bytes of one that was not."""

import pathlib
import shutil
import signal
import subprocess
import sys
import time
import unittest

import numpy

import asperity_run
import time_limits

sys.path.insert(0, str(pathlib.Path(__file__).parents[1] / "reliability"))
import runs  # noqa: E402  (its folder comes first)
from runs import STOPPED, fresh, settings  # noqa: E402

# Some 550 steps, three events, about two seconds.
RUN = [*runs.RUN, *settings("Time Stepping/Final Time=20", "Output/Checkpoint Every n Steps=40")]
# Some 80 steps with the multigrid correction.
SHORT_RUN = [*runs.SHORT_RUN, *settings("Time Stepping/Final Time=5")]

# TPV101 with cells of 800 m on the fault.
RUPTURE = [asperity_run.SOURCE / "xml" / "tpv101_2d.xml", *settings(
    "Mesh/Rectangle/Cell Size Factor=8", "Time Stepping/Final Time=3",
    "Output/SCEC/Date=2024/05/31", "Output/Checkpoint Every n Steps=40")]

# A body in equilibrium, condensed to its fault, with a receiver at a distance along it.
CONDENSED = [asperity_run.SOURCE / "tests" / "verification" / "back_slip" / "strip.xml", *settings(
    "Boundary Conditions/Fault/Plate Rate=1e-4", "Time Stepping/Final Time=40",
    "Output/Receivers/On Fault/near={0.2}", "Output/Checkpoint Every n Steps=40")]


class Restarting(unittest.TestCase):
    """Stops runs, lets them go on and compares what they leave."""

    def start(self, folder, *arguments, deck=None):
        """A run in the background, once its first checkpoint of its own is on disk."""
        checkpoint = folder / "checkpoint.h5"
        before = checkpoint.stat().st_ino if checkpoint.exists() else None
        process = subprocess.Popen(
            asperity_run.command(*(deck or RUN), "--output", folder, *arguments),
            stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        end = time.monotonic() + time_limits.seconds(60)
        while not checkpoint.exists() or checkpoint.stat().st_ino == before:
            if process.poll() is not None or time.monotonic() > end:
                process.kill()
                self.fail(f"no checkpoint: {process.communicate()[1]}")
            time.sleep(0.002)
        return process

    def stop(self, process, number):
        process.send_signal(number)
        _, errors = process.communicate(timeout=time_limits.seconds(60))
        self.assertEqual(errors, "")
        self.assertEqual(process.returncode, STOPPED if number == signal.SIGTERM else -number)

    def finish(self, folder, deck=None):
        result = asperity_run.run(*(deck or RUN), "--restart", folder / "checkpoint.h5",
                                  "--output", folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))

    def assert_same_series(self, whole, folder, *names):
        for name in names:
            ours, theirs = asperity_run.series(whole / name), asperity_run.series(folder / name)
            self.assertEqual(set(ours), set(theirs))
            for dataset, values in ours.items():
                numpy.testing.assert_array_equal(values, theirs[dataset], f"{name}: {dataset}")

    def assert_same_bytes(self, whole, folder, *names):
        for name in names:
            self.assertEqual(asperity_run.content(whole / name),
                             asperity_run.content(folder / name), name)


class Restart(Restarting):
    @classmethod
    def setUpClass(cls):
        cls.whole = asperity_run.run_to_end("whole", *RUN)

    def assert_same_results(self, folder, whole=None):
        whole = whole or self.whole
        self.assert_same_series(whole, folder, "fault.h5", "surface.h5")
        self.assert_same_bytes(whole, folder, "steps.csv", "events.csv")

    def test_the_run_is_worth_the_trouble(self):
        steps = asperity_run.table(self.whole / "steps.csv")
        self.assertGreater(len(steps), 400)
        self.assertGreater(len({row["step_size"] for row in steps}), 5)
        self.assertGreaterEqual(len(asperity_run.table(self.whole / "events.csv")), 3)

    def test_stopped_once(self):
        folder = fresh("stopped_once")
        self.stop(self.start(folder), signal.SIGTERM)
        steps = asperity_run.table(folder / "steps.csv")
        self.assertLess(len(steps), len(asperity_run.table(self.whole / "steps.csv")))
        # the directory alone says what is to go on
        result = asperity_run.run("--restart", folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assert_same_results(folder)
        self.assertIn("Restarted from", (folder / "run.log").read_text())
        # the wall time goes on
        wall = [row["wall_time"] for row in asperity_run.table(folder / "steps.csv")]
        self.assertEqual(wall[:len(steps)], [row["wall_time"] for row in steps])
        self.assertEqual(wall, sorted(wall))

    def test_stopped_in_an_event(self):
        """What has happened of it has its row, and a restart takes that back."""
        always = [*RUN, *settings("Output/Event Catalogue/Threshold=1e-30")]
        whole = asperity_run.run_to_end("one_event", *always)
        folder = fresh("stopped_in_an_event")
        self.stop(self.start(folder, deck=always), signal.SIGTERM)
        row, = asperity_run.table(folder / "events.csv")
        self.assertEqual(row["complete"], 0)
        self.assertEqual(row["end"], asperity_run.table(folder / "steps.csv")[-1]["time"])
        self.finish(folder, deck=always)
        self.assert_same_results(folder, whole)

    def test_stopped_twice(self):
        folder = fresh("stopped_twice")
        self.stop(self.start(folder), signal.SIGTERM)
        restart = ("--restart", folder / "checkpoint.h5")
        self.stop(self.start(folder, *restart), signal.SIGTERM)
        self.finish(folder)
        self.assert_same_results(folder)

    def test_killed(self):
        folder = fresh("killed")
        process = self.start(folder)
        time.sleep(0.03)  # well into the steps that no checkpoint has
        self.stop(process, signal.SIGKILL)
        self.finish(folder)
        self.assert_same_results(folder)

    def test_killed_twice_from_the_same_checkpoint(self):
        folder = fresh("killed_twice")
        self.stop(self.start(folder), signal.SIGKILL)
        kept = folder / "kept.h5"
        shutil.copy(folder / "checkpoint.h5", kept)
        self.stop(self.start(folder, "--restart", kept), signal.SIGKILL)
        result = asperity_run.run(*RUN, "--restart", kept, "--output", folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        self.assert_same_results(folder)

    def test_restarted_from_the_completed_parameters(self):
        folder = fresh("completed_parameters")
        self.stop(self.start(folder), signal.SIGTERM)
        self.finish(folder, deck=[folder / "parameters.xml"])
        self.assert_same_results(folder)

    def test_with_multigrid(self):
        whole = asperity_run.run_to_end("multigrid_whole", *SHORT_RUN)
        folder = fresh("multigrid")
        self.stop(self.start(folder, deck=SHORT_RUN), signal.SIGTERM)
        self.finish(folder, deck=SHORT_RUN)
        self.assert_same_results(folder, whole)

    def test_continued_beyond_its_end(self):
        """As if the end had been an instant: the last steps have met it."""
        run = [*RUN, *settings("Time Stepping/Instants={6}")]
        whole = asperity_run.run_to_end("with_instant", *run)
        folder = asperity_run.run_to_end("continued", *run,
                                         *settings("Time Stepping/Final Time=6"))
        self.finish(folder, deck=run)
        for name in ("steps.csv", "events.csv"):
            self.assertEqual(asperity_run.content(whole / name),
                             asperity_run.content(folder / name))

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
            self.assertEqual((folder / "steps.csv").read_bytes(), steps)

    def test_refuses_another_deck(self):
        folder = fresh("other_deck")
        self.stop(self.start(folder), signal.SIGTERM)
        before = asperity_run.checksums(folder)
        for change in ("Friction/L=25.000001e-6", "Mesh/Wedge/Cell Size=0.012",
                       "Time Stepping/Largest Step=2"):
            result = asperity_run.run(*RUN, *settings(change), "--restart",
                                      folder / "checkpoint.h5", "--output", folder)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr, r"^asperity: .*checkpoint\.h5 belongs to another deck")
            self.assertEqual(result.stderr.count("\n"), 1)
            self.assertEqual(asperity_run.checksums(folder), before)
        self.finish(folder)
        self.assert_same_results(folder)


class RestartOfARupture(Restarting):
    """A rupture under a stress that varies in time: generalised alpha, Richardson's control, an
    antisymmetric fault, receivers, and files for a platform."""

    def test_stopped_and_killed(self):
        whole = asperity_run.run_to_end("rupture_whole", *RUPTURE)
        steps = asperity_run.table(whole / "steps.csv")
        self.assertGreater(len(steps), 300)
        self.assertGreater(max(row["peak_slip_rate"] for row in steps), 1)
        folder = fresh("rupture")
        self.stop(self.start(folder, deck=RUPTURE), signal.SIGTERM)
        restart = ("--restart", folder / "checkpoint.h5")
        self.stop(self.start(folder, *restart, deck=RUPTURE), signal.SIGKILL)
        self.finish(folder, deck=RUPTURE)
        self.assert_same_series(whole, folder, "fault.h5", "receivers.h5", "rupture.h5")
        texts = sorted(path.relative_to(whole) for path in whole.glob("scec/*"))
        self.assertEqual(len(texts), 8)  # seven receivers, rupture times
        self.assert_same_bytes(whole, folder, "steps.csv", "events.csv", "global.csv", *texts)

    def test_refusals_leave_the_log_and_the_parameters(self):
        folder = fresh("rupture_refused")
        self.stop(self.start(folder, deck=RUPTURE), signal.SIGTERM)
        kept = [(folder / name).read_bytes() for name in ("run.log", "parameters.xml")]
        for change, message in (
                ("Output/Text Format=SEAS", "Restart with the Text Format of the earlier run"),
                ("Output/SCEC/Time Step=0.02", "`SCEC / Time Step`"),
                ("Output/SCEC/Author=nobody of that name", "# author=nobody of that name")):
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
        folder = fresh("condensed_stopped")
        self.stop(self.start(folder, deck=CONDENSED), signal.SIGTERM)
        self.finish(folder, deck=CONDENSED)
        self.assert_same_series(whole, folder, "fault.h5", "receivers.h5")
        self.assert_same_bytes(whole, folder, "steps.csv")


if __name__ == "__main__":
    unittest.main()
