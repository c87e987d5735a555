"""Two runs do not write to one directory, and a run that was killed leaves no lock."""

import pathlib
import signal
import unittest

import asperity_run
import runs
import time_limits
from comparisons import assert_same_results


class Lock(unittest.TestCase):
    def assert_locked(self, folder, *arguments, ranks=1):
        result = asperity_run.run(*runs.ENDLESS, "--output", folder, *arguments, ranks=ranks,
                                  timeout=20)
        runs.assert_one_message(self, result, runs.INPUT, "Another run is writing to", "process",
                                "--output DIR")

    def test_a_second_run_is_refused(self):
        folder = runs.fresh("second_run")
        process = runs.begin(folder, *runs.ENDLESS)
        self.assert_locked(folder, "--overwrite")
        self.assert_locked(folder, "--restart", folder / "checkpoint.h5")
        self.assert_locked(folder, "--overwrite", ranks=2)
        runs.stop(self, process)
        self.assertFalse((folder / ".lock").exists())
        steps = asperity_run.table(folder / "steps.csv")
        self.assertEqual([row["step"] for row in steps], list(range(1, len(steps) + 1)))

    def test_two_first_runs_at_once(self):
        whole = asperity_run.run_to_end("first_whole", *runs.RUN)
        for _ in range(3):
            folder = runs.fresh("first_runs")
            processes = [runs.start(*runs.RUN, "--output", folder) for _ in range(2)]
            errors = [process.communicate(timeout=time_limits.seconds(60))[1]
                      for process in processes]
            self.assertEqual(sorted(process.returncode for process in processes),
                             [runs.DONE, runs.INPUT], errors)
            assert_same_results(whole, folder)

    def test_a_killed_run_leaves_no_lock(self):
        whole = asperity_run.run_to_end("killed_whole", *runs.RUN)
        folder = runs.fresh("killed")
        runs.stop(self, runs.begin(folder, *runs.RUN), signal.SIGKILL)
        asperity_run.go_on(folder, *runs.RUN)
        assert_same_results(whole, folder)

    def test_a_link_is_not_followed(self):
        """A file outside of the output directory keeps its bytes, whatever link leads to it."""
        outside = pathlib.Path("precious.txt")
        outside.write_text("mine")
        for name in (".lock", ".asperity_write_test", "run.log", "checkpoint.h5.part",
                     "fault.xdmf"):
            for options in ((), ("--overwrite",)):
                with self.subTest(name, options=options):
                    folder = runs.fresh("links")
                    folder.mkdir()
                    (folder / name).symlink_to(outside.resolve())
                    result = asperity_run.run(*runs.SHORT_RUN, "--output", folder, *options)
                    self.assertEqual(outside.read_text(), "mine")
                    refused = name == ".lock" or (not options and name != ".asperity_write_test")
                    if refused:
                        runs.assert_one_message(self, result, runs.INPUT, f"{name} is a link",
                                                "--output DIR")
                    else:
                        self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
