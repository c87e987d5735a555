"""What asperity-status says of runs that go on, were stopped, were killed, or are done."""

import fcntl
import json
import os
import socket
import subprocess
import time

import synthetic_log
from asperity_status import cli
from folders import FolderCase, told

FINISHED = "\nFinished at t = 500 s after 1500 steps.\nEffort: 3 coupled steps.\n"
STOPPED = "\nStopped at t = 210 s after 630 steps.\n"
STEPS = synthetic_log.CALM_STEPS + synthetic_log.EVENT_STEPS


class Folder(FolderCase):
    def setUp(self):
        super().setUp()
        self.folder /= "run"

    def status(self, *options):
        """Exit status, standard output and error."""
        return told(cli.main, self.folder, *options)

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

    def test_finished_before_the_final_time(self):
        """By the number of its events, as run.log says."""
        synthetic_log.write(self.folder, 3 * STEPS, 5, FINISHED)
        status, out, _ = self.status()
        self.assertEqual(status, 0)
        self.assertIn("before the final time", out)
        self.assertIn("'Event Catalogue / Most Events' allows", out)
        self.assertNotIn("%", out.splitlines()[1])

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

    def test_a_run_whose_table_has_no_line_yet(self):
        synthetic_log.write(self.folder, 45, 5)
        (self.folder / "steps.csv").write_text("")
        self.assertEqual((self.facts()["state"], self.facts()["step"]), ("running", 45))


class Journal(Folder):
    """What run.jsonl tells, which the program writes beside the log."""

    def write(self, *events, steps=2 * STEPS + 30, ending=STOPPED):
        synthetic_log.write(self.folder, steps, 5, ending)
        lines = [json.dumps({"step": 0, "time": 0.0, **event}) for event in events]
        (self.folder / "run.jsonl").write_text("\n".join(lines) + "\n")

    @staticmethod
    def end(how, status, message="", wall_time=1.0, **more):
        return {"event": "end", "how": how, "exit_status": status, "message": message,
                "wall_time": wall_time, **more}

    def test_a_failed_run_is_no_stopped_one(self):
        self.write({"event": "begin"}, self.end("failed", 3, "Step 7 failed. Try other steps."))
        (self.folder / "checkpoint.h5").touch()
        status, out, _ = self.status()
        self.assertEqual(status, 3)
        self.assertIn("failed: Step 7 failed. Try other steps", out)
        self.assertIn("continues it, but as it is, it fails there again: change what the message "
                      "names; `TNNMG`, `Coupling` and in `Time Stepping` the tolerance and the "
                      "smallest step may change", out)
        self.assertIn("--restart-from", out)
        facts = self.facts()
        self.assertEqual((facts["state"], facts["exit_status"]), ("failed", 3))
        self.assertEqual(facts["message"], "Step 7 failed. Try other steps.")

    def test_the_kind_of_a_failure_tells_whether_a_restart_makes_sense(self):
        advice = "Choose a smaller one, or begin a new run."
        for kind, restarts in (("useless_run", False), ("input", False), ("solve", True)):
            for message in (advice, "Step 7 failed."):
                self.write({"event": "begin"}, self.end("failed", 3, message, kind=kind))
                (self.folder / "checkpoint.h5").touch()
                out = self.status()[1]
                self.assertEqual("continues it" in out, restarts, (kind, message))
                self.assertEqual("--restart-from" in out, kind != "useless_run")
                self.assertEqual(self.facts()["kind"], kind)

    def test_the_log_tells_a_failure_too(self):
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
        (self.folder / "run.jsonl").unlink()
        self.assertIn("WARNING: too few cells.", self.status()[1])

    def test_a_line_without_its_end_is_left_out(self):
        self.write({"event": "begin"}, self.end("finished", 0))
        with open(self.folder / "run.jsonl", "a") as journal:
            journal.write('{"event": "warn')
        self.assertEqual(self.status()[0], 0)

    def test_wall_time_counts_to_the_end_of_each_process(self):
        """Also where the last line of progress was long before it."""
        self.write({"event": "begin"}, self.end("stopped", 4, wall_time=5000.0),
                   {"event": "begin"}, self.end("finished", 0, wall_time=5045.0))
        self.assertEqual(self.facts()["wall"], 5045.0)

    def test_a_restart_takes_back_the_progress_after_its_checkpoint(self):
        progress = {"event": "progress", "peak_slip_rate": 1e-9}
        self.write({"event": "begin"}, {**progress, "step": 60, "time": 1.0, "wall_time": 100.0},
                   {**progress, "step": 120, "time": 9.0, "wall_time": 160.0}, {"event": "begin"},
                   {"event": "restart", "step": 90},
                   {**progress, "step": 120, "time": 9.0, "wall_time": 200.0},
                   steps=50, ending="")
        facts = self.facts()
        self.assertEqual((facts["step"], facts["time"]), (120, 9.0))
        self.assertAlmostEqual(facts["wall"], 200.0, delta=5.0)
        self.assertAlmostEqual(facts["speed"], 0.08)
        self.assertAlmostEqual(facts["steps_per_minute"], 36.0)


class Damaged(Folder):
    """After a full disk tables are empty or cut: the journal decides, tables add."""

    MESSAGE = "run/steps.csv cannot be written: No space left on device. Is the disk full?"

    def setUp(self):
        super().setUp()
        synthetic_log.write(self.folder, 2 * STEPS + 30, 5)
        end = {"event": "end", "step": 630, "time": 209.0, "how": "failed", "exit_status": 5,
               "message": self.MESSAGE, "wall_time": 9.0, "kind": "output"}
        with open(self.folder / "run.jsonl", "a", encoding="utf-8") as journal:
            journal.write(json.dumps(end) + "\n")

    def damage(self, name, text):
        path = self.folder / name
        path.write_text(text(path.read_text()))

    def assert_failed(self, damaged="", events=2):
        status, out, err = self.status()
        self.assertEqual((status, err), (3, ""))
        self.assertIn("failed: " + self.MESSAGE.rstrip("."), out)
        facts = self.facts()
        self.assertEqual((facts["step"], facts["exit_status"], facts["events"]), (630, 5, events))
        self.assertEqual(len(facts["damaged"]), 1 if damaged else 0)
        for text in facts["damaged"]:
            self.assertIn(damaged, text)
            self.assertIn(text, out)

    def test_an_empty_table(self):
        for name in ("events.csv", "steps.csv"):
            self.damage(name, lambda text: "")
            self.assert_failed()

    def test_names_without_their_end(self):
        for name in ("events.csv", "steps.csv"):
            self.damage(name, lambda text: text[:9])
            self.assert_failed()

    def test_half_a_last_line(self):
        for name in ("events.csv", "steps.csv"):
            self.damage(name, lambda text: text[:-7])
        self.assert_failed()

    def test_a_row_of_nothing(self):
        self.damage("events.csv", lambda text: text + "\0\0\0,\n")
        self.assert_failed("events.csv is damaged")

    def test_a_missing_column(self):
        self.damage("steps.csv", lambda text: text.replace("peak_slip_rate", "peak"))
        self.assert_failed("no column 'peak_slip_rate'")

    def test_parameters_cut_off(self):
        self.damage("parameters.xml", lambda text: text[:40])
        self.assert_failed("parameters.xml cannot be read as XML")


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

    def test_the_journal_is_ahead_of_the_tables(self):
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

    def test_says_whether_the_time_left_is_of_past_cycles(self):
        for steps, words in ((45, "at this speed"), (3 * STEPS, "by the cost of past cycles")):
            synthetic_log.write(self.folder, steps, 5)
            self.assertIn(words, self.status()[1])

    def test_follow_ends_with_the_run(self):
        synthetic_log.write(self.folder, 5 * STEPS, 5, FINISHED)
        status, out, _ = self.status("--follow", "--every", "0.01s")
        self.assertEqual(status, 0)
        self.assertEqual(out.count("finished"), 1)
