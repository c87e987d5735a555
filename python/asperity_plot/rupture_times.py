"""When the rupture of each event reached each place on the fault."""

from dataclasses import replace
from typing import Optional, Tuple

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
    faults = [where for where in (_reached(each, arrivals) for each in
                                  along.alike(along.faults(run, run.ruptures)))
              if where is not None]
    clock = units.duration(units.largest(arrivals))
    figure, axes = style.fault_panels(faults, (7.5, 5.0))
    colours = style.event_colours(style.upper_right(axes), numbers)
    positions = run.ruptures.array("geometry/positions")
    for panel, where in zip(axes, faults):
        for number, times in zip(numbers, clock(arrivals)):
            where.line(panel, positions, times, color=colours(number), marker=".", markersize=2.0,
                       linewidth=0.9)
        style.frame(panel, run, where, f"Time since the onset of the event [{clock.name}]")
        if where.is_downwards:
            panel.invert_yaxis()
    style.share_labels(axes)
    threshold = float(run.ruptures.array("threshold")[0])
    style.title(figure, f"First time with V ≥ {units.plain(threshold, 'm/s')}")
    return figure


def _reached(where: along.Axis, arrivals: np.ndarray) -> Optional[along.Axis]:
    """The axis without the nodes at its ends that no event reached; None of a fault that none
    reached."""
    reached = np.flatnonzero(np.isfinite(arrivals[:, where.nodes]).any(axis=0))
    if not reached.size:
        return None
    first = where.nodes.start or 0
    return replace(where, nodes=slice(first + int(reached[0]), first + int(reached[-1]) + 1))


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
