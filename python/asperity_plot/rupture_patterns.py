"""Rupture fronts of several events side by side, on the part of the fault that they reached."""

from typing import List, Tuple

import numpy as np

from asperity.errors import NothingToShow
from asperity.run import Run

from . import fault_maps, plane, style, units, windows
from .windows import View

MOST = 8      # events shown, the last ones
COLUMNS = 4   # of panels at most
LINES = 4     # of contours in the longest event at least
MARGIN = 0.1  # around what was reached, as a share of its length


def draw(run: Run, view: View):
    """The figure; NothingToShow in two dimensions, or where no front was recorded."""
    if not run.has("rupture.h5"):
        raise NothingToShow("the run has no rupture.h5")
    where = plane.plane(run, run.ruptures)
    rows, fronts = chosen(run, view)
    if not rows:
        raise NothingToShow("no event in the time shown has a rupture front")
    limits = extent(where, fronts)
    columns = min(columns_for(limits), len(rows))
    lines = -(-len(rows) // columns)
    figure, axes = style.panels(lines, columns, _size(limits, lines, columns), sharex=True,
                                sharey=True)
    last = max(float(np.nanmax(front)) for front in fronts)
    unit, step = units.duration(last), units.nice(last / LINES)
    for panel, row, front in zip(axes.flat, rows, fronts):
        colours = fault_maps.contours(panel, where, front, unit, step, last, labels=False)
        panel.set_title(_title(run, row), fontsize=9, pad=16 if len(where.faults) > 1 else None)
        where.label(panel)
        fault_maps.hypocentre(panel, run, row, where)
        panel.label_outer()
        panel.set(xlim=limits[0], ylim=limits[1][::-1])
    for panel in axes.flat[len(rows):]:
        panel.axis("off")
    figure.colorbar(colours, ax=axes, pad=0.02, aspect=30).set_label(
        f"Time since the onset [{unit.name}]\na line every {units.plain(step, 's')}")
    style.title(figure, f"Rupture fronts of {style.counted(len(rows), 'event')}")
    return figure


def chosen(run: Run, view: View) -> Tuple[List[int], List[np.ndarray]]:
    """Rows of the last events of the sequence shown whose fronts crossed a triangle, and these
    fronts [s]."""
    rows, fronts = [], []
    where = plane.plane(run, run.ruptures)
    triangles = where.source[where.triangles]
    for row in windows.within(run.events["onset"], view.sequence):
        front = fault_maps.arrivals(run, row)
        if front is not None and np.isfinite(front)[triangles].all(axis=1).any():
            rows.append(int(row))
            fronts.append(front)
    return rows[-MOST:], fronts[-MOST:]


def extent(where: plane.Plane, fronts: List[np.ndarray]) -> Tuple[np.ndarray, np.ndarray]:
    """Limits along strike and down dip, in the plane's unit, of what any front reached."""
    reached = np.isfinite(fronts).any(axis=0)[where.source]
    limits = []
    for along in (where.strike, where.dip):
        low, high = along[reached].min(), along[reached].max()
        margin = MARGIN * (high - low)
        limits.append(where.unit([max(low - margin, along.min()), min(high + margin, along.max())]))
    return limits[0], limits[1]


def columns_for(limits) -> int:
    """Fewer panels beside each other where they are long along strike, so that each is large."""
    shape = float(np.ptp(limits[1]) / np.ptp(limits[0]))
    return 1 if shape < 0.15 else 2 if shape < 0.6 else COLUMNS


def _size(limits, lines: int, columns: int) -> Tuple[float, float]:
    width = 9.5 / columns
    height = width * np.ptp(limits[1]) / np.ptp(limits[0])
    return 11.0, lines * (min(max(height, 0.6), 4.0) + 0.6) + 1.1


def _title(run: Run, row: int) -> str:
    onset = units.text(float(run.events["onset"][row]), "s", 6)
    text = f"{windows.numbers(run.events)[row]}: {onset}"
    if "magnitude" in run.events:
        text += f", Mw {run.events['magnitude'][row]:.1f}"
    return text
