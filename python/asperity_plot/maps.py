"""What the maps over position and time share: the two panels, their axes and titles."""

from typing import List, Optional, Sequence, Tuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from asperity.history import History

from . import raster, style, units
from .along import FROM_UPPER_END, Axis
from .windows import View

COLUMNS = 500    # of the picture of several cycles: two pixels each, to be visible
POSITIONS = 500  # its rows
HIGH, LOW = 3.0, 1.0  # [inches] of the panels of few and of many faults


def panels(view: View, heights: Sequence[float] = (1.0,)) -> Tuple[Figure, np.ndarray]:
    """(heights, 1 or 2) one panel for the cycles and, if the view has one, a second for the
    rupture, in a row of each of the relative `heights`."""
    widths = [1.0] if view.zoom is None else [1.25, 1.0]
    lines = len(heights)
    size = 11.0, 4.6 if lines == 1 else 2.0 + lines * (LOW if are_low(lines) else HIGH)
    figure, axes = style.panels(lines, len(widths), size, sharey="row", gridspec_kw={
        "width_ratios": widths, "height_ratios": np.maximum(heights, 0.4 * max(heights))})
    for panel in axes.flat:
        for spine in panel.spines.values():
            spine.set_visible(True)
    return figure, axes


def colours(axes: Axes, times: np.ndarray, history: History, values: np.ndarray, along: Axis,
            smooth: bool = False, **options):
    """Colours for `values` (times, nodes): between the limits `times` of their cells, or, if they
    are `smooth`, linear in time between rows at `times`."""
    limits = raster.edges(along.limits, POSITIONS)
    places = raster.centres(limits)
    picture = raster.along(history.position[along.nodes], values[:, along.nodes], places)
    return axes.pcolormesh(times, along(places if smooth else limits), picture.T, rasterized=True,
                           shading="gouraud" if smooth else "flat", **options)


def time_axes(axes: np.ndarray, view: View) -> None:
    """Titles of the upper panels and labels of the lower ones; the zoom counts from the event's
    onset."""
    label_cycles(axes[0, 0], view, axes[-1, 0])
    if view.zoom is not None:
        label_zoom(axes[0, 1], view, axes[-1, 1])
    for panel in axes[1:].flat:
        panel.set_xlim(axes[0, 0 if panel in axes[:, 0] else 1].get_xlim())
    for panel in axes[:-1].flat if are_low(len(axes)) else ():
        panel.tick_params(labelbottom=False)


def label_cycles(axes: Axes, view: View, below: Optional[Axes] = None) -> None:
    """The label of the time stands at the lowest panel of the same column, `below`."""
    unit = cycles_unit(view)
    axes.set_xlim(unit(view.cycles))
    axes.set_title(cycles_title(view))
    (below or axes).set_xlabel(f"Time [{unit.name}]")
    if view.zoom is not None:
        # A small mark on the time axis says where the zoom is.
        axes.plot(unit(view.onset), 1.0, marker="v", color=style.DARK, markersize=5,
                  transform=axes.get_xaxis_transform(), clip_on=False, zorder=5)


def label_zoom(axes: Axes, view: View, below: Optional[Axes] = None) -> None:
    unit = zoom_unit(view)
    axes.set_xlim(unit(np.array(view.zoom) - view.onset))
    axes.set_title(zoom_title(view))
    (below or axes).set_xlabel(f"Time since the onset of event {view.number} [{unit.name}]")


def cycles_title(view: View) -> str:
    length = units.text(view.cycles[1] - view.cycles[0], "s")
    events = style.counted(view.num_events, "event")
    return f"The whole run: {events} in {length}" if view.whole_run else f"{events} in {length}"


def zoom_title(view: View) -> str:
    start = units.text(view.onset, "s", 5)
    return f"Zoom into event {view.number} at {start} (▾), lasting " \
           f"{units.text(view.end - view.onset, 's')}"


def cycles_unit(view: View) -> units.Unit:
    return units.duration(view.cycles[1])


def zoom_unit(view: View) -> units.Unit:
    return units.duration(max(abs(view.zoom[0] - view.onset), view.zoom[1] - view.onset))


def position_axis(axes: Sequence[Axes], along: Axis, is_low: bool = False) -> None:
    """Labels the shared axis of positions; depth grows downwards. The label of one of several
    faults begins with its name, beside a panel that `is_low` it is the name alone."""
    label = along.label
    if along.title:
        label = style.wrapped(along.title, 14) if is_low else \
            f"{along.title}\n{style.wrapped(label)}"
    axes[0].set_ylabel(label)
    axes[0].set_ylim(along.range)


def are_low(lines: int) -> bool:
    """Whether the panels of so many faults share one label of their positions."""
    return lines > style.FEW_FAULTS


def common_label(figure: Figure, faults: Sequence[Axis]) -> None:
    """That of the positions on all faults, beside low panels."""
    labels = {where.label for where in faults}
    figure.supylabel(labels.pop() if len(labels) == 1 else
                     f"{FROM_UPPER_END} [{faults[0].unit.name}]")
