"""What a platform's checker asks of the numbers of a file, whose rows are whole."""

from typing import Iterator, List, Tuple

import numpy as np

from .problem import PROFILES, RUPTURE, FileKind
from .textfile import TextFile

Fault = Tuple[int, str]  # a line and what is wrong there


def faults(file: TextFile, kind: FileKind, has_equal_steps: bool) -> List[Fault]:
    values = np.array([text.split() for _, text in file.rows], dtype=float)
    lines = [line for line, _ in file.rows]
    found: List[Fault] = []
    if kind.source == PROFILES:
        found += _positions(lines, values)
        lines, values = lines[1:], values[1:]
    if kind.source == RUPTURE:
        found += _places(lines, values)
    else:
        found += _times(file, lines, values[:, 0], has_equal_steps and kind.is_station)
    return found or list(_columns(lines, values, kind))


def _positions(lines: List[int], values: np.ndarray) -> Iterator[Fault]:
    """Of the first row of a profile: two zeros, then the places of the other columns."""
    if values[0, :2].any() or values.shape[1] < 3:
        yield lines[0], "the row of places does not begin with two zeros"
    elif (np.diff(values[0, 2:]) <= 0.0).any():
        column = int(np.argmax(np.diff(values[0, 2:]) <= 0.0)) + 4
        yield lines[0], f"column {column}: places do not increase"


def _places(lines: List[int], values: np.ndarray) -> Iterator[Fault]:
    order = np.lexsort((values[:, 1], values[:, 0]))
    same = (np.diff(values[order, :2], axis=0) == 0.0).all(axis=1)
    if same.any():
        row = max(order[np.argmax(same)], order[np.argmax(same) + 1])
        yield lines[row], f"the place ({values[row, 0]:g}, {values[row, 1]:g}) stands twice"


def _times(file: TextFile, lines: List[int], times: np.ndarray,
           has_equal_steps: bool) -> Iterator[Fault]:
    steps = np.diff(times)
    if (steps <= 0.0).any():
        row = int(np.argmax(steps <= 0.0)) + 1
        yield lines[row], f"column 1 (t): {times[row]:.10g} s follows {times[row - 1]:.10g} s"
    elif has_equal_steps:
        yield from _spacing(file, lines, steps)
        yield from _count(file, len(times))


def _spacing(file: TextFile, lines: List[int], steps: np.ndarray) -> Iterator[Fault]:
    line, text = file.keys["time_step"]
    try:
        step = float(text.split()[0])
    except ValueError:
        step = np.nan
    if not step > 0.0:
        yield line, f"time_step={text} is no time"
        return
    odd = np.abs(steps - step) > 1e-4 * step
    if odd.any():
        row = int(np.argmax(odd))
        yield lines[row + 1], (f"column 1 (t): {steps[row]:g} s after the row before; all rows "
                               f"must be {step:g} s apart, the time_step of the header")


def _count(file: TextFile, count: int) -> Iterator[Fault]:
    line, text = file.keys["num_time_steps"]
    if text != str(count):
        yield line, f"num_time_steps={text}, but there are {count} rows"


def _columns(lines: List[int], values: np.ndarray, kind: FileKind) -> Iterator[Fault]:
    """The last column of a profile stands for all further ones."""
    for i in range(values.shape[1]):
        column = kind.columns[min(i, len(kind.columns) - 1)]
        fault = column.fault(values[:, i])
        if fault:
            yield lines[fault[0]], f"column {i + 1} ({column.name}): {fault[1]}"
            return
