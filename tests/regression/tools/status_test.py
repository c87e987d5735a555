"""asperity-status beside a run: while it runs, followed to its end, killed, stopped, finished."""

import json
import pathlib
import shutil
import signal
import subprocess
import time
import unittest

import asperity_run
import time_limits

STATUS = asperity_run.PROGRAM.with_name("asperity-status")
DECK = asperity_run.SOURCE / "xml" / "wedge_2d.xml"
LONG = ["--set", "Time Stepping/Final Time=1e6"]
PATIENCE = time_limits.seconds(60)  # [s]


def status(folder, *options):
    """Exit status and facts."""
    result = subprocess.run([str(STATUS), str(folder), "--json", *options], text=True,
                            capture_output=True, check=False)
    facts = json.loads(result.stdout) if result.stdout else None
    return result.returncode, facts, result.stderr


class Beside(unittest.TestCase):
    def begin(self, folder):
        shutil.rmtree(folder, ignore_errors=True)
        command = asperity_run.command(DECK, *LONG, "--output", folder, "--set",
                                       "Output/Checkpoint Every n Steps=100")
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        steps = pathlib.Path(folder) / "steps.csv"
        begin = time.time()
        while not steps.exists() or steps.stat().st_size < 20000:
            self.assertIsNone(process.poll())
            self.assertLess(time.time() - begin, PATIENCE)
            time.sleep(0.1)
        return process

    def test_running_then_stopped(self):
        process = self.begin("stopped")
        code, facts, _ = status("stopped")
        self.assertEqual((code, facts["state"]), (10, "running"))
        self.assertGreater(facts["step"], 50)
        self.assertLess(facts["time"], 1e6)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(PATIENCE), 4)
        code, facts, _ = status("stopped")
        self.assertEqual((code, facts["state"]), (4, "stopped"))
        rows = asperity_run.table("stopped/steps.csv")
        self.assertEqual((facts["step"], facts["time"]), (rows[-1]["step"], rows[-1]["time"]))

    def test_follow_until_stopped(self):
        process = self.begin("followed")
        follower = subprocess.Popen([str(STATUS), "followed", "--follow", "--every", "0.05s",
                                     "--json"], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                    text=True)
        self.addCleanup(follower.communicate)
        self.addCleanup(follower.kill)
        seen = [json.loads(follower.stdout.readline()) for _ in range(3)]
        self.assertEqual({facts["state"] for facts in seen}, {"running"})
        self.assertIsNone(follower.poll())
        process.send_signal(signal.SIGTERM)
        self.assertEqual(process.wait(PATIENCE), 4)
        out, errors = follower.communicate(timeout=PATIENCE)
        self.assertEqual((follower.returncode, errors), (4, ""))
        seen += [json.loads(line) for line in out.splitlines()]
        self.assertEqual([facts["state"] for facts in seen],
                         ["running"] * (len(seen) - 1) + ["stopped"])
        steps = [facts["step"] for facts in seen]
        self.assertEqual(steps, sorted(steps))
        self.assertEqual(steps[-1], asperity_run.table("followed/steps.csv")[-1]["step"])

    def test_killed(self):
        process = self.begin("killed")
        process.kill()
        process.wait(PATIENCE)
        code, facts, _ = status("killed")
        self.assertEqual((code, facts["state"]), (6, "killed"))

    def test_finished(self):
        folder = asperity_run.run_to_end("finished", DECK, "--set", "Time Stepping/Final Time=50")
        code, facts, _ = status(folder)
        self.assertEqual((code, facts["state"], facts["time"]), (0, "finished", 50))
        self.assertEqual(facts["seconds_left"], None)
        self.assertLess(abs(facts["relative_energy_defect"]), 1e-6)

    def test_no_run(self):
        code, facts, error = status("nowhere")
        self.assertEqual((code, facts, error.count("\n")), (2, None, 1))


if __name__ == "__main__":
    unittest.main()
