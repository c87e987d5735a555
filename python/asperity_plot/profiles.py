"""Times at which profiles of slip are drawn, and the slip then."""

from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from asperity import durations, wedge
from asperity.history import History
from asperity.run import Run
from asperity.tables import Table

from . import raster, units
from .windows import Window


FIELD = "slip"
BETWEEN, DURING = 5.0 * durations.YEAR, 1.0  # [s], as in the SEAS benchmarks
FEWEST_BETWEEN, FEWEST_DURING = 20, 5        # lines; with fewer, the intervals are shortened
VISIBLE = 0.01  # part of the largest slip that a reader sees


@dataclass(frozen=True)
class Family:
    """Profiles `slip` (n, n_nodes) [m] at `times` (n) [s], one every `interval` [s].

    Slip is interpolated linearly in time between written rows. `num_doubtful` lines are uncertain:
    their rows are further apart than `interval`, and slip differs visibly between them.
    """

    times: np.ndarray
    interval: float
    slip: np.ndarray
    num_doubtful: int


def sign(fault: History) -> float:
    """-1 if the fault slips against its tangent on the whole, so that profiles grow upwards."""
    last = fault.time.size - 1
    return -1.0 if fault.read(FIELD, slice(last, last + 1)).mean() < 0.0 else 1.0


def label(run: Run, unit: units.Unit) -> str:
    """Of an axis of slip; on the wedge the tangent points away from the trench."""
    trenchward = wedge.is_wedge(run.parameters) and sign(run.fault) < 0.0
    return f"{'Trenchward slip' if trenchward else 'Slip'} [{unit.name}]"


def title(run: Run) -> str:
    place = "base of the wedge" if wedge.is_wedge(run.parameters) else "fault"
    return f"Cumulative slip on the {place}"


def family(fault: History, times: np.ndarray, interval: float) -> Family:
    """The slip at `times`, in the direction in which the fault slips on the whole."""
    if not times.size:
        return Family(times, interval, np.empty((0, fault.position.size)), 0)
    slip = sign(fault) * raster.interpolated(fault, FIELD, times)
    return Family(times, interval, slip, _count_doubtful(fault, times, interval, slip))


def _count_doubtful(fault: History, times: np.ndarray, interval: float, slip: np.ndarray) -> int:
    before, after = enclosing(fault.time, times)
    wide = after - before > interval
    if not wide.any():
        return 0
    moved = raster.interpolated(fault, FIELD, after[wide]) \
        - raster.interpolated(fault, FIELD, before[wide])
    return int(np.sum(np.abs(moved).max(axis=1) > VISIBLE * units.largest(slip)))


def enclosing(rows: np.ndarray, times: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """(n) and (n) [s]: the row before and the row after each of `times`; both its own if it is
    a row."""
    before = rows[np.clip(np.searchsorted(rows, times, side="right") - 1, 0, rows.size - 1)]
    after = rows[np.clip(np.searchsorted(rows, times), 0, rows.size - 1)]
    return before, after


def between_events(window: Window, interval: float, events: Optional[Table]) -> np.ndarray:
    """The start of `window` and every `interval` after it, save what falls into an event."""
    count = int(np.floor((window[1] - window[0]) / interval * (1.0 + 1e-12)))
    times = np.minimum(window[0] + interval * np.arange(count + 1), window[1])
    if events is None:
        return times
    inside = np.zeros(times.size, dtype=bool)
    for onset, end in _spans(events):
        inside |= (times >= onset) & (times <= end)
    return times[~inside]


def in_events(window: Window, interval: float, events: Optional[Table]) -> np.ndarray:
    """The onset of each of `events` and every `interval` after it, to its end and in `window`."""
    if events is None or not len(events):
        return np.empty(0)
    times = np.concatenate([np.arange(onset, end, interval) for onset, end in _spans(events)])
    return times[(times >= window[0]) & (times <= window[1])]


def _spans(events: Table) -> np.ndarray:
    return np.stack((events["onset"], events["onset"] + events["duration"]), axis=1)


def intervals(window: Window, events: Optional[Table]) -> Tuple[float, float]:
    """[s] between and in events: 5 years and 1 second, or what suits shorter runs and events."""
    length = window[1] - window[0]
    between, during = BETWEEN, DURING
    if length < FEWEST_BETWEEN * between:
        between = units.nice(length / FEWEST_BETWEEN)
    if events is not None and len(events):
        duration = float(np.median(events["duration"]))
        if 0.0 < duration < FEWEST_DURING * during:
            during = units.nice(duration / FEWEST_DURING)
    return between, during


def events_within(run: Run, window: Window) -> Optional[Table]:
    """All events that overlap `window`, also one cut off by the end; None without a table."""
    if not run.has("events.csv"):
        return None
    events = run.events
    ends = events["onset"] + events["duration"]
    return events.select((ends >= window[0]) & (events["onset"] <= window[1]))
