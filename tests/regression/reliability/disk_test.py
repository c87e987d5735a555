"""A full disk ends a run with status 5 and one message, which run.log has too; what was complete
stays complete. So does a file system that can only be read from some moment on, but that run.log
cannot have the message."""

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
from comparisons import assert_same_results
from mesh_files import MESH_TOOL


def assert_goes_on(test, whole, folder, *arguments, ranks=1):
    result = asperity_run.run(*arguments, "--output", folder, *runs.way_on(folder), ranks=ranks)
    test.assertEqual((result.returncode, result.stderr), (0, ""))
    assert_same_results(whole, folder)


class FullDisk(unittest.TestCase):
    def assert_ends_well(self, result, folder):
        if result.returncode == runs.DONE:
            self.fail("the disk was not full")
        if not (folder / "run.log").exists():
            runs.assert_one_message(self, result, runs.INPUT, "the space on the disk")
            return
        message = runs.assert_one_message(self, result, runs.OUTPUT).removeprefix("asperity: ")
        self.assertNotIn("Segmentation", result.stderr)
        self.assertRegex(message,
                         "cannot be (written|made|replaced)|No space left on device|disk full")
        if "parameters.xml" not in message:  # written before there is a run
            self.assertIn(message, (folder / "run.log").read_text())

    def test_at_any_write(self):
        whole = asperity_run.run_to_end("whole", *runs.RUN)
        folder = runs.fresh("full")
        total = faults.count_operations(folder, *runs.RUN)
        self.assertGreater(total, 200)
        chosen = numbers = faults.failing_numbers(total)
        if not faults.is_long():
            chosen = sorted({*numbers[:29:4], *numbers[29::total // 5]})
        for number in chosen:
            with self.subTest(number=number):
                folder = runs.fresh("full")
                result = faults.run(folder, "full", number, *runs.RUN)
                self.assert_ends_well(result, folder)
                if number % 3 == 0 or number > 100:
                    assert_goes_on(self, whole, folder, *runs.RUN)
        print(f"full disk at {len(chosen)} of {total} writes")

    def test_at_any_new_file(self):
        """What there is can be written, but no file or folder can be made: no inodes are left. How
        many are made follows from the deck alone, and none of them only completes log or journal,
        so that each number is one that fails."""
        whole = asperity_run.run_to_end("whole_files", *runs.RUN)
        counts = faults.operations(runs.fresh("files"), *runs.RUN)
        for letter in "om":
            numbers = range(1, counts[letter] + 1)
            chosen = random.Random(letter).sample(
                numbers, min(len(numbers), faults.trials(2, len(numbers))))
            for number in sorted(chosen):
                with self.subTest(number=number, letter=letter):
                    folder = runs.fresh("files")
                    result = faults.run(folder, "full", number, *runs.RUN, FAULT_ONLY=letter)
                    self.assert_ends_well(result, folder)
                    assert_goes_on(self, whole, folder, *runs.RUN)
            print(f"no space for {letter} at {sorted(chosen)} of {counts[letter]}")

    def test_of_one_of_two_ranks(self):
        run = runs.SHORT_RUN
        whole = asperity_run.run_to_end("whole_ranks", *run, ranks=2)
        total = faults.count_operations(runs.fresh("ranks"), *run, ranks=2, rank=0)
        self.assertGreater(total, 200)
        # Rank 0 writes what the others have.
        self.assertEqual(faults.count_operations(runs.fresh("ranks"), *run, ranks=2, rank=1), 0)
        chosen = random.Random(0).sample(faults.failing_numbers(total), faults.trials(4, 60))
        for number in sorted(chosen):
            with self.subTest(number=number):
                folder = runs.fresh("ranks")
                result = faults.run(folder, "full", number, *run, ranks=2, rank=0)
                self.assert_ends_well(result, folder)
                assert_goes_on(self, whole, folder, *run, ranks=2)
        print(f"full disk of rank 0 of 2 at {sorted(chosen)} of {total} writes")

    def test_mesh_tool(self):
        folder = runs.fresh("mesh")
        folder.mkdir()
        words = [str(MESH_TOOL), "rectangle", str(folder / "mesh.h5"), "--cells-x", "20",
                 "--cells-y", "20"]
        for number in (1, 2, 3, 5):
            result = subprocess.run(words, capture_output=True, text=True, check=False,
                                    timeout=time_limits.seconds(60),
                                    env=faults.environment(folder, "full", number))
            # The first one makes the file: where that fails, the name may be wrong.
            self.assertEqual(result.returncode, runs.INPUT if number == 1 else runs.OUTPUT,
                             result.stdout + result.stderr)
            self.assertRegex(result.stderr, r"\Aasperity-mesh: .*cannot be written.*\n\Z")
            self.assertEqual(list(folder.iterdir()), [])


class ReadOnly(unittest.TestCase):
    """From some write in the middle of the run on, on every rank."""

    def check(self, ranks, run):
        whole = asperity_run.run_to_end(f"whole_readonly_{ranks}", *run, ranks=ranks)
        # Of the rank that writes most, which comes there first.
        total = max(faults.count_operations(runs.fresh("readonly"), *run, ranks=ranks, rank=rank,
                                            kind="readonly") for rank in range(ranks))
        numbers = faults.failing_numbers(total, first=total // 2)
        chosen = random.Random(ranks).sample(numbers, faults.trials(2, 60))
        for number in sorted(chosen):
            with self.subTest(number=number, ranks=ranks):
                folder = runs.fresh("readonly")
                result = faults.run(folder, "readonly", number, *run, ranks=ranks)
                runs.assert_one_message(self, result, runs.OUTPUT, str(folder))
                self.assertNotIn("Segmentation", result.stderr)
                self.assertNotIn("Is the disk full", result.stderr)
                self.assertTrue((folder / "checkpoint.h5").exists())
                runs.wait_for_lock(folder)
                assert_goes_on(self, whole, folder, *run, ranks=ranks)
        print(f"read-only from {sorted(chosen)} of {total} writes on, {ranks} ranks")

    def test_on_one_rank(self):
        self.check(1, runs.RUN)

    def test_on_two_ranks(self):
        self.check(2, runs.SHORT_RUN)


class VanishedDirectory(unittest.TestCase):
    def check(self, ranks, run):
        folder = runs.fresh(f"vanished_{ranks}")
        process = runs.begin(folder, *run, ranks=ranks)
        os.rename(folder, f"elsewhere_{ranks}")
        _, errors = process.communicate(timeout=time_limits.seconds(60))
        shutil.rmtree(f"elsewhere_{ranks}")
        result = subprocess.CompletedProcess(process.args, process.returncode, "", errors)
        message = runs.assert_one_message(self, result, runs.OUTPUT, "removed")
        if ranks == 1:  # mpirun has words of its own
            self.assertEqual(errors, message + "\n")
        self.assertFalse(re.search("disk full", errors))
        self.assertFalse(pathlib.Path(folder).exists())

    def test_is_named(self):
        self.check(1, runs.ENDLESS)

    def test_is_named_on_two_ranks(self):
        self.check(2, [*runs.ENDLESS, *runs.settings("Mesh/Wedge/Cell Size=0.02",
                                                     "TNNMG/Linear Correction=Multigrid")])


if __name__ == "__main__":
    unittest.main()
