"""The opening of faults in the plane over position and time, where and while they are open."""

from dataclasses import replace
from typing import Tuple

import numpy as np
from matplotlib.colors import Normalize

from asperity.errors import NothingToShow, OtherModel
from asperity.history import History
from asperity.run import Run

from . import along, maps, raster, style, units
from .windows import View, Window

FIELD = "opening"
SMALL = 1e-3   # of the largest opening: less does not choose what is shown
MARGIN = 0.15  # around what is open, as a share of its extent


def draw(run: Run, view: View):
    """The figure; OtherModel if no fault may open, NothingToShow if none is open."""
    if FIELD not in run.fault.fields:
        raise OtherModel(f"fault.h5 has no field '{FIELD}'")
    run.fault.require_two_times()
    window, is_open = shown(run.fault, view.sequence)
    faults = [_near(run.fault, where, is_open)
              for where in along.faults(run, run.fault) if is_open[where.nodes].any()]
    limits = raster.edges(window, maps.COLUMNS)
    values = np.maximum(raster.interpolated(run.fault, FIELD, raster.centres(limits)), 0.0)
    unit, clock = units.length(values), units.duration(window[1])
    figure, axes = style.panels(len(faults), 1, (9.0, 1.4 + 3.0 * len(faults)), sharex="col")
    for row, where in zip(axes, faults):
        maps.position_axis(row, where)
        picture = maps.colours(row[0], clock(limits), run.fault, unit(values), where,
                               norm=Normalize(0.0, unit(values).max()),
                               cmap=style.SEQUENCE_COLOURS)
    axes[-1, 0].set_xlabel(f"Time [{clock.name}]")
    figure.colorbar(picture, ax=axes, pad=0.02).set_label(f"Opening [{unit.name}]")
    style.title(figure, f"Opening of the fault{'s' if len(faults) > 1 else ''}")
    return figure


def shown(fault: History, sequence: Window) -> Tuple[Window, np.ndarray]:
    """The time in which some node is open, and (nodes) which ones are open at some time."""
    rows = fault.rows(sequence)
    opening = fault.read(FIELD, rows)
    is_open = opening > max(SMALL * opening.max(), 0.0)
    if not is_open.any():
        raise NothingToShow("the fault does not open")
    times = fault.time[rows][is_open.any(axis=1)]
    margin = MARGIN * (times[-1] - times[0])
    window = (max(times[0] - margin, sequence[0]), min(times[-1] + margin, sequence[1]))
    return (window if window[0] < window[1] else sequence), is_open.any(axis=0)


def _near(fault: History, where: along.Axis, is_open: np.ndarray) -> along.Axis:
    """The axis of a fault, around its nodes that open."""
    places = fault.position[where.nodes][is_open[where.nodes]]
    low, high = where.limits
    margin = max(MARGIN * (places[-1] - places[0]), SMALL * (high - low))
    limits = max(places[0] - margin, low), min(places[-1] + margin, high)
    return replace(where, limits=limits, unit=units.length(where.metres(limits)))
