"""A run that is told to stop leaves a checkpoint, says so, and goes on bit for bit."""

import os
import pathlib
import pty
import re
import resource
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
                       signal.SIGUSR2, signal.SIGXCPU, signal.SIGPIPE):
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

    def test_mpirun_passes_the_warnings_of_queues_on(self):
        for number in (signal.SIGUSR1, signal.SIGUSR2):
            folder = runs.fresh(f"mpirun_{number.name}")
            runs.stop(self, runs.begin(folder, *runs.ENDLESS, ranks=2), number)
            self.assertIn(f"Stopped by {number.name}", (folder / "run.log").read_text())


class Limits(unittest.TestCase):
    """Of a queue or of `ulimit`, in the process itself."""

    def test_cpu_time_of_a_run(self):
        """At the soft limit; the kernel kills at the hard one."""
        folder = runs.fresh("cpu")
        process = runs.start(*runs.ENDLESS, "--output", folder, preexec_fn=lambda: (
            resource.setrlimit(resource.RLIMIT_CPU, (3, time_limits.seconds(60)))))
        _, errors = process.communicate(timeout=time_limits.seconds(120))
        self.assertEqual((process.returncode, errors), (runs.STOPPED, ""))
        self.assertIn("Stopped by SIGXCPU", (folder / "run.log").read_text())
        self.assertTrue((folder / "checkpoint.h5").exists())

    def test_size_of_a_file_is_as_a_full_disk(self):
        """Status 5 and a message, which run.log has too; the run goes on from its checkpoint."""
        short = asperity_run.run_to_end("short", *runs.RUN)
        limit = 2 * (short / "checkpoint.h5").stat().st_size  # steps.csv grows beyond it
        folder = runs.fresh("size")
        process = runs.start(*runs.ENDLESS, "--output", folder, preexec_fn=lambda: (
            resource.setrlimit(resource.RLIMIT_FSIZE, (limit, limit))))
        _, errors = process.communicate(timeout=time_limits.seconds(120))
        self.assertEqual(process.returncode, runs.OUTPUT, errors)
        message = errors.removeprefix("asperity: ").strip()
        self.assertEqual(message.count("\n"), 0, errors)
        self.assertRegex(message, f"File too large|the limit of {limit} bytes for one file")
        self.assertIn(message, (folder / "run.log").read_text())
        again = runs.begin(folder, *runs.ENDLESS, "--restart", folder / "checkpoint.h5")
        runs.stop(self, again)


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
