"""Runs whose n-th operation on a file is disturbed (fault_shim.cpp)."""

import collections
import os
import pathlib
import subprocess

import asperity_run
import time_limits

SHIM = os.environ["ASPERITY_FAULT_SHIM"]
OPERATIONS = {"w": "write", "p": "pwrite", "v": "writev", "q": "pwritev", "s": "fsync",
              "t": "ftruncate", "r": "rename", "o": "making a file", "m": "making a folder"}


def is_long():
    """Whether this is the long form, of the label `reliability`."""
    return bool(os.environ.get("ASPERITY_LONG_FORM"))


def trials(short, long):
    """How many trials there are in each form; ASPERITY_TRIALS sets another number."""
    return int(os.environ.get("ASPERITY_TRIALS") or (long if is_long() else short))


def environment(folder, kind, number, rank=None, **more):
    folder = pathlib.Path(folder).absolute()
    result = {**os.environ, "LD_PRELOAD": SHIM, "FAULT_FOLDER": f"{folder}/",
              "FAULT_KIND": kind, "FAULT_AT": str(number), **more}
    if rank is not None:
        result["FAULT_RANK"] = str(rank)
    return result


def run(folder, kind, number, *arguments, ranks=1, rank=None, timeout=60, **more):
    """Of the operations on files below the folder, those of one process counted."""
    words = asperity_run.command(*arguments, "--output", folder, ranks=ranks)
    result = subprocess.run(words, capture_output=True, text=True, check=False,
                            timeout=time_limits.seconds(timeout),
                            env=environment(folder, kind, number, rank, **more))
    asperity_run.require_no_rise(result.stdout)
    return result


def operations(folder, *arguments, ranks=1, rank=None, kind="full", timeout=60):
    """{letter: how many} of the run when nothing disturbs it."""
    counter = pathlib.Path(f"{folder}.count").absolute()
    counter.unlink(missing_ok=True)
    result = run(folder, kind, 0, *arguments, ranks=ranks, rank=rank, timeout=timeout,
                 FAULT_COUNT=str(counter))
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    # A process without any operation writes no file.
    return collections.Counter(counter.read_text() if counter.exists() else "")


def count_operations(*arguments, **options):
    """How many operations there are of all kinds."""
    return sum(operations(*arguments, **options).values())


def failing_numbers(total, first=1):
    """The numbers, from `first` on, of the operations whose failure certainly ends a run, if
    another run of the same deck had `total` of them.

    The last eight are left out for two reasons. The last four complete log and journal when all
    results are on the disk, and a run without them has not failed. And two runs may differ by a
    few operations: HDF5 decides by the state of its caches when it writes, and lines of progress
    depend on the clock. So the run that is disturbed may end before the last number comes."""
    return range(first, total - 7)
