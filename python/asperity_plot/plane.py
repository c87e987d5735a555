"""A fault that is a surface in three dimensions, unrolled into its mean plane."""

from dataclasses import dataclass
from typing import List, Tuple

import numpy as np
from matplotlib.tri import Triangulation

from asperity.errors import OtherDimension
from asperity.h5file import H5File
from asperity.history import is_surface
from asperity.run import Run

from . import units

ELEMENTS = ("geometry/whole_elements", "geometry/connectivity")  # without those across a period


@dataclass(frozen=True)
class Plane:
    """Nodes by distance along strike and down dip from the upper end, both in [m]."""

    strike: np.ndarray  # (nodes)
    dip: np.ndarray     # (nodes)
    triangles: np.ndarray
    unit: units.Unit    # of both axes
    axes: np.ndarray    # (2, 3) unit vectors along strike and down dip
    top: float          # [m] of the upper end, along the second
    nodes: np.ndarray   # (nodes, 3) [m]
    moved: np.ndarray   # (nodes) [m] by which the fault of a node is moved along strike

    def place(self, point) -> Tuple[float, float]:
        """Where a point of the fault [m] is in a panel."""
        along, down = self.axes @ np.asarray(point, dtype=float)
        nearest = np.argmin(np.linalg.norm(self.nodes - point, axis=1))
        return float(self.unit(along + self.moved[nearest])), float(self.unit(down - self.top))

    @property
    def triangulation(self) -> Triangulation:
        return Triangulation(self.unit(self.strike), self.unit(self.dip), self.triangles)

    def label(self, axes) -> None:
        """Equal scales on both axes, down dip downwards."""
        further = ", faults side by side" if self.moved.any() else ""
        axes.set(xlabel=f"Along strike{further} [{self.unit.name}]",
                 ylabel=f"Down dip [{self.unit.name}]", aspect="equal")
        axes.set_ylim(self.unit(self.dip.max()), self.unit(self.dip.min()))
        axes.set_xlim(self.unit(self.strike.min()), self.unit(self.strike.max()))


def plane(run: Run, file: H5File) -> Plane:
    """OtherDimension unless the nodes of `file` lie on a surface in three dimensions."""
    if not is_surface(file):
        raise OtherDimension(f"{file.path.name} is not over a surface, as in three dimensions")
    nodes = file.array("geometry/coordinates")
    triangles = file.array(ELEMENTS[0] if file.has(ELEMENTS[0]) else ELEMENTS[1]).astype(int)
    strike, dip = directions(nodes[triangles], up(run))
    along, down = nodes @ strike, nodes @ dip
    moved = side_by_side(along, down, triangles)
    return Plane(along + moved, down - down.min(), triangles, units.length(np.ptp(nodes, axis=0)),
                 np.stack((strike, dip)), float(down.min()), nodes, moved)


def side_by_side(along: np.ndarray, down: np.ndarray, triangles: np.ndarray) -> np.ndarray:
    """(nodes) how far [m] each fault has to move along strike so that it covers no other one: 0
    where it covers none. Faults are the connected parts of the triangles."""
    parts = _connected(along.size, triangles)
    moved = np.zeros(along.size)
    gap = 0.05 * np.ptp(along)
    places: List[Tuple[float, float, float, float]] = []  # ends along strike, ends down dip
    for part in sorted(np.unique(parts[triangles]), key=lambda each: along[parts == each].min()):
        nodes = parts == part
        low, high = along[nodes].min(), along[nodes].max()
        top, bottom = down[nodes].min(), down[nodes].max()
        inside = 1e-6 * (high - low)
        covered = [place for place in places if place[0] + inside < high and low + inside < place[1]
                   and place[2] + inside < bottom and top + inside < place[3]]
        if covered:
            moved[nodes] = max(place[1] for place in places) + gap - low
        places.append((low + moved[nodes][0], high + moved[nodes][0], top, bottom))
    return moved


def _connected(num_nodes: int, triangles: np.ndarray) -> np.ndarray:
    """(nodes) the smallest node that edges lead to."""
    parts, before = np.arange(num_nodes), None
    while before is None or (parts != before).any():
        before = parts.copy()
        np.minimum.at(parts, triangles, parts[triangles].min(axis=1, keepdims=True))
        parts = parts[parts]
    return parts


def up(run: Run) -> np.ndarray:
    """The deck's direction up (Output / Up); +y without one."""
    direction = np.array(run.parameters.numbers("Output/Up"))
    if direction.size != 3 or not direction.any():
        return np.array([0.0, 1.0, 0.0])
    return direction / np.linalg.norm(direction)


def directions(corners: np.ndarray, upwards: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """Unit vectors along strike and down dip of the mean plane of triangles (n, 3, 3), as the
    outputs of asperity choose them: the strike's largest component is positive."""
    normal = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]).sum(axis=0)
    normal /= np.linalg.norm(normal)
    dip = (upwards @ normal) * normal - upwards
    if np.linalg.norm(dip) < 1e-6:  # level: across the axis after that which points up
        axis = np.eye(3)[(np.argmax(np.abs(upwards)) + 2) % 3]
        dip = axis - (axis @ normal) * normal
    dip /= np.linalg.norm(dip)
    strike = np.cross(normal, dip)
    return strike * np.sign(strike[np.argmax(np.abs(strike).round(9))]), dip
