"""Vertical displacement of the free surface relative to its average over the time shown.

Over several events it is also relative to its steady trend, which would hide the cycle. Where one
boundary drives the run, the displacement is relative to that boundary: against the plate a wedge
that slides steadily rises all the time, which would hide the cycle, too.
"""

import numpy as np
from matplotlib.colors import Normalize

from asperity.errors import NothingToShow
from asperity.run import Run

from . import along, loading, maps, raster, style, units
from .windows import View

FIELD = "displacement"
FEWEST = 3  # events in the time shown that have a trend


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    surface = run.surface
    if surface.time.size < 2:
        raise NothingToShow("surface.h5 has a single time")
    components = surface.components(FIELD)
    upwards = run.upwards(components) if components > 1 else None
    limits = raster.edges(view.cycles, maps.COLUMNS)
    # The columns are even in time, so their plain mean is the average over time.
    cycles = _seen_from_the_loading(run, upwards, raster.centres(limits),
                                    raster.interpolated(surface, FIELD, raster.centres(limits),
                                                        upwards))
    trend = _trend(raster.centres(limits), cycles, view)
    cycles = cycles - trend(raster.centres(limits))
    unit = units.prefixed(cycles, "m")
    norm = _norm(unit(cycles))
    figure, axes = maps.panels(view)
    where = along.axis(run, surface, "surface")
    maps.position_axis(axes, where)
    colours = {"norm": norm, "cmap": style.SURFACE_COLOURS}
    mesh = maps.colours(axes[0], maps.cycles_unit(view)(limits), surface, unit(cycles), where,
                        **colours)
    if view.zoom is not None:
        limits = raster.edges(view.zoom, maps.COLUMNS // 2)
        zoom = _seen_from_the_loading(run, upwards, raster.centres(limits),
                                      raster.interpolated(surface, FIELD, raster.centres(limits),
                                                          upwards))
        times = maps.zoom_unit(view)(limits - view.onset)
        zoom = zoom - trend(raster.centres(limits))
        maps.colours(axes[1], times, surface, unit(zoom), where, **colours)
    maps.time_axes(axes, view)
    bar = figure.colorbar(mesh, ax=axes, pad=0.02, aspect=28, extend="both")
    what = "Uplift" if components > 1 else "Displacement"
    steady = "trend" if view.num_events >= FEWEST else "time average"
    bar.set_label(f"{what} relative to the {steady} [{unit.name}]")
    style.title(figure, f"Vertical displacement of the surface relative to its {steady}"
                if components > 1 else f"Displacement of the surface relative to its {steady}")
    return figure


def _trend(times: np.ndarray, values: np.ndarray, view: View):
    """What is subtracted, (n, n_nodes) at n times: the line of least squares through `values` of
    each node, or their average where the time shown has too few events for a steady trend."""
    average, middle = values.mean(axis=0), times.mean()
    slope = np.zeros_like(average)
    if view.num_events >= FEWEST:
        since = times - middle
        slope = since @ (values - average) / (since @ since)
    return lambda at: average + (at - middle)[:, None] * slope


def _seen_from_the_loading(run: Run, upwards, times: np.ndarray, values: np.ndarray) -> np.ndarray:
    """`values` (n_times, n_nodes) less the rise of the boundary that drives the run."""
    boundary = loading.read(run.parameters) if upwards is not None else None
    if boundary is None:
        return values
    return values - (boundary.displacement(times) @ np.asarray(upwards))[:, None]


def _norm(values: np.ndarray) -> Normalize:
    """Symmetric colours; a few extreme points, as at the run's start, do not set the scale."""
    size = float(np.percentile(np.abs(values), 99.5)) or 1.0
    return Normalize(-size, size)
