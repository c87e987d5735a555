"""The log of a run, as text: what it ran on, how it ended. A restart appends its own."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import List

from .errors import InputError

_BEGIN = re.compile(r"Asperity (\S+) on .*\.$")
# Of the mesh, the time steps and how well the fault is resolved; told once, before the first step.
_MODEL = ("Mesh: ", "Resolution ", "Nucleation length", "Disturbances of steady slip",
          "Cells beside the fault", "Memory: ")
_MACHINE = ("Kokkos ", "Built from ", "Machine: ")
_ENDS = {"Finished at t = ": "finished", "Stopped at t = ": "stopped"}
_FAILED, _WARNING = "The run has ended: ", "WARNING: "


@dataclass
class RunLog:
    """`how` the last process ended: 'finished', 'stopped' or 'failed', and '' without an end."""

    processes: int = 0
    environment: List[str] = field(default_factory=list)  # of the last process
    model: List[str] = field(default_factory=list)        # size and resolution, of the last process
    how: str = ""
    message: str = ""                                     # why the last process has failed
    report: List[str] = field(default_factory=list)       # the lines from its end on
    warnings: List[str] = field(default_factory=list)     # of all processes, each text once

    @classmethod
    def read(cls, path: Path) -> "RunLog":
        """InputError if there is no log; a last line without its end is left out."""
        try:
            lines = path.read_text(encoding="utf-8", errors="replace").split("\n")[:-1]
        except OSError as error:
            raise InputError(f"{path} cannot be read ({error.strerror}). Give the folder in which "
                             "a run of asperity writes its results.") from error
        log = cls()
        for line in lines:
            log._take(line)
        log.warnings = list(dict.fromkeys(log.warnings))
        return log

    @property
    def version(self) -> str:
        """Of the program, in the last process; 'unknown' without one."""
        return _BEGIN.fullmatch(self.environment[0])[1] if self.environment else "unknown"

    @property
    def work(self) -> List[List[str]]:
        """The table at the end: a kind of work, least and most seconds of a rank, share, count."""
        rows = [re.split(r"\s{2,}", line) for line in self.report]
        return [row for row in rows if len(row) == 5 and row[3].endswith(" %")]

    def _take(self, line: str) -> None:
        if _BEGIN.fullmatch(line):
            self.processes += 1
            self.environment, self.how, self.message, self.report = [line], "", "", []
            self.model = []
        elif self.processes and line.startswith(_MACHINE):
            self.environment.append(line)
        elif not self.how and line.startswith(_MODEL):
            self.model.append(line)
        elif line.startswith(_FAILED):
            self.how, self.message = "failed", line[len(_FAILED):]
        elif line.startswith(_WARNING):
            self.warnings.append(line[len(_WARNING):])
        elif not self.how:
            self.how = next((how for words, how in _ENDS.items() if line.startswith(words)), "")
        if self.how:
            self.report.append(line)
