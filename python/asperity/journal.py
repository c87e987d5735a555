"""The course of a run: run.jsonl, one JSON object a line (packages/io/files/RunJournal.hpp)."""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Optional

from .log import RunLog


@dataclass(frozen=True)
class Warned:
    """A warning of the run: what it is about, its sentences, and when it was given."""

    topic: Optional[str]
    text: str
    step: Optional[int]
    time: Optional[float]


@dataclass(frozen=True)
class Progress:
    """How far the run was at some step; the wall time is that of steps.csv."""

    step: int
    time: float
    wall_time: float
    peak_slip_rate: float
    events: Optional[int]
    seconds_left: Optional[float]
    knows_cycles: bool


@dataclass
class Journal:
    """`how` is '' while there is no end: 'finished', 'stopped', 'failed', of the last process."""

    log: RunLog
    how: str = ""
    exit_status: Optional[int] = None
    message: str = ""
    kind: str = ""                                        # of a failure, else ''
    clock: float = 0.0                                    # [s] since 1970: the last process began
    fault: Dict[str, Any] = field(default_factory=dict)   # how it lies; {} without one
    warnings: List[Warned] = field(default_factory=list)  # the last one of each topic
    progress: List[Progress] = field(default_factory=list)
    wall_time: Optional[float] = None                     # [s] of all processes

    @classmethod
    def read(cls, directory: Path) -> "Journal":
        """InputError if the directory has no log. What is no complete line is left out. What
        run.jsonl does not tell, as one that is lost, is that of the log."""
        journal = cls(RunLog.read(directory / "run.log"))
        try:
            text = (directory / "run.jsonl").read_text(encoding="utf-8", errors="replace")
        except OSError:
            text = ""
            journal.warnings = [Warned(None, text, None, None) for text in journal.log.warnings]
        for line in text.splitlines():
            try:
                journal._take(json.loads(line))
            except (ValueError, KeyError, TypeError):
                continue
        journal.how = journal.how or journal.log.how
        journal.message = journal.message or journal.log.message
        return journal

    def _take(self, entry: Dict[str, Any]) -> None:
        event = entry["event"]
        if event == "begin":
            self.how, self.exit_status, self.message, self.kind = "", None, "", ""
            self.clock = float(entry.get("clock", 0.0))
        elif event == "fault":
            self.fault = entry
        elif event == "restart":  # what came after that step is computed again
            self.warnings = [each for each in self.warnings if each.step <= entry["step"]]
            self.progress = [each for each in self.progress if each.step <= entry["step"]]
        elif event == "warning":
            self.warnings = [each for each in self.warnings if each.topic != entry["topic"]]
            self.warnings.append(Warned(entry["topic"], entry["text"], entry["step"],
                                        entry["time"]))
        elif event == "progress":
            self.progress.append(Progress(
                entry["step"], entry["time"], entry["wall_time"], entry["peak_slip_rate"],
                entry.get("events"), entry.get("seconds_left"),
                entry.get("knows_cycles", False)))
            self.wall_time = entry["wall_time"]
        elif event == "end":
            self.how, self.exit_status = entry["how"], entry["exit_status"]
            self.message, self.kind = entry["message"], entry.get("kind", "")
            self.wall_time = entry["wall_time"]
