"""A run that is told to stop leaves a checkpoint, says so, and goes on bit for bit."""

import os
import pathlib
import pty
import re
import signal
import subprocess
import unittest

import asperity_run
import runs
import time_limits
from comparisons import assert_same_results


class Signals(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole = asperity_run.run_to_end("whole", *runs.RUN)

    def assert_goes_on(self, folder, name):
        self.assertIn(f"Stopped by {name}", (folder / "run.log").read_text())
        asperity_run.go_on(folder, *runs.RUN)
        assert_same_results(self.whole, folder)

    def test_each(self):
        for number in (signal.SIGTERM, signal.SIGINT, signal.SIGHUP, signal.SIGUSR1,
                       signal.SIGPIPE):
            with self.subTest(number.name):
                folder = runs.fresh(f"by_{number.name}")
                runs.stop(self, runs.begin(folder, *runs.RUN), number)
                self.assert_goes_on(folder, number.name)

    def test_nobody_reads_the_output(self):
        """As under `| head`: the next line that is printed meets a closed pipe."""
        reader, writer = os.pipe()
        folder = runs.fresh("pipe")
        process = runs.start(*runs.RUN, "--output", folder, stdout=writer)
        os.close(writer)
        os.close(reader)
        _, errors = process.communicate(timeout=time_limits.seconds(60))
        self.assertEqual((process.returncode, errors), (runs.STOPPED, ""))
        self.assert_goes_on(folder, "SIGPIPE")

    def test_nohup_goes_on(self):
        folder = runs.fresh("nohup")
        process = runs.begin(folder, *runs.RUN, preexec_fn=lambda: signal.signal(
            signal.SIGHUP, signal.SIG_IGN))
        process.send_signal(signal.SIGHUP)
        _, errors = process.communicate(timeout=time_limits.seconds(60))
        self.assertEqual((process.returncode, errors), (0, ""))
        assert_same_results(self.whole, folder)

    def test_mpirun_passes_the_warning_of_a_queue_on(self):
        folder = runs.fresh("mpirun")
        runs.stop(self, runs.begin(folder, *runs.ENDLESS, ranks=2), signal.SIGUSR1)
        self.assertIn("Stopped by SIGUSR1", (folder / "run.log").read_text())


class Terminal(unittest.TestCase):
    def output_of(self, name, ranks, stderr):
        """What a run writes to a terminal, as mpirun gives its ranks one."""
        ours, theirs = pty.openpty()
        folder = runs.fresh(name)
        command = asperity_run.command(*runs.SHORT_RUN, "--output", folder, ranks=ranks)
        process = subprocess.Popen(command, stdout=theirs, stderr=stderr(theirs))
        os.close(theirs)
        text = b""
        try:
            while piece := os.read(ours, 65536):
                text += piece
        except OSError:  # the terminal has gone
            pass
        self.assertEqual(process.wait(), 0)
        return text.decode().replace("\r\n", "\n")

    def test_a_line_in_place_is_for_terminals(self):
        self.assertIn("\r", self.output_of("terminal", 1, lambda terminal: terminal))
        self.assertNotIn("\r", self.output_of("no_terminal", 1, lambda _: subprocess.DEVNULL))

    def test_a_file_under_mpirun_has_no_carriage_returns(self):
        result = asperity_run.run(*runs.SHORT_RUN, "--output", runs.fresh("ranks"), ranks=2)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertFalse(re.search("\r(?!\n)", result.stdout))
        self.assertTrue(pathlib.Path("ranks/run.log").exists())


if __name__ == "__main__":
    unittest.main()
