"""Vertical displacement of the free surface relative to its average over the time shown.

Where one boundary drives the run, the displacement is taken relative to it: against the plate a
wedge that slides steadily rises all the time, and the cycle would drown in that.
"""

import numpy as np
from matplotlib.colors import Normalize

from asperity.errors import NothingToShow
from asperity.run import Run

from . import along, loading, maps, raster, style, units
from .windows import View

FIELD = "displacement"


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
    average = cycles.mean(axis=0)
    cycles -= average
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
        maps.colours(axes[1], times, surface, unit(zoom - average), where, **colours)
    maps.time_axes(axes, view)
    bar = figure.colorbar(mesh, ax=axes, pad=0.02, aspect=28, extend="both")
    what = "Uplift" if components > 1 else "Displacement"
    bar.set_label(f"{what} relative to the time average [{unit.name}]")
    style.title(figure, "Vertical displacement of the surface relative to its time average"
                if components > 1 else "Displacement of the surface relative to its time average")
    return figure


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
