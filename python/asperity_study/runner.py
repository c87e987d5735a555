"""Runs side by side on the cores given; what was killed is continued from its checkpoint."""

import contextlib
import ctypes
import fcntl
import os
import shlex
import signal
import subprocess
import sys
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Callable, Iterator, List, Optional

from asperity.errors import InputError
from asperity.journal import Journal

DONE, STOPPED = 0, 4       # exit status of the program
REFUSALS = {1, 2, 3, 5}    # exit status: another attempt would end the same way
SIGNALS = (signal.SIGINT, signal.SIGTERM, signal.SIGHUP,
           signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU)  # of users and queues
PAUSE = 0.05               # [s] between looks at the processes


@dataclass
class Job:
    """A run of the study; `state` is 'waiting', 'running', 'finished' or 'failed'."""

    number: int
    folder: Path
    arguments: List[str]   # the deck and its overrides
    state: str = "waiting"
    starts: int = 0
    status: Optional[int] = None
    process: Optional[subprocess.Popen] = None
    message: str = ""
    warnings: int = 0      # topics of its WARNINGs


@dataclass
class Runner:
    """`slots` runs at a time, each with `launcher` (mpirun and the ranks) before the program;
    a run that is killed is started at most `attempts` times."""

    program: Path
    slots: int
    launcher: List[str] = field(default_factory=list)
    attempts: int = 5
    tell: Callable[[str], None] = print

    def validate(self, jobs: List[Job]) -> None:
        """InputError with the first message of the program that refuses a run."""
        for job in jobs:
            result = subprocess.run([*self.launcher, str(self.program), *job.arguments,
                                     "--validate"], text=True, capture_output=True, check=False)
            if result.returncode != DONE:
                lines = result.stderr.strip().splitlines() or ["no message"]
                raise InputError(f"Run {job.number} is refused: {lines[0]}")

    def run(self, jobs: List[Job]) -> bool:
        """Whether all were run; False if one of SIGNALS stopped them, with checkpoints."""
        stopped: List[int] = []
        before = {each: signal.signal(each, lambda number, _: stopped.append(number))
                  for each in SIGNALS if signal.getsignal(each) != signal.SIG_IGN}
        try:
            while True:
                running = [job for job in jobs if job.state == "running"]
                if stopped:
                    self._stop(running)
                    return False
                for job in running:
                    self._look(job)
                waiting = [job for job in jobs if job.state == "waiting"]
                if not waiting and not any(job.state == "running" for job in jobs):
                    return True
                free = self.slots - sum(job.state == "running" for job in jobs)
                for job in waiting[:free]:
                    self._start(job)
                time.sleep(PAUSE)
        finally:
            for number, handler in before.items():
                signal.signal(number, handler)

    def _start(self, job: Job) -> None:
        job.folder.mkdir(parents=True, exist_ok=True)
        has_checkpoint = (job.folder / "checkpoint.h5").exists()
        how = ["--restart", str(job.folder / "checkpoint.h5")] if has_checkpoint \
            else ["--overwrite"]
        with open(job.folder / "output.txt", "ab") as output:
            job.process = subprocess.Popen(
                [*self.launcher, str(self.program), *job.arguments, "--output", str(job.folder),
                 *how], stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT,
                start_new_session=True, preexec_fn=_end_with_parent)
        job.state, job.starts = "running", job.starts + 1
        self.tell(f"run {job.number}: {'continued' if has_checkpoint else 'started'}")

    def _look(self, job: Job) -> None:
        job.status = job.process.poll()
        if job.status is None:
            return
        if job.status == DONE:
            job.state = "finished"
        elif job.status in REFUSALS and is_message(job) or job.starts >= self.attempts:
            job.state, job.message = "failed", last_line(job.folder / "output.txt")
        else:
            job.state = "waiting"
        words = {"waiting": f"killed (status {job.status}), to be continued",
                 "failed": f"failed (status {job.status}): {job.message}"}
        self.tell(f"run {job.number}: {words.get(job.state, job.state)}")

    def _stop(self, running: List[Job]) -> None:
        """Each writes a checkpoint; mpirun hands the signal on to its ranks."""
        for job in running:
            job.process.send_signal(signal.SIGTERM)
        for job in running:
            job.status = job.process.wait()
            job.state = "waiting"


def _end_with_parent() -> None:
    """In the child: a study that is killed leaves no run behind, each ends with a checkpoint."""
    if sys.platform == "linux":
        ctypes.CDLL(None).prctl(1, signal.SIGTERM)  # PR_SET_PDEATHSIG


def is_message(job: Job) -> bool:
    """Whether the program itself has ended the run: mpirun has status 1 for a killed rank, too."""
    return last_line(job.folder / "output.txt").startswith("asperity: ") or job.status != 1


def last_line(path: Path) -> str:
    """The last message of the program in its output, or else the last line."""
    lines = [line for line in path.read_text(errors="replace").splitlines() if line.strip()]
    messages = [line for line in lines if line.startswith("asperity: ")]
    return (messages or lines or [""])[-1]


def is_finished(folder: Path) -> bool:
    """A run of an earlier call."""
    try:
        return Journal.read(folder).how == "finished"
    except InputError:
        return False


def mark_finished(jobs: List[Job]) -> None:
    for job in jobs:
        if is_finished(job.folder):
            job.state = "finished"


@contextlib.contextmanager
def alone(folder: Path) -> Iterator[None]:
    """Makes the folder of a study; InputError while another process works on the study in it. The
    lock ends with the process, however that ends."""
    folder.mkdir(parents=True, exist_ok=True)
    descriptor = os.open(folder / "study.lock", os.O_RDWR | os.O_CREAT | os.O_NOFOLLOW, 0o644)
    try:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(descriptor)
        raise InputError(f"Another asperity-study works in {folder}. Wait for it, or choose "
                         "another place with --output.") from None
    try:
        yield
    finally:
        os.close(descriptor)


def find_program(given: Optional[Path]) -> Path:
    """The program asperity: as given, beside this one, or on PATH."""
    places = [given] if given else [
        Path(folder) / "asperity" for folder in
        (os.environ.get("ASPERITY_PROGRAMS", ""), str(Path(sys.argv[0]).resolve().parent),
         *os.environ.get("PATH", "").split(os.pathsep)) if folder]
    for place in places:
        if place.is_file() and os.access(place, os.X_OK):
            return place
    raise InputError(f"There is no program {given}." if given else
                     "The program asperity is neither beside asperity-study nor on PATH; name it "
                     "with --program.")


def launcher(ranks: int, mpirun: str) -> List[str]:
    return [] if ranks == 1 else [*shlex.split(mpirun), "-np", str(ranks)]


def summary(jobs: List[Job]) -> str:
    """How many runs are in which state, and which have results that may be wrong."""
    states = [job.state for job in jobs]
    lines = [", ".join(f"{states.count(state)} {state}"
                       for state in ("finished", "failed", "waiting"))]
    warned = [str(job.number) for job in jobs if job.warnings]
    if warned:
        lines.append("WARNING: results may be wrong, see the warnings in run.log of "
                     f"{'runs' if len(warned) > 1 else 'run'} {', '.join(warned)}.")
    return "\n".join(lines)
