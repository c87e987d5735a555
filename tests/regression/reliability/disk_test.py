"""A full disk ends a run with status 5 and one message, which run.log has too; what was complete
stays complete."""

import os
import pathlib
import random
import re
import shutil
import subprocess
import unittest

import asperity_run
import faults
import runs
import time_limits

MESH_TOOL = asperity_run.PROGRAM.with_name("asperity-mesh")


class FullDisk(unittest.TestCase):
    def assert_ends_well(self, result, folder):
        if result.returncode == runs.DONE:
            self.fail("the disk was not full")
        if not (folder / "run.log").exists():
            runs.assert_one_message(self, result, runs.INPUT, "the space on the disk")
            return
        self.assertEqual(result.returncode, runs.OUTPUT, result.stdout + result.stderr)
        lines = [line for line in result.stderr.splitlines() if line.startswith("asperity: ")]
        self.assertEqual(len(lines), 1, result.stderr)
        self.assertNotIn("Segmentation", result.stderr)
        message = lines[0].removeprefix("asperity: ")
        self.assertRegex(message,
                         "cannot be (written|made|replaced)|No space left on device|disk full")
        if "parameters.xml" not in message:  # written before there is a run
            self.assertIn(message, (folder / "run.log").read_text())

    def assert_goes_on(self, whole, folder, *arguments, ranks=1):
        result = asperity_run.run(*arguments, "--output", folder, *runs.way_on(folder),
                                  ranks=ranks)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        runs.assert_same_results(self, whole, folder)

    def test_at_any_write(self):
        whole = asperity_run.run_to_end("whole", *runs.RUN)
        folder = runs.fresh("full")
        total = faults.count_operations(folder, *runs.RUN)
        self.assertGreater(total, 200)
        chosen = {*range(1, 30, 4), *range(30, total, total // 5)}
        if faults.is_long():
            chosen = set(range(1, total))
        for number in sorted(chosen):
            with self.subTest(number=number):
                folder = runs.fresh("full")
                result = faults.run(folder, "full", number, *runs.RUN)
                self.assert_ends_well(result, folder)
                if number % 3 == 0 or number > 100:
                    self.assert_goes_on(whole, folder, *runs.RUN)
        print(f"full disk at {len(chosen)} of {total} writes")

    def test_of_one_of_two_ranks(self):
        run = runs.SHORT_RUN
        whole = asperity_run.run_to_end("whole_ranks", *run, ranks=2)
        for rank in (0, 1):
            total = faults.count_operations(runs.fresh("ranks"), *run, ranks=2, rank=rank)
            self.assertGreater(total, 200)
            chosen = random.Random(rank).sample(range(1, total + 1), faults.trials(2, 60))
            for number in sorted(chosen):
                with self.subTest(number=number, rank=rank):
                    folder = runs.fresh("ranks")
                    result = faults.run(folder, "full", number, *run, ranks=2, rank=rank)
                    self.assert_ends_well(result, folder)
                    self.assert_goes_on(whole, folder, *run, ranks=2)
            print(f"full disk of rank {rank} of 2 at {sorted(chosen)} of {total} writes")

    def test_mesh_tool(self):
        folder = runs.fresh("mesh")
        folder.mkdir()
        words = [str(MESH_TOOL), "rectangle", str(folder / "mesh.h5"), "--cells-x", "20",
                 "--cells-y", "20"]
        for number in (1, 2, 4):
            result = subprocess.run(words, capture_output=True, text=True, check=False,
                                    timeout=time_limits.seconds(60),
                                    env=faults.environment(folder, "full", number))
            self.assertEqual(result.returncode, runs.OUTPUT, result.stdout + result.stderr)
            self.assertRegex(result.stderr, r"\Aasperity-mesh: .*cannot be written.*\n\Z")
            self.assertEqual(list(folder.iterdir()), [])


class VanishedDirectory(unittest.TestCase):
    def test_is_named(self):
        folder = runs.fresh("vanished")
        process = runs.start(*runs.ENDLESS, "--output", folder)
        runs.wait_for(folder / "checkpoint.h5", process)
        os.rename(folder, "elsewhere_vanished")
        _, errors = process.communicate(timeout=time_limits.seconds(60))
        shutil.rmtree("elsewhere_vanished")
        self.assertEqual(process.returncode, runs.OUTPUT, errors)
        self.assertRegex(errors, r"\Aasperity: .*removed.*\n\Z")
        self.assertFalse(re.search("disk full", errors))
        self.assertFalse(pathlib.Path(folder).exists())


if __name__ == "__main__":
    unittest.main()
