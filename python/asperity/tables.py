"""Tables of a run, such as steps.csv and events.csv: columns by name, in SI units."""

from dataclasses import dataclass
from pathlib import Path
from typing import Dict, Iterator, List

import numpy as np

from .errors import InputError, NoStepYet


@dataclass
class Table:
    """Columns of equal length; `units` has the text in the brackets of the header, or ''."""

    path: Path
    columns: Dict[str, np.ndarray]
    units: Dict[str, str]

    def __len__(self) -> int:
        return len(next(iter(self.columns.values()), ()))

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __contains__(self, name: str) -> bool:
        return name in self.columns

    def __getitem__(self, name: str) -> np.ndarray:
        if name not in self.columns:
            raise InputError(f"{self.path} has no column '{name}'. It has: "
                             f"{', '.join(self.columns)}.")
        return self.columns[name]

    def select(self, rows: np.ndarray) -> "Table":
        """The rows of an index array or a mask."""
        columns = {name: values[rows] for name, values in self.columns.items()}
        return Table(self.path, columns, self.units)


def read_table(path: Path, *required: str) -> Table:
    """Reads a table with a header 'name [unit],...'; InputError unless it has `required`.

    A last line without its end is left out: the run is writing it, or was killed then.
    """
    try:
        lines = path.read_text(encoding="utf-8").split("\n")
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path} cannot be read ({error}).") from error
    rest = lines.pop()
    if rest and not lines:
        raise NoStepYet(f"{path} is not complete: the line with the names of its columns has no "
                         "end. Wait for the run's first checkpoint.")
    header = lines.pop(0).strip() if lines else ""
    if not header:
        raise NoStepYet(f"{path} is empty; it should begin with the names of its columns.")
    names, units = _split_header(header)
    table = Table(path, dict(zip(names, _values(path, lines, len(names)).T)),
                  dict(zip(names, units)))
    for name in required:
        table[name]
    return table


def has_header(path: Path) -> bool:
    """Whether the line with the names of the columns is complete."""
    try:
        with open(path, "rb") as file:
            line = file.readline()
    except OSError:
        return True  # who reads it says why that fails
    return line.endswith(b"\n") and bool(line.strip())


def _split_header(header: str):
    names, units = [], []
    for entry in header.split(","):
        name, _, unit = entry.partition("[")
        names.append(name.strip())
        units.append(unit.strip().rstrip("]"))
    return names, units


def _values(path: Path, lines: List[str], width: int) -> np.ndarray:
    lines = [line for line in lines if line.strip()]
    if not lines:
        return np.empty((0, width))
    try:
        values = np.loadtxt(lines, delimiter=",", ndmin=2, comments=None)
    except ValueError as error:
        reason = str(error).partition(";")[0]  # what follows is advice on calls of NumPy
        raise InputError(f"{path} is damaged: {reason} (the first row below the header "
                         "counts as 1).") from error
    if values.shape[1] != width:
        raise InputError(f"{path} is damaged: its header names {width} columns, its rows have "
                         f"{values.shape[1]}.")
    return values
