"""A fault in three dimensions over time: peak slip rate, and slip rate along a line on strike."""

from typing import Tuple

import numpy as np
from matplotlib.ticker import MaxNLocator

from asperity.run import Run

from . import plane, raster, style, units, windows
from .windows import View

POINTS = 300   # of the line
COLUMNS = 500  # of the picture
DECADES = 12   # below the largest slip rate


def draw(run: Run, view: View):
    """The figure; NothingToShow in two dimensions."""
    where = plane.plane(run, run.fault)
    depth, reason = line_depth(run, where)
    along, weights = line(where, depth)
    times, peak, logarithms = rates(run, view.cycles, where, weights)
    clock = units.duration(view.cycles[1])
    figure, axes = style.panels(2, 1, (9.0, 6.5), sharex=True)
    axes[0, 0].plot(clock(times), 10.0**peak, color=style.BLUE)
    axes[0, 0].axhline(run.threshold, color=style.GREY, linewidth=0.8, linestyle="--")
    axes[0, 0].set(yscale="log", ylabel="Peak slip rate [m/s]")
    axes[0, 0].grid(True)
    top = np.ceil(logarithms.max())
    limits = raster.edges((float(times[0]), float(times[-1])), COLUMNS)
    picture = axes[1, 0].pcolormesh(
        clock(limits), raster.midpoints(where.unit(along)), maxima(times, logarithms, limits).T,
        rasterized=True, cmap=style.RATE_COLOURS, vmax=top,
        vmin=max(np.floor(logarithms.min()), top - DECADES))
    figure.colorbar(picture, ax=axes[:, 0], pad=0.02, ticks=MaxNLocator(8, integer=True)) \
        .set_label("log10 of the slip rate [m/s]")
    axes[1, 0].set(xlabel=f"Time [{clock.name}]", ylabel=f"Along strike [{where.unit.name}]")
    style.title(figure, "Largest slip rate anywhere, and slip rate along strike")
    axes[0, 0].set_title("Anywhere on the fault")
    axes[1, 0].set_title(f"{units.text(depth, 'm')} down dip, at {reason}")
    return figure


def maxima(times: np.ndarray, values: np.ndarray, limits: np.ndarray) -> np.ndarray:
    """(columns, points): the largest value of the rows in each column, so that no event is lost
    between two, or that of the row before where there is none."""
    first = np.searchsorted(times, limits[:-1]).clip(max=times.size - 1)
    last = np.searchsorted(times, limits[1:])
    return np.stack([values[i:j].max(axis=0) if j > i else values[max(i - 1, 0)]
                     for i, j in zip(first, last)])


def line_depth(run: Run, where: plane.Plane) -> Tuple[float, str]:
    """Down dip [m] of the hypocentre of the largest event, or of the middle of the fault; and which
    of the two it is."""
    middle = 0.5 * float(where.dip.max()), "the middle of the fault"
    if not run.has("events.csv") or not len(run.events) or "hypocentre_x" not in run.events:
        return middle
    row = int(np.argmax(run.events["peak_slip"]))
    place = [run.events[f"hypocentre_{axis}"][row] for axis in "xyz"]
    number = windows.numbers(run.events)[row]
    return (float(where.dip[np.argmin(np.linalg.norm(where.nodes - place, axis=1))]),
            f"the hypocentre of the largest event, {number}")


def line(where: plane.Plane, depth: float) -> Tuple[np.ndarray, np.ndarray]:
    """Distances along strike [m] of the points of the line within the fault, and the matrix
    (points, drawn nodes) of linear interpolation there."""
    mesh = plane.Triangulation(where.strike, where.dip, where.triangles)
    inset = 1e-6 * np.ptp(where.strike)
    points = np.linspace(where.strike.min() + inset, where.strike.max() - inset, POINTS)
    deep = float(np.clip(depth, 1e-6 * where.dip.max(), (1.0 - 1e-6) * where.dip.max()))
    found = mesh.get_trifinder()(points, np.full(POINTS, deep))
    points, corners = points[found >= 0], where.triangles[found[found >= 0]]
    weights = np.zeros((points.size, where.strike.size))
    system = np.stack((where.strike[corners], where.dip[corners], np.ones(corners.shape)), axis=1)
    sides = np.stack((points, np.full(points.size, deep), np.ones(points.size)), axis=1)
    np.put_along_axis(weights, corners, np.linalg.solve(system, sides[..., None])[..., 0], axis=1)
    return points, weights


def rates(run: Run, window, where: plane.Plane, weights: np.ndarray):
    """Times [s] in the window, log10 of the peak slip rate and of that at the points."""
    rows = run.fault.rows(window)
    time, peak, along = run.fault.time[rows], [], []
    for row in range(rows.start, rows.stop):
        rate = run.fault.array("fields/slip_rate", slice(row, row + 1))[0]
        peak.append(rate.max())
        along.append(weights @ rate[where.source])
    return time, raster.log10(np.array(peak)), raster.log10(np.array(along))
