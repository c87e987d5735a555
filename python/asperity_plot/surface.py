"""Vertical displacement of the free surface relative to its average over the time shown.

Over several events it is also relative to its steady trend, which would hide the cycle. Where one
boundary drives the run, the displacement is relative to that boundary: against the plate a wedge
that slides steadily rises all the time, which would hide the cycle, too.
"""

from typing import Tuple

import numpy as np
from matplotlib.colors import Normalize

from asperity.run import Run

from . import along, loading, maps, raster, style, units
from .windows import View, Window

FIELD = "displacement"
FEWEST = 3  # events in the time shown that have a trend


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    surface = run.surface
    surface.require_two_times()
    limits, times, values = _columns(run, view.cycles, maps.COLUMNS)
    trend = _trend(times, values, view)
    cycles = values - trend(times)
    unit = units.prefixed(cycles, "m")
    colours = {"norm": _norm(unit(cycles)), "cmap": style.SURFACE_COLOURS}
    figure, axes = maps.panels(view)
    where = along.axis(run, surface, "surface")
    maps.position_axis(axes[0], where)
    mesh = maps.colours(axes[0, 0], maps.cycles_unit(view)(limits), surface, unit(cycles), where,
                        **colours)
    if view.zoom is not None:
        limits, times, values = _columns(run, view.zoom, maps.COLUMNS // 2)
        maps.colours(axes[0, 1], maps.zoom_unit(view)(limits - view.onset), surface,
                     unit(values - trend(times)), where, **colours)
    maps.time_axes(axes, view)
    bar = figure.colorbar(mesh, ax=axes, pad=0.02, aspect=28, extend="both")
    is_vector = surface.components(FIELD) > 1
    steady = "trend" if view.num_events >= FEWEST else "time average"
    bar.set_label(f"{'Uplift' if is_vector else 'Displacement'} relative to the {steady} "
                  f"[{unit.name}]")
    style.title(figure, f"{'Vertical displacement' if is_vector else 'Displacement'} of the "
                        f"surface relative to its {steady}")
    return figure


def _columns(run: Run, window: Window, number: int) -> Tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Limits and middles [s] of even columns, so that a plain mean is the average over time; and
    (number, n_nodes) the displacement against gravity less that of the boundary that drives the
    run, or the displacement if it has one component."""
    limits = raster.edges(window, number)
    times, components = raster.centres(limits), run.surface.components(FIELD)
    if components < 2:
        return limits, times, raster.interpolated(run.surface, FIELD, times)
    upwards = run.upwards(components)
    values = raster.interpolated(run.surface, FIELD, times, upwards)
    boundary = loading.read(run.parameters)
    if boundary is not None:
        values -= (boundary.displacement(times) @ upwards)[:, None]
    return limits, times, values


def _trend(times: np.ndarray, values: np.ndarray, view: View):
    """What is subtracted, (n, n_nodes) at n times: the line of least squares through `values` of
    each node, or their average where the time shown has too few events for a steady trend."""
    average, middle = values.mean(axis=0), times.mean()
    slope = np.zeros_like(average)
    if view.num_events >= FEWEST:
        since = times - middle
        slope = since @ (values - average) / (since @ since)
    return lambda at: average + (at - middle)[:, None] * slope


def _norm(values: np.ndarray) -> Normalize:
    """Symmetric colours; a few extreme points, as at the run's start, do not set the scale."""
    size = float(np.percentile(np.abs(values), 99.5)) or 1.0
    return Normalize(-size, size)
