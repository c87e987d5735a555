"""run.jsonl: the course of a run, one JSON object a line (packages/io/files/RunJournal.hpp)."""

import json
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Optional


@dataclass(frozen=True)
class Warned:
    """A warning of the run: what it is about, its sentences, and when it was given."""

    topic: str
    text: str
    step: int
    time: float


@dataclass
class Journal:
    """`how` is '' while there is no end: 'finished', 'stopped', 'failed', of the last process."""

    warnings: List[Warned] = field(default_factory=list)  # the last one of each topic
    how: str = ""
    exit_status: Optional[int] = None
    message: str = ""
    walls: List[Optional[float]] = field(default_factory=list)  # [s] of each process, if it ended

    @classmethod
    def read(cls, path: Path) -> "Journal":
        """Empty if there is none; what is no complete line is left out."""
        journal = cls()
        try:
            lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
        except OSError:
            lines = []
        for line in lines:
            try:
                journal._take(json.loads(line))
            except (ValueError, KeyError, TypeError):
                continue
        return journal

    def _take(self, entry: Dict[str, Any]) -> None:
        event = entry["event"]
        if event == "begin":
            self.how, self.exit_status, self.message = "", None, ""
            self.walls.append(None)
        elif event == "restart":  # what came after that step is computed again
            self.warnings = [each for each in self.warnings if each.step <= entry["step"]]
        elif event == "warning":
            self.warnings = [each for each in self.warnings if each.topic != entry["topic"]]
            self.warnings.append(Warned(entry["topic"], entry["text"], entry["step"],
                                        entry["time"]))
        elif event == "end":
            self.how, self.exit_status = entry["how"], entry["exit_status"]
            self.message = entry["message"]
            self.walls[-1:] = [entry["wall"]]
