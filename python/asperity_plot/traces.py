"""A map of several faults in the plane: their slip, and the peak slip rate of an event."""

from typing import Dict, List, Tuple

import matplotlib
import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import LogNorm, Normalize

from asperity.errors import NothingToShow, OtherModel
from asperity.history import History
from asperity.run import Run

from . import along, fault_maps, style, trace_names, units, windows
from .windows import View

MARKS = {"crossing": "X", "junction": "s", "tip": "o"}  # of `places`
DECADES = 4       # of slip rates below the largest one; slower nodes are light grey
MARGIN = 0.06     # around the traces, as a share of the longer side
SAME_PLACE = 1e-9  # of that side
WIDTH = 6.0       # [inches] of a panel
LETTER = 7.5      # [points] the size of the names


def draw(run: Run, view: View):
    """The figure; OtherModel unless the run has several faults in the plane."""
    traces = along.pieces(run.fault)
    if len(traces) < 2:
        raise OtherModel("the run has a single fault")
    nodes = run.fault.coordinates
    unit = units.length(np.ptp(nodes, axis=0))
    row = _event(run, view)
    figure, panels = _panels(nodes, 1 if row is None else 2)
    slip = slip_within(run.fault, view.sequence)
    shown = units.length(slip)
    _colours(panels[0], traces, unit(nodes), shown(slip), Normalize(0.0, shown(slip).max() or 1.0),
             style.SEQUENCE_COLOURS, f"Slip [{shown.name}]")
    clock = units.duration(view.sequence[1])
    first, last = (units.rounded(time, 4) for time in clock(view.sequence))
    panels[0].set_title(f"From {first} to {last} {clock.name}", loc="left")
    if row is not None:
        onset, end = fault_maps.interval_of(run, row)
        rate = peak_rate(run.fault, onset, end)
        high = 10.0**np.ceil(np.log10(rate.max()))
        _colours(panels[1], traces, unit(nodes), rate, LogNorm(high * 10.0**-DECADES, high),
                 style.RATE_COLOURS, "Peak slip rate [m/s]")
        panels[1].set_title(f"Event {windows.numbers(run.events)[row]} at "
                            f"{units.text(onset, 's', 5)}, lasting "
                            f"{units.text(end - onset, 's')}", loc="left")
        _nucleation(panels[1], run, row, unit)
    _marks(panels[0], run.fault, traces, unit)
    _frame(panels, traces, nodes, unit)
    style.title(figure, f"Traces of {len(traces)} faults")
    return figure


def slip_within(fault: History, window: windows.Window) -> np.ndarray:
    """(nodes) magnitude [m] of the slip in the window."""
    before, after = (fault.at("slip", time).reshape(-1) for time in window)
    return np.abs(after - before)


def peak_rate(fault: History, onset: float, end: float) -> np.ndarray:
    """(nodes) the largest slip rate [m/s] of the rows of an event, and those beside it."""
    return np.max([values.max(axis=0) for _, values in
                   fault.blocks("slip_rate", fault.rows((onset, end)))], axis=0)


def places(fault: History, traces: List[Tuple[str, slice]]) -> Dict[str, np.ndarray]:
    """(n, 2) [m] of each kind in MARKS: the nodes that two faults share without an end of either;
    the ends of faults on others; the ends at which nothing slips."""
    nodes, ends = fault.coordinates, np.zeros(len(fault.coordinates), dtype=bool)
    for _, trace in traces:
        ends[[trace.start, trace.stop - 1]] = True
    size = np.ptp(nodes, axis=0).max() * SAME_PLACE
    _, where, count = np.unique(np.rint(nodes / size), axis=0, return_inverse=True,
                                return_counts=True)
    where = where.reshape(-1)
    is_shared, has_end = count[where] > 1, np.bincount(where, ends)[where] > 0
    rests = slip_within(fault, (fault.time[0], fault.time[-1])) == 0.0
    return {"crossing": np.unique(nodes[is_shared & ~has_end], axis=0),
            "junction": nodes[is_shared & ends],
            "tip": nodes[~is_shared & ends & rests]}


def _event(run: Run, view: View):
    """The row of the event that is shown; None without one in fault.h5."""
    try:
        row = fault_maps.event_row(run, view) if run.has("events.csv") else None
    except NothingToShow:
        return None
    if row is None or fault_maps.interval_of(run, row)[0] >= run.fault.time[-1]:
        return None
    return row


def _panels(nodes: np.ndarray, count: int):
    """Beside each other, or above each other where the traces are wide."""
    width, height = np.ptp(nodes, axis=0) + 2.0 * MARGIN * np.ptp(nodes, axis=0).max()
    if height < 0.5 * width:
        figure, axes = style.panels(count, 1, (1.5 * WIDTH + 1.5, 0.8 + count * (
            0.8 + 1.5 * WIDTH * height / width)), sharex=True)
    else:
        figure, axes = style.panels(1, count, (0.8 + count * (WIDTH + 1.0), 1.2 + min(
            WIDTH * height / width, 9.0)), sharey=True)
    return figure, axes.ravel()


def _colours(axes, traces, nodes: np.ndarray, values: np.ndarray, norm, colours: str,
             label: str) -> None:
    """The traces in the colours of `values` (nodes), with a dark rim; `nodes` as they are drawn."""
    ends = np.concatenate([np.arange(trace.start, trace.stop - 1) for _, trace in traces])
    lines = np.stack((nodes[ends], nodes[ends + 1]), axis=1)
    axes.add_collection(LineCollection(lines, colors=style.DARK, linewidths=5.0,
                                       capstyle="round"))
    picture = axes.add_collection(LineCollection(
        lines, array=0.5 * (values[ends] + values[ends + 1]), norm=norm, linewidths=3.6,
        cmap=matplotlib.colormaps[colours].with_extremes(under="#e8e8e8"), capstyle="round"))
    style.bar_beside(axes, picture).set_label(label)


def _nucleation(axes, run: Run, row: int, unit: units.Unit) -> None:
    """A star where the first node passed the threshold, if the catalogue says where."""
    if "nucleation" in run.events:
        at = run.events["nucleation"][row]
        place = [np.interp(at, run.fault.position, axis) for axis in run.fault.coordinates.T]
        axes.plot(*unit(place), "*", color="white", markeredgecolor="black", markersize=13,
                  label="first fast node", zorder=5)
        _legend(axes)


def _marks(axes, fault: History, traces, unit: units.Unit) -> None:
    for name, found in places(fault, traces).items():
        if len(found):
            axes.plot(*unit(found.T), MARKS[name], color="white", markeredgecolor="black",
                      markersize=5.0, markeredgewidth=0.8, label=name, zorder=5)
    _legend(axes)


def _legend(axes) -> None:
    """Above the panel, beside its title, where it hides no trace."""
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=len(MARKS), fontsize=8,
                handletextpad=0.1, columnspacing=0.8, borderaxespad=0.3)


def _frame(panels, traces, nodes: np.ndarray, unit: units.Unit) -> None:
    """Equal scales, the names of the faults, and labels of the axes."""
    margin = MARGIN * np.ptp(nodes, axis=0).max()
    low, high = unit(nodes.min(axis=0) - margin), unit(nodes.max(axis=0) + margin)
    letter = (high[0] - low[0]) / (72.0 * WIDTH / LETTER)
    names = trace_names.arranged([(name, unit(nodes[trace])) for name, trace in traces], letter)
    for panel in panels:
        panel.set(aspect="equal", xlabel=f"x [{unit.name}]", ylabel=f"y [{unit.name}]",
                  xlim=(low[0], high[0]), ylim=(low[1], high[1]))
        for name in names:
            panel.annotate(name.text, name.place, LETTER * trace_names.GAP * name.upwards,
                           textcoords="offset points", fontsize=LETTER, ha="center",
                           va="bottom" if name.is_above else "top", rotation_mode="anchor",
                           rotation=name.angle)
        panel.label_outer()
