"""Faults that are surfaces in three dimensions, each unrolled into its mean plane."""

from dataclasses import dataclass
from typing import List, Tuple

import numpy as np
from matplotlib.tri import Triangulation

from asperity.errors import OtherModel
from asperity.h5file import H5File
from asperity.history import is_surface
from asperity.run import Run

from . import units

ELEMENTS = ("geometry/whole_elements", "geometry/connectivity")  # without those across a period
BOUNDARIES = "geometry/element_boundaries"
GAP = 0.05  # between faults side by side, as a share of the length of all


@dataclass(frozen=True)
class Fault:
    """One of the faults: `name`, unit vectors along strike and down dip, the upper end [m] along
    the second, and by how much it is moved along strike [m] so that it covers no other one."""

    name: str
    strike: np.ndarray
    dip: np.ndarray
    top: float
    moved: float = 0.0


@dataclass(frozen=True)
class Plane:
    """Drawn nodes by distance along strike and down dip from the upper end of their fault, both in
    [m]. A node that several faults share is drawn in each."""

    strike: np.ndarray     # (drawn nodes)
    dip: np.ndarray        # (drawn nodes)
    triangles: np.ndarray  # of drawn nodes
    unit: units.Unit       # of both axes
    nodes: np.ndarray      # (drawn nodes, 3) [m]
    source: np.ndarray     # (drawn nodes) the node of the file
    fault_of: np.ndarray   # (drawn nodes) its number among `faults`
    faults: Tuple[Fault, ...]

    def place(self, point) -> Tuple[float, float]:
        """Where a point of a fault [m] is in a panel."""
        point = np.asarray(point, dtype=float)
        nearest = np.argmin(np.linalg.norm(self.nodes - point, axis=1))
        fault = self.faults[self.fault_of[nearest]]
        return (float(self.unit(fault.strike @ point + fault.moved)),
                float(self.unit(fault.dip @ point - fault.top)))

    @property
    def triangulation(self) -> Triangulation:
        return Triangulation(self.unit(self.strike), self.unit(self.dip), self.triangles)

    def label(self, axes) -> None:
        """Equal scales on both axes, down dip downwards; the names of several faults."""
        further = ", faults side by side" if any(fault.moved for fault in self.faults) else ""
        several = len(self.faults) > 1
        axes.set(xlabel=f"Along strike{further} [{self.unit.name}]",
                 ylabel=f"Down dip [{self.unit.name}]", aspect="equal")
        axes.set_ylim(self.unit(self.dip.max()), self.unit(self.dip.min()))
        axes.set_xlim(self.unit(self.strike.min()), self.unit(self.strike.max()))
        for number, fault in enumerate(self.faults if several else ()):
            along = self.unit(self.strike[self.fault_of == number])
            axes.text(0.5 * (along.min() + along.max()), 1.01, fault.name, fontsize=8.5,
                      ha="center", va="bottom", clip_on=False,
                      transform=axes.get_xaxis_transform())


def plane(run: Run, file: H5File) -> Plane:
    """OtherModel unless the nodes of `file` lie on a surface in three dimensions."""
    if not is_surface(file):
        raise OtherModel(f"{file.path.name} is not over a surface, as in three dimensions")
    nodes = file.array("geometry/coordinates")
    triangles = elements(file)
    names, numbers = _faults(file, len(nodes), triangles)
    return unrolled(nodes, triangles, names, numbers, up(run))


def elements(file: H5File) -> np.ndarray:
    """(triangles, 3) the nodes of each, without triangles that reach across a period."""
    return file.array(ELEMENTS[0] if file.has(ELEMENTS[0]) else ELEMENTS[1]).astype(int)


def unrolled(nodes: np.ndarray, triangles: np.ndarray, names: List[str], numbers: np.ndarray,
             upwards: np.ndarray) -> Plane:
    """`numbers` (triangles) says to which of the faults `names` each belongs."""
    pieces, faults, count = [], [], 0
    for number, name in enumerate(names):
        mine = triangles[numbers == number]
        source = np.unique(mine)
        strike, dip = directions(nodes[mine], upwards)
        fault = Fault(name, strike, dip, float((nodes[source] @ dip).min()))
        pieces.append((source, count + np.searchsorted(source, mine)))
        faults.append(fault)
        count += source.size
    source = np.concatenate([piece[0] for piece in pieces])
    fault_of = np.repeat(np.arange(len(faults)), [piece[0].size for piece in pieces])
    drawn = nodes[source]
    along = np.array([faults[k].strike @ node for k, node in zip(fault_of, drawn)])
    down = np.array([faults[k].dip @ node - faults[k].top for k, node in zip(fault_of, drawn)])
    moved = side_by_side(along, down, fault_of)
    return Plane(along + moved[fault_of], down, np.concatenate([piece[1] for piece in pieces]),
                 units.length(np.ptp(nodes, axis=0)), drawn, source, fault_of,
                 tuple(Fault(each.name, each.strike, each.dip, each.top, float(shift))
                       for each, shift in zip(faults, moved)))


def _faults(file: H5File, num_nodes: int, triangles: np.ndarray) -> Tuple[List[str], np.ndarray]:
    """The names of the faults and (triangles) the number of each: boundaries as the deck names
    them, or the connected parts where the file does not know them."""
    if file.has(BOUNDARIES):
        numbers = file.array(BOUNDARIES)[:len(triangles)].astype(int)  # whole elements come first
        used, numbers = np.unique(numbers, return_inverse=True)
        names = file.strings("geometry/boundary_names")
        return [names[number] for number in used], numbers
    first, numbers = np.unique(_connected(num_nodes, triangles)[triangles[:, 0]],
                               return_inverse=True)
    return [f"fault {number}" for number in range(1, first.size + 1)], numbers


def side_by_side(along: np.ndarray, down: np.ndarray, fault_of: np.ndarray) -> np.ndarray:
    """(faults) how far [m] each has to move along strike so that it covers no other one: 0 where it
    covers none. `fault_of` (nodes) are their numbers."""
    moved = np.zeros(fault_of.max() + 1)
    gap = GAP * np.ptp(along)
    places: List[Tuple[float, float, float, float]] = []  # ends along strike, ends down dip
    for fault in sorted(range(moved.size), key=lambda each: along[fault_of == each].min()):
        nodes = fault_of == fault
        low, high = along[nodes].min(), along[nodes].max()
        top, bottom = down[nodes].min(), down[nodes].max()
        inside = 1e-6 * (high - low)
        covered = [place for place in places if place[0] + inside < high and low + inside < place[1]
                   and place[2] + inside < bottom and top + inside < place[3]]
        if covered:
            moved[fault] = max(place[1] for place in places) + gap - low
        places.append((low + moved[fault], high + moved[fault], top, bottom))
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
