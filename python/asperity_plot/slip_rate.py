"""Slip rate over position and time: several cycles, and a zoom into one rupture."""

from typing import Tuple

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize
from matplotlib.ticker import FuncFormatter, MaxNLocator

from asperity import wedge
from asperity.run import Run

from . import along, maps, raster, style
from .windows import View

FIELD = "slip_rate"
DECADES = 12  # below the largest slip rate: from ruptures to what is locked below plate rates


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    run.fault.require_two_times()
    cycles = raster.maxima(run.fault, FIELD, view.cycles, maps.COLUMNS)
    norm = _norm(cycles)
    faults = along.faults(run, run.fault)
    figure, axes = maps.panels(view, [np.ptp(each.limits) for each in faults])
    times = maps.cycles_unit(view)(raster.edges(view.cycles, maps.COLUMNS))
    lines, is_low = None, maps.are_low(len(faults))
    if is_low:
        maps.common_label(figure, faults)
    for row, where in zip(axes, faults):
        maps.position_axis(row, where, is_low)
        mesh = maps.colours(row[0], times, run.fault, cycles, where, norm=norm,
                            cmap=style.RATE_COLOURS)
        if view.zoom is not None:
            lines = _zoom(run, view, row[1], where, norm)
        for panel in row:
            style.mark_zone(panel, run, where, "white", label=panel is row[-1])
    maps.time_axes(axes, view)
    bar = figure.colorbar(mesh, ax=axes, pad=0.03, aspect=28, extend="min",
                          format=FuncFormatter(lambda exponent, _: f"$10^{{{exponent:.0f}}}$"),
                          ticks=MaxNLocator(nbins=10, integer=True))
    bar.set_label("Slip rate V [m/s]")
    if lines is not None:
        bar.ax.hlines(lines, 0.0, 1.0, color="white", linewidth=0.7)
    style.title(figure, "Slip rate on the base of the wedge" if wedge.is_wedge(run.parameters)
                else f"Slip rate on the fault{'s' if len(faults) > 1 else ''}")
    return figure


def _norm(logarithms: np.ndarray) -> Normalize:
    """Colours for log10 V, between half decades that hold all but the very slowest rates."""
    high = 0.5 * np.ceil(2.0 * logarithms.max())
    low = 0.5 * np.floor(2.0 * np.percentile(logarithms, 0.5))
    return Normalize(min(max(low, high - DECADES), high - 1.0), high)


def _zoom(run: Run, view: View, axes: Axes, where: along.Axis, norm: Normalize) -> np.ndarray:
    """The rupture on its true time steps, with a contour for each decade; returns their levels."""
    time, logarithms = zoom_rows(run, view)
    shown = maps.zoom_unit(view)(time - view.onset)
    maps.colours(axes, shown, run.fault, logarithms, where, smooth=True, norm=norm,
                 cmap=style.RATE_COLOURS)
    decades = np.arange(np.ceil(norm.vmin + 0.25), np.floor(norm.vmax) + 1.0)
    values = logarithms[:, where.nodes].T
    if values.max() > decades[0]:
        axes.contour(shown, where(run.fault.position[where.nodes]), values, levels=decades,
                     colors="white", linewidths=0.7, linestyles="solid")
    return decades


def zoom_rows(run: Run, view: View) -> Tuple[np.ndarray, np.ndarray]:
    """Times and log10 V of the rows in the zoom, thinned evenly if they are very many."""
    rows = run.fault.rows(view.zoom)
    if rows.stop - rows.start > 2 * maps.COLUMNS:
        limits = raster.edges(view.zoom, maps.COLUMNS)
        return (raster.centres(limits),
                raster.maxima(run.fault, FIELD, view.zoom, maps.COLUMNS))
    return run.fault.time[rows], raster.log10(run.fault.read(FIELD, rows))
