"""Runs that are watched, disturbed or refused."""

import atexit
import fcntl
import pathlib
import re
import shutil
import signal
import subprocess
import time

import asperity_run
import numpy
import time_limits
from asperity_run import settings

DECK = asperity_run.SOURCE / "tests" / "regression" / "parallel" / "coarse_wedge.xml"
DONE, INPUT, SOLVE, STOPPED, OUTPUT = 0, 2, 3, 4, 5

# Some 250 steps, an event, about a second.
RUN = [DECK, *settings("Time Stepping/Final Time=8", "Output/Checkpoint Every n Steps=20",
                       "Output/Fault History/Every n Steps=7")]
# Some 40 steps.
SHORT_RUN = [DECK, *settings(
    "Time Stepping/Final Time=2", "Time Stepping/Step Doubling/Tolerance=1e-3",
    "Mesh/Wedge/Cell Size=0.02", "TNNMG/Linear Correction=Multigrid",
    "Output/Checkpoint Every n Steps=10")]
# Some 15,000 steps: longer than any test waits.
ENDLESS = [DECK, *settings("Time Stepping/Final Time=600", "Output/Checkpoint Every n Steps=20")]


def fresh(name):
    shutil.rmtree(name, ignore_errors=True)
    return pathlib.Path(name)


def way_on(folder):
    """What goes on with a run, or begins it anew where there is nothing yet."""
    checkpoint = folder / "checkpoint.h5"
    return ["--restart", checkpoint] if checkpoint.exists() else ["--overwrite"]


def start(*arguments, ranks=1, **options):
    """A run in the background, which does not outlive the test."""
    options = {"stdout": subprocess.DEVNULL, "stderr": subprocess.PIPE, "text": True, **options}
    process = subprocess.Popen(asperity_run.command(*arguments, ranks=ranks), **options)
    atexit.register(lambda: process.poll() is None and process.kill())
    return process


def begin(folder, *arguments, **options):
    """`start` in a folder, once a checkpoint of its own is there."""
    checkpoint = folder / "checkpoint.h5"
    before = checkpoint.stat().st_ino if checkpoint.exists() else None
    process = start(*arguments, "--output", folder, **options)
    end = time.monotonic() + time_limits.seconds(60)
    while not checkpoint.exists() or checkpoint.stat().st_ino == before:
        if process.poll() is not None or time.monotonic() > end:
            process.kill()
            raise AssertionError(f"no {checkpoint}: {process.communicate()[1]}")
        time.sleep(0.002)
    return process


def stop(test, process, number=signal.SIGTERM):
    """By a signal; a run has nothing to say on stderr of that, but mpirun has."""
    process.send_signal(number)
    _, errors = process.communicate(timeout=time_limits.seconds(60))
    test.assertEqual(process.returncode, -number if number == signal.SIGKILL else STOPPED, errors)
    if process.args[0] == str(asperity_run.PROGRAM):
        test.assertEqual(errors, "")


def children_of(process):
    """The ranks of mpirun; none of a run without it."""
    tasks = pathlib.Path(f"/proc/{process.pid}/task/{process.pid}/children")
    return tasks.read_text().split() if tasks.exists() else []


def wait_for_ends(processes, seconds=60):
    """mpirun that is killed takes its ranks with it, but not at once."""
    end = time.monotonic() + time_limits.seconds(seconds)
    while any(pathlib.Path(f"/proc/{process}").exists() for process in processes):
        if time.monotonic() > end:
            raise AssertionError(f"of {processes} one has not ended")
        time.sleep(0.1)


def wait_for_lock(folder, seconds=20):
    """Until no process writes there any more."""
    end = time.monotonic() + time_limits.seconds(seconds)
    while time.monotonic() < end:
        try:
            with open(folder / ".lock") as lock:
                fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
            return
        except FileNotFoundError:
            return
        except BlockingIOError:
            time.sleep(0.1)


def assert_one_message(test, result, status, *pieces):
    """One message on stderr with these pieces, which is returned, and the status."""
    test.assertEqual(result.returncode, status, result.stdout + result.stderr)
    # mpirun may write words of its own before it into the same line.
    lines = re.findall(r"\basperity: .*", result.stderr)
    test.assertEqual(len(lines), 1, result.stderr)
    for piece in pieces:
        test.assertIn(piece, lines[0])
    return lines[0]


def assert_finite_checkpoint(test, folder):
    """The state in the checkpoint."""
    values = asperity_run.series(folder / "checkpoint.h5")
    for name in ("alpha", "u", "v", "a"):
        test.assertTrue(numpy.isfinite(values[f"values/state/{name}"]).all(), name)
