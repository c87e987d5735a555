"""The interval of a run that the figures show: several cycles, and one rupture among them."""

from dataclasses import dataclass, replace
from typing import Optional, Tuple

import numpy as np

from asperity.errors import InputError
from asperity.run import Run
from asperity.tables import Table

CYCLES = 5.0           # shown around the chosen event
MANY_EVENTS = 40       # more lines, one for each, would merge
LEAD, TRAIL = 1.0, 2.0   # durations of the event before its onset and after its end
SIZEABLE = 0.1           # of the largest event's slip: smaller ones do not choose what is shown
MAGNIFICATION = 5.0      # a zoom that magnifies less is not worth a panel

Window = Tuple[float, float]  # first and last time [s]


@dataclass(frozen=True)
class Options:
    """What the command line says of single figures and tables; by default the figure chooses."""

    intervals: Optional[Window] = None  # [s] of slip profiles, between and in events
    receivers: Tuple[str, ...] = ()     # by name
    references: Tuple[str, ...] = ()    # "FILE" or "RECEIVER=FILE"
    depths: Tuple[float, ...] = ()      # [m] for the table of events


@dataclass(frozen=True)
class View:
    """Intervals of time [s]: `cycles`, and `zoom` into event `number` from `onset` to `end`.

    `sequence` is for figures that show event beside event: all of them, if they are not too many.
    """

    cycles: Window
    zoom: Optional[Window] = None
    onset: float = 0.0
    end: float = 0.0
    number: int = 0
    chosen: bool = False
    num_events: int = 0  # in `cycles`
    sequence: Window = (0.0, 0.0)
    options: Options = Options()

    @property
    def whole_run(self) -> bool:
        return self.number == 0 and not self.chosen


def choose(run: Run, window: Optional[Window], options=Options()) -> View:
    """The user's `window`, or some cycles around a median event of the run's second half."""
    view = _choose(run, window, run.span)
    many = run.has("events.csv") and len(run.events) > MANY_EVENTS
    sequence = view.cycles if view.chosen or many else run.span
    return replace(view, sequence=sequence, options=options,
                   num_events=_count(run, view.cycles))


def _count(run: Run, window: Window) -> int:
    """The events that began in `window`, also one that the end of the run cut off."""
    return within(run.events["onset"], window).size if run.has("events.csv") else 0


def _choose(run: Run, window: Optional[Window], span: Window) -> View:
    events = run.complete_events if run.has("events.csv") else None
    if window is not None:
        _check(window, span)
        window = (max(window[0], span[0]), min(window[1], span[1]))
        index = None if events is None else _median(events, within(events["onset"], window))
        return _view(window, events, index, True)
    if events is None or not len(events):
        return View(span)
    onsets, rows = events["onset"], _sizeable(events)
    index = _median(events, rows[onsets[rows] >= 0.5 * (span[0] + span[1])])
    if index is None:
        index = int(rows[-1])
    return _view(_cycles(_recurrence(run, onsets[rows]), onsets[index], span), events, index, False)


def over_sequence(run: Run, view: View) -> View:
    """The same view with the whole sequence in place of some cycles."""
    return replace(view, cycles=view.sequence, num_events=_count(run, view.sequence))


def _check(window: Window, span: Window) -> None:
    if not window[0] < window[1]:
        raise InputError(f"--window {window[0]:g} {window[1]:g}: the first time must be smaller "
                         "than the second.")
    if window[1] <= span[0] or window[0] >= span[1]:
        raise InputError(f"--window {window[0]:g} {window[1]:g} lies outside the run, which goes "
                         f"from {span[0]:g} s to {span[1]:g} s.")


def within(onsets: np.ndarray, window: Window) -> np.ndarray:
    """The rows of the onsets [s] in `window`."""
    return np.flatnonzero((onsets >= window[0]) & (onsets <= window[1]))


def _sizeable(events: Table) -> np.ndarray:
    """The rows of events that are not tiny beside the largest; in order."""
    size = events["peak_slip" if "peak_slip" in events else "duration"]
    return np.flatnonzero(size >= SIZEABLE * size.max())


def _median(events: Table, rows: np.ndarray) -> Optional[int]:
    """The event of median size among `rows`, by its peak slip if the table has it."""
    if not rows.size:
        return None
    size = events["peak_slip" if "peak_slip" in events else "duration"][rows]
    return int(rows[np.argsort(size, kind="stable")[(rows.size - 1) // 2]])


def _recurrence(run: Run, onsets: np.ndarray) -> Optional[float]:
    """The median time [s] between `onsets`, or between the sizeable events of single faults where
    these have tables; None of a single event."""
    series = [onsets]
    try:
        of_faults = [table["onset"][_sizeable(table)]
                     for table in run.events_of_faults.values() if len(table)]
        series = of_faults if any(each.size > 1 for each in of_faults) else series
    except InputError:
        pass  # the tables of single faults only choose what is shown
    times = np.concatenate([np.diff(each) for each in series])
    return float(np.median(times)) if times.size else None


def _cycles(recurrence: Optional[float], centre: float, span: Window) -> Window:
    """CYCLES recurrence times [s] around `centre` [s], moved and cut to fit the run."""
    if recurrence is None:
        return span
    width = CYCLES * recurrence
    first = min(max(centre - 0.5 * width, span[0]), max(span[1] - width, span[0]))
    return first, min(first + width, span[1])


def numbers(events: Table) -> np.ndarray:
    """What the catalogue calls the events."""
    return events["number"].astype(int) if "number" in events else np.arange(len(events)) + 1


def _view(cycles, events: Optional[Table], index: Optional[int], chosen: bool) -> View:
    if events is None or index is None:
        return View(cycles, chosen=chosen)
    onset, duration = float(events["onset"][index]), float(events["duration"][index])
    zoom = (onset - LEAD * duration, onset + (1.0 + TRAIL) * duration)
    if duration <= 0.0 or zoom[1] - zoom[0] > (cycles[1] - cycles[0]) / MAGNIFICATION:
        zoom = None
    return View(cycles, zoom, onset, onset + duration, int(numbers(events)[index]), chosen)
