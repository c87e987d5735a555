"""Fields at nonuniform times, resampled to the even columns of a picture.

Steps differ by orders of magnitude in size. On an axis of several cycles thousands of steps share
one column of the picture; the functions here define which value it shows.
"""

from typing import Optional

import numpy as np

from asperity.history import History

from .windows import Window


def edges(window: Window, columns: int) -> np.ndarray:
    """The limits of `columns` even columns."""
    return np.linspace(window[0], window[1], columns + 1)


def centres(limits: np.ndarray) -> np.ndarray:
    return 0.5 * (limits[1:] + limits[:-1])


def along(positions: np.ndarray, values: np.ndarray, where: np.ndarray) -> np.ndarray:
    """(times, where): `values` (times, nodes) linear between nodes, as P1 elements have it.

    Where two nodes are at one place, values jump, and the place itself has those of the first.
    """
    right = np.clip(np.searchsorted(positions, where), 1, positions.size - 1)
    length = positions[right] - positions[right - 1]
    weight = (where - positions[right - 1]) / np.where(length > 0.0, length, 1.0)
    return (1.0 - weight) * values[:, right - 1] + weight * values[:, right]


def midpoints(times: np.ndarray) -> np.ndarray:
    """Limits of cells around the true `times` of rows, (n + 1) for n > 1 rows."""
    inner = 0.5 * (times[1:] + times[:-1])
    return np.concatenate(([times[0]], inner, [times[-1]]))


def interpolated(history: History, field: str, times: np.ndarray,
                 direction: Optional[np.ndarray] = None, transform=None) -> np.ndarray:
    """(times, nodes): `field` linear in time between its rows, `transform`ed before that."""
    result = np.empty((times.size, history.position.size))
    right = np.clip(np.searchsorted(history.time, times), 1, max(history.time.size - 1, 1))
    rows = slice(int(right.min()) - 1, min(int(right.max()) + 1, history.time.size))
    previous = None
    for part, values in history.blocks(field, rows, direction):
        values = values if transform is None else transform(values)
        # The row before the block belongs to it: a time may lie between two blocks.
        joined = values if previous is None else np.concatenate((previous, values))
        offset = part.start if previous is None else part.start - 1
        _interpolate(history.time, times, right, offset, joined, result)
        previous = values[-1:]
    return result


def _interpolate(row_times, times, right, offset, values, result) -> None:
    if row_times.size == 1:
        result[:] = values[0]
        return
    mine = np.flatnonzero((right - 1 >= offset) & (right < offset + len(values)))
    after, before = right[mine], right[mine] - 1
    weight = (times[mine] - row_times[before]) / (row_times[after] - row_times[before])
    weight = np.clip(weight, 0.0, 1.0)[:, None]
    result[mine] = (1.0 - weight) * values[before - offset] + weight * values[after - offset]


def maxima(history: History, field: str, window: Window, columns: int) -> np.ndarray:
    """(columns, nodes): log10 of the largest value of `field` within each column of `window`.

    A column between two rows has their interpolation, so that neither short events nor long steps
    leave gaps. Values <= 0 count as the smallest positive number.
    """
    limits = edges(window, columns)
    result = interpolated(history, field, centres(limits), transform=log10)
    for part, values in history.blocks(field, history.rows(window)):
        column = np.searchsorted(limits, history.time[part], side="right") - 1
        inside = (column >= 0) & (column < columns)
        if inside.any():
            starts = np.flatnonzero(np.diff(column[inside], prepend=-1))
            largest = np.maximum.reduceat(log10(values[inside]), starts, axis=0)
            target = column[inside][starts]
            result[target] = np.maximum(result[target], largest)
    return result


def log10(values: np.ndarray) -> np.ndarray:
    """log10 for every slip rate V >= 0; V = 0 counts as the smallest positive number."""
    return np.log10(np.maximum(values, np.finfo(float).tiny))
