"""A run that is disturbed at random, for hours, ends as the run that is left alone.

Round after round runs the deck on one or two ranks until it has finished. Now and then it is
killed at some moment or in the middle of a write, told to stop, meets a full disk or a second run
in its directory; then it goes on from its checkpoint. Each round has to end with the results of
the run left alone, bit for bit; the status of a run that is stopped, meets a full disk or is
refused must be the documented one.

    soak.py [--hours H | --rounds N] [--seed N] [--final-time T]

The deck takes about a minute with the default --final-time. Prints one line a round, and at last
how often each disturbance came before the run had finished.
"""

import argparse
import collections
import random
import shutil
import signal
import subprocess
import sys
import time

import asperity_run
import faults
import runs
import time_limits
from comparisons import assert_same_results

LIMIT = 1800  # s, for one piece of a run


class Soak:
    def __init__(self, seed, final_time):
        self.chance = random.Random(seed)
        self.decks = {
            1: [*runs.ENDLESS, *runs.settings(f"Time Stepping/Final Time={final_time}")],
            2: [*runs.SHORT_RUN, *runs.settings(f"Time Stepping/Final Time={final_time / 2}")]}
        self.wholes, self.seconds, self.operations = {}, {}, {}
        self.counts = collections.Counter()
        for ranks, deck in self.decks.items():
            begin = time.monotonic()
            folder = runs.fresh(f"whole_{ranks}")
            self.wholes[ranks] = folder
            self.operations[ranks] = faults.count_operations(folder, *deck, ranks=ranks,
                                                             kind="kill", timeout=LIMIT)
            self.seconds[ranks] = time.monotonic() - begin

    def round(self, number):
        """One run from its begin to its end."""
        ranks = 2 if number % 4 == 3 else 1
        folder = runs.fresh("disturbed")
        kinds = []
        while True:
            kind = self.chance.choice(["moment", "write", "stop", "full", "second", "nothing"])
            finished = getattr(self, kind)(folder, ranks)
            kinds.append(kind)
            self.counts[kind, "finished before" if finished else "disturbed"] += 1
            if finished:
                break
        assert_same_results(self.wholes[ranks], folder)
        return f"round {number}, {ranks} rank{'s'[:ranks - 1]}: {' '.join(kinds)}: equal"

    def arguments(self, folder, ranks):
        return [*self.decks[ranks], "--output", folder, *runs.way_on(folder)]

    def moment(self, folder, ranks):
        """Killed at a moment between the begin and the end of a whole run."""
        process, children = self.begin(folder, ranks)
        process.kill()
        process.communicate()
        runs.wait_for_ends(children)
        return process.returncode == runs.DONE

    def stop(self, folder, ranks):
        """Told to stop; mpirun itself returns 1 after SIGTERM, but 4 after SIGUSR1."""
        process, _ = self.begin(folder, ranks)
        process.send_signal(signal.SIGUSR1)
        _, errors = process.communicate(timeout=time_limits.seconds(LIMIT))
        # Before MPI has begun nobody listens yet: the signal ends the program, and mpirun, which
        # passes it on, returns 128 + signal.
        self.expect(process.returncode, errors, runs.DONE, runs.STOPPED, -signal.SIGUSR1,
                    128 + signal.SIGUSR1)
        runs.wait_for_lock(folder)
        return process.returncode == runs.DONE

    def begin(self, folder, ranks):
        process = runs.start(*self.arguments(folder, ranks), ranks=ranks)
        try:
            process.wait(self.chance.uniform(0.1, self.seconds[ranks]))
        except subprocess.TimeoutExpired:
            pass
        return process, runs.children_of(process)

    def write(self, folder, ranks):
        """Killed in the middle of an operation on a file."""
        result = self.fault(folder, "kill", ranks)
        if ranks == 1:
            self.expect(result.returncode, result.stderr, runs.DONE, -signal.SIGKILL)
        runs.wait_for_lock(folder)
        return result.returncode == runs.DONE

    def full(self, folder, ranks):
        """No space from an operation on."""
        result = self.fault(folder, "full", ranks)
        self.expect(result.returncode, result.stderr, runs.DONE, runs.OUTPUT, runs.INPUT)
        runs.wait_for_lock(folder)
        return result.returncode == runs.DONE

    def fault(self, folder, kind, ranks):
        words = asperity_run.command(*self.arguments(folder, ranks), ranks=ranks)
        number = self.chance.randrange(1, self.operations[ranks])
        rank = self.chance.randrange(ranks)
        result = subprocess.run(words, capture_output=True, text=True, check=False,
                                timeout=time_limits.seconds(LIMIT),
                                env=faults.environment(folder, kind, number, rank))
        asperity_run.require_no_rise(result.stdout)
        return result

    def second(self, folder, ranks):
        """A second run in the same directory is refused, and the first goes on; then it is told
        to stop."""
        process, _ = self.begin(folder, ranks)
        if process.poll() is None and (folder / "checkpoint.h5").exists():
            other = asperity_run.run(*self.arguments(folder, ranks), ranks=ranks, timeout=LIMIT)
            # The first one may have finished meanwhile.
            if process.poll() is None:
                self.expect(other.returncode, other.stderr, runs.INPUT)
        process.terminate()
        process.communicate(timeout=time_limits.seconds(LIMIT))
        runs.wait_for_lock(folder)
        return process.returncode == runs.DONE

    def nothing(self, folder, ranks):
        """To the end."""
        result = asperity_run.run(*self.arguments(folder, ranks), ranks=ranks, timeout=LIMIT)
        self.expect(result.returncode, result.stderr, runs.DONE)
        return True

    @staticmethod
    def expect(status, errors, *allowed):
        if status not in allowed:
            raise AssertionError(f"status {status}, not one of {allowed}: {errors}")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--hours", type=float, default=2)
    parser.add_argument("--rounds", type=int, help="instead of hours")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--final-time", type=float, default=600)
    options = parser.parse_args()
    soak = Soak(options.seed, options.final_time)
    begin = time.monotonic()
    number = 0
    while (number < options.rounds if options.rounds is not None
           else time.monotonic() < begin + 3600 * options.hours):
        print(soak.round(number), flush=True)
        number += 1
    hours = (time.monotonic() - begin) / 3600
    print(f"\n{number} rounds in {hours:.2g} hours, seed {options.seed}, all equal")
    for (kind, what), count in sorted(soak.counts.items()):
        print(f"{kind:8} {what:15} {count:5}")
    shutil.rmtree("disturbed", ignore_errors=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
