"""The log of a run: its progress, cost and end. A restart appends the log of its process."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import List, Optional, Tuple

from .errors import InputError
from .journal import Journal

_BEGIN = re.compile(r"Asperity \S+ on .*\.$")
_PROGRESS = re.compile(
    r"t = (?P<time>\S+) s(?: of (?P<final>\S+) s \(\d+ %\))?, step (?P<step>\d+), "
    r"dt (?P<size>\S+) s, V (?P<rate>\S+) m/s, (?P<iterations>\d+) iterations(?P<rest>.*)$")
_EVENTS = re.compile(r", (\d+) events?\b")
_WALL = re.compile(r", wall (\S+) s\b")
_END = re.compile(r"(?P<how>Finished|Stopped) at t = (?P<time>\S+) s after (?P<step>\d+) steps\.$")
_FAILED = "The run has ended: "
_WARNING = "WARNING: "
_WORK = re.compile(r"(?P<name>\S.*?)\s{2,}(?P<least>[\d.]+)\s+(?P<most>[\d.]+)\s+"
                   r"(?P<share>[\d.]+) %\s+(?P<count>\d+)$")


@dataclass(frozen=True)
class Progress:
    """A line of progress; `wall` [s] counts over all processes, None where the line has none."""

    time: float
    step: int
    step_size: float
    peak_slip_rate: float
    num_events: int
    wall: Optional[float]


@dataclass
class RunLog:
    """`ending`: '' while there is none, 'Finished' or 'Stopped', of the last process."""

    path: Path
    environment: List[str] = field(default_factory=list)  # of the last process
    progress: List[Progress] = field(default_factory=list)
    final_time: Optional[float] = None
    ending: str = ""
    failure: str = ""             # why the last process ended by itself
    warnings: List[str] = field(default_factory=list)
    processes: int = 0
    report: List[str] = field(default_factory=list)       # the lines after its end
    work: List[Tuple[str, float, float, float, int]] = field(default_factory=list)
    # of each kind of work: its name, least and most seconds of a rank, percent, count
    _ended: float = 0.0           # wall time [s] at the end of the last process, if known

    @classmethod
    def read(cls, path: Path) -> "RunLog":
        """InputError if there is no log; a last line without its end is left out."""
        try:
            lines = path.read_text(encoding="utf-8", errors="replace").split("\n")[:-1]
        except OSError as error:
            raise InputError(f"{path} cannot be read ({error.strerror}). Give the folder in which "
                             "a run of asperity writes its results.") from error
        log = cls(path)
        before = 0.0  # wall time of earlier processes
        begins = sum(1 for line in lines if _BEGIN.fullmatch(line))
        ends = Journal.read(path.with_name("run.jsonl")).walls  # older runs have none
        ends = ([None] * begins + ends)[-begins:] if begins else []
        for line in lines:
            if _BEGIN.fullmatch(line):
                before = log.wall
                log._begin(line)
                wall = ends[log.processes - 1]
                log._ended = before + wall if wall is not None else 0.0
            elif log.processes and line.startswith(
                    ("Kokkos ", "Built from ", "Machine: ")):
                log.environment.append(line)
            else:
                log._take(line, before)
        return log

    @property
    def wall(self) -> float:
        """Wall time [s] of all processes up to their ends, or to their last lines; 0 if the log
        has none."""
        of_lines = (line.wall for line in reversed(self.progress) if line.wall is not None)
        return max(next(of_lines, 0.0), self._ended)

    def _begin(self, line: str) -> None:
        self.environment, self.ending, self.report, self.work = [line], "", [], []
        self.failure = ""
        self.processes += 1

    def _take(self, line: str, before: float) -> None:
        found = _PROGRESS.match(line)
        if found:
            self._add(found, before)
            return
        if line.startswith(_FAILED):
            self.failure = line[len(_FAILED):]
        if line.startswith(_WARNING):
            self.warnings.append(line[len(_WARNING):])
        end = _END.match(line)
        if end:
            self.ending = end["how"]
        if self.ending:
            self.report.append(line)
            work = _WORK.match(line)
            if work:
                self.work.append((work["name"], float(work["least"]), float(work["most"]),
                                  float(work["share"]), int(work["count"])))

    def _add(self, found, before: float) -> None:
        """A restart goes back to its checkpoint: what came after that is computed again."""
        step = int(found["step"])
        while self.progress and self.progress[-1].step >= step:
            self.progress.pop()
        events, wall = _EVENTS.search(found["rest"]), _WALL.search(found["rest"])
        if found["final"]:
            self.final_time = float(found["final"])
        self.progress.append(Progress(
            float(found["time"]), step, float(found["size"]), float(found["rate"]),
            int(events[1]) if events else 0, before + float(wall[1]) if wall else None))
