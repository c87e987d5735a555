"""Runs that are killed go on bit for bit, whenever and in the middle of whatever it happens."""

import collections
import os
import random
import signal
import time
import unittest

import asperity_run
import faults
import runs
import time_limits
from comparisons import assert_same_results

# How many trials of each kind.
AT_RANDOM = IN_A_WRITE = faults.trials(4, 50)
OF_RANKS = faults.trials(2, 50)
TWICE, TWICE_OF_RANKS = -(-AT_RANDOM // 5), -(-OF_RANKS // 5)


class Killed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.whole, cls.seconds = {}, {}
        for ranks, deck in ((1, runs.RUN), (2, runs.SHORT_RUN)):
            begin = time.monotonic()
            cls.whole[ranks] = asperity_run.run_to_end(f"whole_{ranks}", *deck, ranks=ranks,
                                                       timeout=200)
            cls.seconds[ranks] = time.monotonic() - begin

    @staticmethod
    def deck(ranks):
        return runs.RUN if ranks == 1 else runs.SHORT_RUN

    def assert_goes_on(self, folder, ranks):
        result = asperity_run.run(*self.deck(ranks), "--output", folder, *runs.way_on(folder),
                                  ranks=ranks, timeout=200)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        assert_same_results(self.whole[ranks], folder)

    def kill_at(self, folder, moment, ranks):
        process = runs.start(*self.deck(ranks), "--output", folder, *runs.way_on(folder),
                             ranks=ranks)
        time.sleep(moment)
        self.kill(process)

    @staticmethod
    def kill(process):
        children = runs.children_of(process)
        process.kill()
        process.communicate(timeout=time_limits.seconds(60))
        runs.wait_for_ends(children)

    def kill_in(self, folder, number, ranks=1, rank=None, only=""):
        """In the n-th operation on a file, or the n-th one of a letter."""
        return faults.run(folder, "kill", number, *self.deck(ranks), *runs.way_on(folder),
                          ranks=ranks, rank=rank, timeout=200, FAULT_ONLY=only)

    def kill_at_any_moment(self, ranks, trials, twice, earliest):
        for seed in range(trials):
            with self.subTest(seed=seed):
                chance = random.Random(seed)
                folder = runs.fresh(f"at_random_{ranks}")
                for _ in range(2 if seed < twice else 1):
                    self.kill_at(folder, chance.uniform(earliest, self.seconds[ranks]), ranks)
                self.assert_goes_on(folder, ranks)
        print(f"{trials} runs of {ranks} ranks killed at random moments, {twice} of them twice")

    def test_at_any_moment(self):
        self.kill_at_any_moment(1, AT_RANDOM, TWICE, 0.1)

    def test_at_any_moment_on_two_ranks(self):
        self.kill_at_any_moment(2, OF_RANKS, TWICE_OF_RANKS, 0.5)

    def test_with_checkpoints_by_wall_time_alone(self):
        by_time = runs.settings("Output/Checkpoint Every n Steps=1000000",
                                "Output/Checkpoint Every Minutes=2e-3")
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                folder = runs.fresh("by_wall_time")
                self.kill(runs.begin(folder, *self.deck(ranks), *by_time, ranks=ranks))
                self.assert_goes_on(folder, ranks)

    def test_in_any_write(self):
        """Each kind of operation in turn."""
        counts = faults.operations(runs.fresh("in_a_write"), *runs.RUN, kind="kill")
        killed = collections.Counter()
        for seed in range(IN_A_WRITE):
            letter = sorted(counts)[seed % len(counts)]
            with self.subTest(seed=seed, operation=faults.OPERATIONS[letter]):
                chance = random.Random(seed)
                folder = runs.fresh("in_a_write")
                for _ in range(2 if seed < TWICE else 1):
                    number = chance.randrange(1, counts[letter] + 1)
                    result = self.kill_in(folder, number, only=letter)
                    self.assertIn(result.returncode, (-signal.SIGKILL, runs.DONE))
                    killed[letter] += result.returncode == -signal.SIGKILL
                self.assert_goes_on(folder, 1)
        if IN_A_WRITE >= len(counts):
            self.assertEqual({letter for letter in counts if killed[letter] == 0}, set())
        print(f"{IN_A_WRITE} runs killed in an operation on a file, {TWICE} of them twice: " +
              ", ".join(f"{killed[letter]} times in one of {counts[letter]} of "
                        f"{faults.OPERATIONS[letter]}" for letter in sorted(counts)))

    def test_one_rank_of_two(self):
        """The other one does not wait for ever, and the last checkpoint is good."""
        total = faults.count_operations(runs.fresh("one_rank"), *runs.SHORT_RUN, ranks=2, rank=0,
                                        kind="kill")

        def kill(folder, rank, chance):
            """Rank 0 in an operation on a file; rank 1 has none."""
            if rank == 0:
                result = self.kill_in(folder, chance.randrange(1, total // 3), ranks=2, rank=0)
                return result.returncode
            process = runs.begin(folder, *self.deck(2), *runs.way_on(folder), ranks=2)
            os.kill(int(runs.children_of(process)[1]), signal.SIGKILL)
            process.communicate(timeout=time_limits.seconds(60))
            return process.returncode

        again = 0
        for seed in range(OF_RANKS):
            with self.subTest(seed=seed):
                chance = random.Random(seed)
                folder = runs.fresh("one_rank")
                rank, other = seed % 2, (seed + 1) % 2
                self.assertNotEqual(kill(folder, rank, chance), runs.DONE)
                runs.wait_for_lock(folder)
                if seed < TWICE_OF_RANKS:  # then the other rank
                    again += kill(folder, other, chance) != runs.DONE  # it may have finished before
                    runs.wait_for_lock(folder)
                self.assert_goes_on(folder, 2)
        print(f"{OF_RANKS} runs of which one rank of two was killed, {again} of them "
              "twice, each rank once")


if __name__ == "__main__":
    unittest.main()
