"""Displacement of the free surface in three dimensions before an event and in the event: colours of
the uplift, arrows of the horizontal displacement.

Where a fault cuts the surface there is one node on each side of it, and the colours break. Beside
an antisymmetric fault the other half is drawn as well.
"""

from typing import List, Tuple

import numpy as np
from matplotlib.tri import Triangulation

from asperity.errors import NothingToShow
from asperity.run import Run

from . import mirror, plane, style, units
from .windows import Window

FIELD = "displacement"
ARROWS = 24     # along the longer side of a panel
NOTHING = 1e-6  # of the largest displacement: a panel of this would be empty
SHOWN = 0.01    # places that move less than this share of the largest are left out


def draw(run: Run, spans: List[Window], titles: List[str]):
    """One panel for each span of time [s]."""
    upwards = plane.up(run)
    nodes, triangles, changes = _whole(run, spans, upwards)
    axes = [axis for axis in range(3) if axis != int(np.argmax(np.abs(upwards)))]
    places, far = nodes[:, axes], units.length(np.ptp(nodes, axis=0))
    moved, titles = moving(changes, titles)
    limits = _limits(places, moved)
    shape = float(np.divide(*np.ptp(limits, axis=0)[::-1]))
    size = 11.0 if len(titles) > 1 else 6.5, 1.5 + min(4.4 * shape, 8.0)
    figure, panels = style.panels(1, len(titles), size, sharey=True)
    for panel, displacement, title in zip(panels[0], moved, titles):
        mesh = Triangulation(*far(places).T, triangles)
        _uplift(panel, mesh, displacement @ upwards)
        _arrows(panel, far(places), displacement[:, axes], far(limits))
        panel.set(title=title, xlabel=f"{'xyz'[axes[0]]} [{far.name}]", aspect="equal",
                  xlim=far(limits[:, 0]), ylim=far(limits[:, 1]))
    panels[0, 0].set_ylabel(f"{'xyz'[axes[1]]} [{far.name}]")
    style.title(figure, heading(run, upwards))
    return figure


def heading(run: Run, upwards: np.ndarray) -> str:
    """Of a figure of the displacement, which says so if the other half of the body is missing."""
    is_half = mirror.is_half(run) and mirror.of(run, upwards) is None
    return "Displacement of the surface" + (" of the modelled half" if is_half else "")


def _whole(run: Run, spans: List[Window], upwards: np.ndarray):
    """Nodes, triangles and the displacement in each span, of both halves if the run has one."""
    nodes = run.surface.array("geometry/coordinates")
    triangles = plane.elements(run.surface)
    changes = [change(run, span) for span in spans]
    image = mirror.of(run, upwards)
    if image is None:
        return nodes, triangles, changes
    return (np.concatenate((nodes, image.places(nodes))),
            np.concatenate((triangles, triangles + len(nodes))),
            [np.concatenate((one, image.displacement(one))) for one in changes])


def moving(moved: List, titles: List[str]) -> Tuple[List, List[str]]:
    """Those of the displacements and their titles that have something to show: where an event
    begins with the run, nothing moves before it. NothingToShow if nothing moves at all."""
    sizes = [float(np.abs(one).max()) for one in moved]
    shown = [i for i, size in enumerate(sizes) if size > NOTHING * max(sizes)]
    if not shown:
        raise NothingToShow("the surface does not move")
    return [moved[i] for i in shown], [titles[i] for i in shown]


def change(run: Run, span: Window) -> np.ndarray:
    """(nodes, 3) [m]: by how much the displacement changed over `span`."""
    return run.surface.at(FIELD, span[1]) - run.surface.at(FIELD, span[0])


def _limits(places: np.ndarray, moved: List[np.ndarray]) -> np.ndarray:
    """((least, largest), axis) coordinates between which something moves."""
    size = np.max([np.linalg.norm(one, axis=1) / np.linalg.norm(one, axis=1).max()
                   for one in moved], axis=0)
    moving = places[size >= SHOWN]
    return np.array([moving.min(axis=0), moving.max(axis=0)])


def _uplift(panel, mesh: Triangulation, uplift: np.ndarray) -> None:
    unit, size = units.length(uplift), float(np.abs(uplift).max()) or 1.0
    picture = panel.tripcolor(mesh, unit(uplift), shading="gouraud", rasterized=True,
                              cmap=style.SURFACE_COLOURS, vmin=-unit(size), vmax=unit(size))
    style.bar_beside(panel, picture).set_label(f"Uplift [{unit.name}]")


def _arrows(panel, places: np.ndarray, flat: np.ndarray, limits: np.ndarray) -> None:
    """At the nodes that are nearest to an even grid; the longest is as long as the key says."""
    spacing = np.ptp(limits, axis=0).max() / ARROWS
    grid = np.stack(np.meshgrid(*(np.arange(low + spacing / 2, high, spacing)
                                  for low, high in limits.T)), axis=-1).reshape(-1, 2)
    chosen = np.unique([int(np.argmin(((places - point) ** 2).sum(axis=1))) for point in grid])
    longest = float(np.linalg.norm(flat, axis=1).max())
    if longest == 0.0:
        return
    arrows = panel.quiver(*places[chosen].T, *flat[chosen].T, angles="xy", scale_units="xy",
                          scale=longest / (2 * spacing), width=0.003, color=style.DARK)
    panel.quiverkey(arrows, 0.75, -0.09, longest, units.text(longest, "m"), labelpos="E",
                    coordinates="axes")  # beside the label of the axis, on no other arrow
