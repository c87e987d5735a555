"""Maps of one event on a fault in three dimensions: its slip, and its rupture front."""

from typing import Optional, Tuple

import numpy as np
from matplotlib.tri import Triangulation

from asperity.errors import NothingToShow
from asperity.run import Run

from . import plane, style, units, windows
from .windows import View

LINES = 12  # of contours at most, about


def draw(run: Run, view: View):
    """The figure; NothingToShow in two dimensions or without an event in the time shown."""
    where = plane.plane(run, run.ruptures if run.has("rupture.h5") else run.fault)
    row = event_row(run, view)
    onset, end = interval_of(run, row)
    if onset >= run.fault.time[-1]:
        raise NothingToShow("fault.h5 ends before the event: a run that goes on writes it with its "
                            "next checkpoint")
    slip = event_slip(run, onset, end)
    figure, panels = _panels(where)
    _colours(panels[0], where, slip, units.length(slip), "Slip in the event")
    front = arrivals(run, row)
    if front is not None:
        _front(panels[1], where, front)
    for panel in panels:
        where.label(panel)
        hypocentre(panel, run, row, where)
        _legend(panel)
    number = windows.numbers(run.events)[row]
    size = f", Mw {run.events['magnitude'][row]:.2f}" if "magnitude" in run.events else ""
    style.title(figure, f"Event {number} at {units.text(onset, 's', 5)}, lasting "
                        f"{units.text(end - onset, 's')}{size}")
    return figure


def hypocentre(panel, run: Run, row: int, where: plane.Plane) -> None:
    """A star where the first node passed the threshold, if the catalogue says where."""
    names = [f"hypocentre_{axis}" for axis in "xyz"]
    if all(name in run.events for name in names):
        place = where.place([run.events[name][row] for name in names])
        panel.plot(*place, "*", color="white", markeredgecolor="black", markersize=12,
                   label="hypocentre", clip_on=False, zorder=5)


def _legend(panel) -> None:
    if panel.get_legend_handles_labels()[0]:
        panel.legend(loc="lower right", fontsize=8, frameon=True, facecolor="white", framealpha=0.9)


def _panels(where: plane.Plane):
    """Two panels, above each other where the fault is long along strike, or else side by side."""
    shape = float(np.ptp(where.dip) / np.ptp(where.strike))
    if shape < 0.6:
        figure, axes = style.panels(2, 1, (8.5, 1.6 + 12.0 * max(shape, 0.15)), sharex=True)
    else:
        figure, axes = style.panels(1, 2, (10.5, 1.2 + min(4.2 * shape, 8.0)), sharey=True)
    return figure, axes.ravel()


def event_row(run: Run, view: View) -> int:
    """Of the event that the zoom shows, or else the largest."""
    events = run.events
    if not len(events):
        raise NothingToShow("the run has no event")
    if view.zoom is not None:
        return int(np.flatnonzero(windows.numbers(events) == view.number)[0])
    return int(np.argmax(events["peak_slip"]))


def interval_of(run: Run, row: int) -> Tuple[float, float]:
    """Onset and end [s] of an event by its row in the catalogue."""
    onset = float(run.events["onset"][row])
    return onset, onset + float(run.events["duration"][row])


def event_slip(run: Run, onset: float, end: float) -> np.ndarray:
    """(nodes) magnitude [m] of the slip from onset to end, linear between the rows of fault.h5."""
    before, after = (run.fault.at("slip", at) for at in (onset, end))
    return np.linalg.norm(after - before, axis=-1)


def arrivals(run: Run, row: int) -> Optional[np.ndarray]:
    """(nodes) arrival of the front of an event [s], 0 at the first node; nan where it did not come
    between the end of the event before and the end of this one. Ruptures have their own threshold,
    so that one rupture may go on through several events."""
    if not run.has("rupture.h5"):
        return None
    onset, end = interval_of(run, row)
    before = interval_of(run, row - 1)[1] if row > 0 else -np.inf
    for times in run.ruptures.array("rupture_time"):
        inside = (times > before) & (times <= end)
        if inside.any() and times[inside].max() >= onset:
            return np.where(inside, times - times[inside].min(), np.nan)
    return None


def _colours(axes, where: plane.Plane, values, unit: units.Unit, name: str) -> None:
    shown = unit(values[where.source])
    picture = axes.tripcolor(where.triangulation, shown, shading="gouraud", rasterized=True,
                             cmap=style.SEQUENCE_COLOURS)
    if np.ptp(shown) > 0.0:
        axes.tricontour(where.triangulation, shown, levels=LINES // 2, colors="white",
                        linewidths=0.6)
    style.bar_beside(axes, picture).set_label(f"{name} [{unit.name}]")


def reached_part(where: plane.Plane, front: np.ndarray):
    """A triangulation of what the front reached, and its arrivals there; None and nan without a
    whole triangle. The border is where a mean over neighbours of 1 at nodes that it reached, and 0
    at others, is a half: not along the edges of triangles, which make stairs."""
    mesh = where.triangulation
    reached = np.isfinite(front)
    if not reached[mesh.triangles].all(axis=1).any():
        return None, np.nan
    share = _means(mesh, _means(mesh, reached.astype(float)))
    known = np.where(reached, front, _means(mesh, front, reached))
    inside = (share >= 0.5) & np.isfinite(known)
    values = np.where(inside, known, 0.0)
    places = [np.stack((mesh.x, mesh.y), axis=1)]
    arrivals, first = [values], mesh.x.size
    count = inside[mesh.triangles].sum(axis=1)
    triangles = [mesh.triangles[count == 3]]
    for corners, new in ((2, ((0, 1, 3), (0, 3, 4))), (1, ((0, 3, 4),))):
        part = mesh.triangles[count == corners]
        order = np.argsort(~inside[part], axis=1, kind="stable")
        part = np.take_along_axis(part, order, axis=1)  # those inside first
        near = part[:, [1, 0]] if corners == 2 else part[:, [0, 0]]
        far = part[:, [2, 2]] if corners == 2 else part[:, [1, 2]]
        cut = np.clip((share[near] - 0.5) / np.maximum(share[near] - share[far], 1e-9), 0.0, 1.0)
        places.append(((1.0 - cut)[..., None] * places[0][near]
                       + cut[..., None] * places[0][far]).reshape(-1, 2))
        arrivals.append(values[near].ravel())
        added = first + np.arange(2 * len(part)).reshape(-1, 2)
        triangles += [np.concatenate((part, added), axis=1)[:, list(each)] for each in new]
        first += 2 * len(part)
    points = np.concatenate(places)
    return Triangulation(points[:, 0], points[:, 1], np.concatenate(triangles)), \
        np.concatenate(arrivals)


def _means(mesh: Triangulation, values: np.ndarray, of: Optional[np.ndarray] = None) -> np.ndarray:
    """(nodes) the mean of a node and its neighbours, of those in `of` alone; nan without any."""
    weights = np.ones(values.size) if of is None else of.astype(float)
    filled = np.where(weights > 0.0, values, 0.0)
    ends = np.concatenate((mesh.edges, mesh.edges[:, ::-1]))
    total, number = weights * filled, weights.copy()
    np.add.at(total, ends[:, 0], (weights * filled)[ends[:, 1]])
    np.add.at(number, ends[:, 0], weights[ends[:, 1]])
    return np.divide(total, number, out=np.full(values.size, np.nan), where=number > 0.0)


def interval(front: np.ndarray) -> float:
    """The time [s] between two contours: 1, 2 or 5 times a power of ten."""
    return units.nice(max(float(np.nanmax(front) - np.nanmin(front)), 1e-9) / (LINES / 2.0))


def contours(axes, where: plane.Plane, front: np.ndarray, unit: units.Unit, step: float,
             last: float, labels: bool = True):
    """Colours of the arrival from 0 to `last` [s] and a line every `step` [s], of `reached_part`.
    The colours, for a colour bar; None without any triangle."""
    mesh, values = reached_part(where, front[where.source])
    if mesh is None:
        return None
    shown = unit(values)
    picture = axes.tripcolor(mesh, shown, shading="gouraud", cmap="cividis", rasterized=True,
                             vmin=0.0, vmax=float(unit(last)))
    levels = unit(np.arange(np.ceil(np.nanmin(front) / step), np.nanmax(front) / step + 1.0) * step)
    lines = axes.tricontour(mesh, shown, levels=levels, colors="white", linewidths=0.8)
    if labels:
        axes.clabel(lines, fontsize=7, fmt="%g")
    return picture


def _front(axes, where: plane.Plane, front: np.ndarray) -> None:
    last, step = units.largest(front), interval(front)
    unit = units.duration(last)
    picture = contours(axes, where, front, unit, step, last)
    if picture is None:
        axes.set_title("The front crossed no triangle", fontsize=9)
        return
    axes.set_title(f"Rupture front every {units.plain(step, 's')}", fontsize=9)
    style.bar_beside(axes, picture).set_label(
        f"Time since the onset [{unit.name}]")
