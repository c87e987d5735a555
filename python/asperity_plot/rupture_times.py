"""When the rupture of each event reached each place on the fault."""

from typing import Tuple

import numpy as np

from asperity.errors import NothingToShow
from asperity.run import Run

from . import along, style, units, windows
from .windows import View


def draw(run: Run, view: View):
    """The figure; NothingToShow without a rupture in the time shown."""
    numbers, arrivals = after_onset(run, view)
    if not numbers.size:
        raise NothingToShow("rupture.h5 has no event in the time shown")
    where = along.axis(run, run.ruptures, "fault")
    clock = units.duration(units.largest(arrivals))
    figure, axes = style.panels(1, 1, (7.5, 5.0))
    colours = style.event_colours(axes[0, 0], numbers)
    # Nodes that no event reached at the ends of the fault would only widen the axis.
    reached = np.flatnonzero(np.isfinite(arrivals).any(axis=0))
    reached = slice(reached[0], reached[-1] + 1)
    shown = run.ruptures.array("geometry/positions")[reached]
    for number, times in zip(numbers, clock(arrivals)[:, reached]):
        where.line(axes[0, 0], shown, times, color=colours(number), marker=".", markersize=2.0,
                   linewidth=0.9)
    style.frame(axes[0, 0], run, where, f"Time since the onset of the event [{clock.name}]")
    if where.is_downwards:
        axes[0, 0].invert_yaxis()
    threshold = float(run.ruptures.array("threshold")[0])
    style.title(figure, f"First time with V ≥ {units.plain(threshold, 'm/s')}")
    return figure


def after_onset(run: Run, view: View) -> Tuple[np.ndarray, np.ndarray]:
    """Numbers (n) of the events that began in the time shown, and (n, n_nodes) arrivals [s]
    since their onsets, nan where they did not arrive."""
    if run.selection and run.has("events.csv"):
        return _of_selected(run, view)
    numbers, onsets = run.ruptures.array("number"), run.ruptures.array("onset")
    rows = windows.within(onsets, view.sequence)
    times = run.ruptures.array("rupture_time")[rows] - onsets[rows, None]
    arrived = np.isfinite(times).any(axis=1)
    return numbers[rows][arrived].astype(int), times[arrived]


def _of_selected(run: Run, view: View) -> Tuple[np.ndarray, np.ndarray]:
    """As `after_onset` of the events that count: first arrivals from onset to end of each."""
    events = run.events.select(windows.within(run.events["onset"], view.sequence))
    times = run.ruptures.array("rupture_time")
    numbers, arrivals = [], []
    for number, onset, duration in zip(windows.numbers(events), events["onset"],
                                       events["duration"]):
        inside = np.where((times >= onset) & (times <= onset + duration), times, np.inf)
        first = inside.min(axis=0, initial=np.inf) - onset
        if np.isfinite(first).any():
            numbers.append(number)
            arrivals.append(np.where(np.isfinite(first), first, np.nan))
    return np.array(numbers, dtype=int), np.array(arrivals).reshape(-1, times.shape[1])
