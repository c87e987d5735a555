"""What asperity-status says of runs that go on, were stopped, were killed, or are done."""

import contextlib
import fcntl
import io
import json
import os
import socket
import subprocess
import tempfile
import time
import unittest
from pathlib import Path

import asperity
import synthetic_log
from asperity import estimate
from asperity.log import RunLog
from asperity_status import cli

FINISHED = "\nFinished at t = 500 s after 1500 steps.\nEffort: 3 coupled steps.\n"
STOPPED = "\nStopped at t = 210 s after 630 steps.\n"
STEPS = synthetic_log.CALM_STEPS + synthetic_log.EVENT_STEPS


class Folder(unittest.TestCase):
    def setUp(self):
        self.temporary = tempfile.TemporaryDirectory()
        self.addCleanup(self.temporary.cleanup)
        self.folder = Path(self.temporary.name) / "run"

    def status(self, *options):
        """Exit status, standard output and error."""
        out, err = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(err):
            status = cli.main([str(self.folder), *options])
        return status, out.getvalue(), err.getvalue()

    def facts(self, *options):
        return json.loads(self.status("--json", *options)[1])

    def age(self, seconds):
        for path in self.folder.iterdir():
            os.utime(path, (time.time() - seconds, time.time() - seconds))


class State(Folder):
    def test_finished(self):
        synthetic_log.write(self.folder, 5 * STEPS, 5, FINISHED)
        status, out, err = self.status()
        self.assertEqual((status, err), (0, ""))
        self.assertIn("finished", out)
        self.assertNotIn("left", out)

    def test_stopped(self):
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5, STOPPED)
        status, out, _ = self.status()
        self.assertEqual(status, 4)
        self.assertIn("stopped", out)

    def test_running(self):
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5)
        status, out, _ = self.status()
        self.assertEqual(status, 10)
        self.assertIn("running", out)

    def test_restarted_after_a_stop_is_running(self):
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5, STOPPED + synthetic_log.HEADER)
        self.assertEqual(self.status()[0], 10)

    def test_silent(self):
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5)
        self.age(3960)
        status, out, _ = self.status()
        self.assertEqual(status, 6)
        self.assertIn("silent", out)
        self.assertIn("1 h 6 min", out)
        self.assertEqual(self.status("--silent-after", "2h")[0], 10)

    def test_no_run(self):
        self.folder.mkdir()
        status, out, err = self.status()
        self.assertEqual((status, out, err.count("\n")), (2, "", 1))

    def test_a_run_that_has_just_begun(self):
        self.folder.mkdir()
        (self.folder / "run.log").write_text(synthetic_log.HEADER)
        status, out, err = self.status()
        self.assertEqual((status, err), (10, ""))
        self.assertIn("no step yet", out)

    def test_a_line_of_the_log_without_its_end_is_left_out(self):
        synthetic_log.write(self.folder, 2 * STEPS, 5, "t = 230 s of 50")
        self.assertAlmostEqual(self.facts()["time"], 200.0)


class Journal(Folder):
    """What run.jsonl tells, which the program writes beside the log."""

    def write(self, *events, steps=2 * STEPS + 30, ending=STOPPED):
        synthetic_log.write(self.folder, steps, 5, ending)
        lines = [json.dumps({"step": 0, "time": 0.0, **event}) for event in events]
        (self.folder / "run.jsonl").write_text("\n".join(lines) + "\n")

    @staticmethod
    def end(how, status, message="", wall=1.0):
        return {"event": "end", "how": how, "exit_status": status, "message": message,
                "wall": wall}

    def test_a_failed_run_is_no_stopped_one(self):
        self.write({"event": "begin"}, self.end("failed", 3, "Step 7 failed. Try other steps."))
        (self.folder / "checkpoint.h5").touch()
        status, out, _ = self.status()
        self.assertEqual(status, 3)
        self.assertIn("failed: Step 7 failed. Try other steps", out)
        self.assertIn("with the same settings it fails again", out)
        facts = self.facts()
        self.assertEqual((facts["state"], facts["exit_status"]), ("failed", 3))
        self.assertEqual(facts["message"], "Step 7 failed. Try other steps.")

    def test_the_log_of_earlier_versions_tells_a_failure_too(self):
        synthetic_log.write(self.folder, 2 * STEPS, 5, STOPPED + "The run has ended: no root.\n")
        status, out, _ = self.status()
        self.assertEqual(status, 3)
        self.assertIn("failed: no root", out)

    def test_a_restart_after_a_failure_is_running(self):
        self.write({"event": "begin"}, self.end("failed", 3, "no."), {"event": "begin"},
                   ending=STOPPED + "The run has ended: no.\n" + synthetic_log.HEADER)
        self.assertEqual(self.status()[0], 10)

    def test_warnings_in_text_and_json(self):
        self.write({"event": "begin"},
                   {"event": "warning", "topic": "cohesive zone", "text": "fewer than 3 cells."},
                   {"event": "warning", "topic": "hidden growth", "text": "1 step.", "step": 5},
                   {"event": "warning", "topic": "hidden growth", "text": "10 steps.", "step": 9})
        _, out, _ = self.status()
        self.assertIn("WARNING: fewer than 3 cells.\n", out)
        self.assertIn("WARNING: 10 steps.", out)
        self.assertNotIn("1 step.", out)
        self.assertEqual([each["topic"] for each in self.facts()["warnings"]],
                         ["cohesive zone", "hidden growth"])

    def test_a_restart_takes_back_what_came_after_its_checkpoint(self):
        self.write({"event": "begin"},
                   {"event": "warning", "topic": "early", "text": "early.", "step": 5},
                   {"event": "warning", "topic": "late", "text": "late.", "step": 9},
                   {"event": "begin"}, {"event": "restart", "step": 7})
        self.assertEqual([each["topic"] for each in self.facts()["warnings"]], ["early"])

    def test_warnings_of_a_run_without_run_jsonl(self):
        synthetic_log.write(self.folder, 2 * STEPS, 5, "WARNING: too few cells.\n")
        self.assertIn("WARNING: too few cells.", self.status()[1])

    def test_a_line_without_its_end_is_left_out(self):
        self.write({"event": "begin"}, self.end("finished", 0))
        with open(self.folder / "run.jsonl", "a") as journal:
            journal.write('{"event": "warn')
        self.assertEqual(self.status()[0], 0)

    def test_wall_time_counts_to_the_end_of_each_process(self):
        """Also where the last line of progress was long before it."""
        self.write({"event": "begin"}, self.end("stopped", 4, wall=5000.0), {"event": "begin"},
                   self.end("finished", 0, wall=45.0), ending=STOPPED + synthetic_log.HEADER)
        self.assertAlmostEqual(self.facts()["wall"], 5045.0)


class Lock(Folder):
    """The lock that a process leaves behind if it is killed."""

    def leave_lock(self, process, host=socket.gethostname()):
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5)
        (self.folder / ".lock").write_text(f"process {process} on {host}\n")

    @staticmethod
    def ended_process():
        process = subprocess.Popen(["true"])
        process.wait()
        return process.pid

    def test_killed(self):
        self.leave_lock(self.ended_process())
        status, out, _ = self.status()
        self.assertEqual(status, 6)
        self.assertIn("killed: its process is gone; there is no checkpoint of it", out)

    def test_of_a_process_that_is_there(self):
        self.leave_lock(os.getpid())
        self.assertEqual(self.status()[0], 10)

    def test_held_from_another_process_namespace(self):
        self.leave_lock(self.ended_process())
        with open(self.folder / ".lock") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            self.assertEqual(self.status()[0], 10)

    def test_of_another_machine(self):
        self.leave_lock(self.ended_process(), "another-machine")
        self.assertEqual(self.status()[0], 10)


class Facts(Folder):
    def test_where_the_run_is(self):
        times = synthetic_log.write(self.folder, 2 * STEPS + 30, 5)
        facts = self.facts()
        self.assertEqual(facts["state"], "running")
        self.assertEqual(facts["step"], 2 * STEPS + 30)
        self.assertAlmostEqual(facts["time"], times[2 * STEPS + 29])
        self.assertEqual(facts["final_time"], 500.0)
        self.assertEqual(facts["events"], 2)
        self.assertAlmostEqual(facts["wall"], (2 * STEPS + 30) * 2.0, delta=5.0)

    def test_time_goes_on_after_the_last_line(self):
        synthetic_log.write(self.folder, 3 * STEPS, 5)
        first = self.facts()
        self.age(100)
        later = self.facts()
        self.assertAlmostEqual(later["wall"] - first["wall"], 100.0, delta=5.0)
        self.assertAlmostEqual(first["seconds_left"] - later["seconds_left"], 100.0, delta=5.0)
        self.assertAlmostEqual(first["seconds_left"], 2 * synthetic_log.cycle_wall(), delta=60.0)

    def test_the_log_is_ahead_of_the_tables(self):
        synthetic_log.write(self.folder, 2 * STEPS + 45, 5, flushed=100)
        facts = self.facts()
        self.assertEqual(facts["step"], 2 * STEPS + 45)
        self.assertEqual(facts["events"], 2)

    def test_recent_speed(self):
        synthetic_log.write(self.folder, 2 * STEPS + 45, 5)
        facts = self.facts()
        per_second = (synthetic_log.CYCLE - synthetic_log.EVENT) / synthetic_log.CALM_STEPS / 2.0
        self.assertAlmostEqual(facts["steps_per_minute"], 30.0, places=3)
        # the last two minutes reach back 60 steps, 15 of them in the event
        self.assertGreater(facts["speed"], 0.7 * per_second)
        self.assertLessEqual(facts["speed"], 1.01 * per_second)

    def test_energy_balance_and_worst_step(self):
        synthetic_log.write(self.folder, 2 * STEPS, 5)
        facts = self.facts()
        self.assertAlmostEqual(facts["relative_energy_defect"], -5e-10)
        self.assertEqual(facts["worst_step"]["step"], 77)
        self.assertEqual(facts["worst_step"]["fixed_point_iterations"], 9)
        self.assertEqual(facts["failed_steps"], 1)
        _, out, _ = self.status()
        self.assertIn("step 77", out)

    def test_follow_ends_with_the_run(self):
        synthetic_log.write(self.folder, 5 * STEPS, 5, FINISHED)
        status, out, _ = self.status("--follow", "--every", "0.01s")
        self.assertEqual(status, 0)
        self.assertEqual(out.count("finished"), 1)


class TimeLeft(Folder):
    """The program knows nothing but the files; the truth is what the run will take."""

    def left(self, steps, cycles, **options):
        synthetic_log.write(self.folder, steps, cycles, **options)
        run = asperity.Run(self.folder)
        return estimate.time_left(run, RunLog.read(self.folder / "run.log"))

    def test_follows_the_cost_of_cycles_in_every_phase(self):
        cycles = 8
        for steps in range(3 * STEPS, cycles * STEPS, 75):
            with self.subTest(steps=steps):
                left = self.left(steps, cycles)
                truth = (cycles * STEPS - steps) * synthetic_log.WALL_PER_STEP
                self.assertTrue(left.knows_cycles)
                self.assertLess(abs(left.seconds - truth), 0.1 * synthetic_log.cycle_wall())

    def test_follows_it_from_the_log_where_tables_are_old(self):
        steps, cycles = 5 * STEPS + 30, 8
        left = self.left(steps, cycles, flushed=2 * STEPS)
        truth = (cycles * STEPS - steps) * synthetic_log.WALL_PER_STEP
        self.assertTrue(left.knows_cycles)
        self.assertLess(abs(left.seconds - truth), 0.1 * synthetic_log.cycle_wall())

    def test_takes_aftershocks_for_parts_of_their_cycle(self):
        cycles = 8
        self.assertFalse(self.left(2 * STEPS - 250, cycles, aftershocks=True).knows_cycles)
        for steps in (3 * STEPS, 5 * STEPS + 40, 6 * STEPS - 100):
            with self.subTest(steps=steps):
                left = self.left(steps, cycles, aftershocks=True)
                truth = (cycles * STEPS - steps) * synthetic_log.WALL_PER_STEP
                self.assertTrue(left.knows_cycles)
                self.assertLess(abs(left.seconds - truth), 0.1 * synthetic_log.cycle_wall())

    def test_says_that_it_knows_no_cycle(self):
        left = self.left(45, 8)
        self.assertFalse(left.knows_cycles)
        speed = (synthetic_log.CYCLE - synthetic_log.EVENT) / synthetic_log.CALM_STEPS / 2.0
        remaining = 8 * synthetic_log.CYCLE - 45 * 2.0 * speed
        self.assertAlmostEqual(left.seconds, remaining / speed, delta=0.1 * remaining / speed)
        self.assertIn("at this speed", self.status()[1])

    def test_knows_no_speed_without_a_line_of_progress(self):
        self.folder.mkdir()
        (self.folder / "run.log").write_text(synthetic_log.HEADER)
        log = RunLog.read(self.folder / "run.log")
        self.assertIsNone(estimate.time_left(asperity.Run(self.folder), log))

    def test_a_restart_adds_its_wall_time(self):
        synthetic_log.write(self.folder, 3 * STEPS, 8, STOPPED)
        first = (self.folder / "run.log").read_text()
        synthetic_log.write(self.folder, 6 * STEPS, 8)
        second = []
        for line in (self.folder / "run.log").read_text().splitlines():
            if "step " in line:
                step = int(line.split("step ")[1].split(",")[0])
                if step <= 3 * STEPS:
                    continue
                line = line.replace(f"wall {step * 2:g} s", f"wall {(step - 3 * STEPS) * 2:g} s")
            second.append(line)
        (self.folder / "run.log").write_text(first + "\n".join(second) + "\n")
        log = RunLog.read(self.folder / "run.log")
        self.assertAlmostEqual(log.wall, 6 * STEPS * 2.0)
        left = estimate.time_left(asperity.Run(self.folder), log)
        self.assertLess(abs(left.seconds - 2 * synthetic_log.cycle_wall()),
                        0.1 * synthetic_log.cycle_wall())


if __name__ == "__main__":
    unittest.main()
