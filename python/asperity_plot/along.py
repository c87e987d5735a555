"""The positions of the nodes of a fault or surface, as an axis with name and unit."""

from dataclasses import dataclass, field, replace
from typing import List, Tuple

import numpy as np

from asperity import wedge
from asperity.catalogue import LEVEL
from asperity.h5file import H5File
from asperity.history import positions
from asperity.run import Run

from . import units

PRESCRIBED, GIVEN_SLIP = "fields/prescribed", "fields/given_slip"
MOST_FAULTS = 24  # with a panel of their own
FROM_UPPER_END = "Distance from the upper end of the fault"  # as in files and of receivers


@dataclass(frozen=True)
class Axis:
    """Coordinate along a curve: `axis(positions [m])` are the numbers beside its ticks."""

    name: str
    unit: units.Unit
    origin: float                # [m] of the coordinate where positions are 0
    limits: Tuple[float, float]  # positions [m] of what is worth showing
    is_downwards: bool = False   # counted from the upper end, so that figures have it vertical
    parts: Tuple[Tuple[str, float], ...] = ()  # of several faults the name and the first position
    nodes: slice = field(default_factory=lambda: slice(None))  # those on the curve
    title: str = ""              # of one of several faults

    def __call__(self, where):
        return self.unit(self.metres(where))

    def metres(self, where):
        """The coordinate [m] at positions [m]."""
        return self.origin + np.asarray(where, dtype=float)

    def positions(self, metres):
        """The positions [m] of coordinates [m]."""
        return np.asarray(metres, dtype=float) - self.origin

    def line(self, axes, where, values, **look):
        """Draws `values` over the positions `where` [m] of all nodes, or across where these grow
        downwards. The line breaks where two nodes are at one position."""
        where, values = where[self.nodes], values[self.nodes]
        gaps = np.flatnonzero(np.diff(where) == 0.0) + 1
        along, values = np.insert(self(where), gaps, np.nan), np.insert(values, gaps, np.nan)
        x, y = (values, along) if self.is_downwards else (along, values)
        return axes.plot(x, y, **look)

    @property
    def range(self) -> Tuple[float, float]:
        """What is worth showing, as the limits of a vertical axis, which may grow downwards."""
        low, high = sorted(self(self.limits).tolist())
        return (high, low) if self.is_downwards else (low, high)

    @property
    def label(self) -> str:
        further = ", ".join(f"{name} from {self(begin):.3g}" for name, begin in self.parts[1:])
        return f"{self.name} [{self.unit.name}]" + (f"\n({further})" if further else "")


def axis(run: Run, file: H5File, place: str) -> Axis:
    """The axis of the 'fault' or 'surface' whose nodes `file` lists, as of a single curve.

    Of a fault the distance from its upper end, which is the depth if it is vertical and begins at
    y = 0, and on a level one is the end with the smaller x. Of a surface x if it is level, else the
    distance from its start.
    """
    return _axis(run, file, place, slice(0, positions(file).size), _parts(file), 0.0)


def faults(run: Run, file: H5File) -> List[Axis]:
    """An axis for each of `pieces`, from its own upper end, without those whose slip rate is
    prescribed as a whole. Of very many pieces a single axis."""
    where, every = positions(file), pieces(file)
    free = [each for each in every if _is_free(file, where)[each[1]].any()] or every
    if len(every) == 1 or len(free) > MOST_FAULTS:
        return [axis(run, file, "fault")]
    found = [_axis(run, file, "fault", piece, (), where[piece.start]) for _, piece in free]
    shown = units.length([each.metres(each.limits) for each in found])
    return [replace(each, unit=shown, title=title) for each, (title, _) in zip(found, free)]


def alike(faults: List[Axis]) -> List[Axis]:
    """The same axes for panels that all have their positions downwards, or none."""
    downwards = all(each.is_downwards for each in faults)
    return [replace(each, is_downwards=downwards) for each in faults]


def pieces(file: H5File) -> List[Tuple[str, slice]]:
    """For each piece of the curve that continues no other one the boundaries that it is made of, as
    the deck names them, and its nodes."""
    where = positions(file)
    starts = [0, *(np.flatnonzero(np.diff(where) == 0.0) + 1), where.size]
    found = [slice(int(first), int(last)) for first, last in zip(starts, starts[1:])]
    return list(zip(_titles(file, where, found), found))


def _titles(file: H5File, where: np.ndarray, pieces: List[slice]) -> List[str]:
    """The boundaries that each piece is made of, as the deck names them."""
    if not file.has("geometry/part_names"):
        return [f"Fault {number}" for number in range(1, len(pieces) + 1)]
    names, ends = file.strings("geometry/part_names"), file.array("geometry/part_ends")
    titles = []
    for piece in pieces:
        middle = 0.5 * (where[piece][1:] + where[piece][:-1])
        titles.append(", ".join(name for name, (low, high) in zip(names, ends)
                                if ((middle > low) & (middle < high)).any()))
    return titles


def _axis(run: Run, file: H5File, place: str, curve: slice, parts, begin: float) -> Axis:
    """Of the nodes `curve`, the first of which is at the position `begin` [m]."""
    where = positions(file)[curve]
    name, origin, is_downwards = f"Position along the {place}", -begin, False
    if wedge.is_wedge(run.parameters):
        name = f"Distance from the trench along the {'base' if place == 'fault' else 'surface'}"
    elif file.has("geometry/coordinates"):
        nodes = file.array("geometry/coordinates")[curve]
        is_level = _is_constant(nodes[:, 1], where)
        if place == "fault":
            name, is_downwards = _name(run, nodes, where - begin, is_level), not is_level
        elif is_level:
            name, origin = "x", nodes[0, 0]
    limits = _limits(file, positions(file), curve)
    shown = units.length(origin + np.array(limits))
    return Axis(name, shown, origin, limits, is_downwards, parts, curve)


def _parts(file: H5File) -> Tuple[Tuple[str, float], ...]:
    if not file.has("geometry/part_names"):
        return ()
    return tuple(zip(file.strings("geometry/part_names"),
                     file.array("geometry/part_ends")[:, 0].tolist()))


def _name(run: Run, nodes: np.ndarray, where: np.ndarray, is_level: bool) -> str:
    if is_level:
        return f"{FROM_UPPER_END} (smaller x)"
    return "Depth" if _is_depth(run, nodes, where) else FROM_UPPER_END


def _is_constant(coordinate: np.ndarray, where: np.ndarray) -> bool:
    return float(np.ptp(coordinate)) <= LEVEL * (where[-1] - where[0])


def _is_depth(run: Run, nodes: np.ndarray, where: np.ndarray) -> bool:
    """Whether the distance from the upper end is also that from y = 0, straight down."""
    at_top = abs(nodes[:, 1].max()) <= 1e-9 * (where[-1] - where[0])
    return at_top and _is_constant(nodes[:, 0], where) and run.upwards(2)[1] > 1.0 - 1e-9


def _is_free(file: H5File, where: np.ndarray) -> np.ndarray:
    """(nodes) whether the deck leaves the slip rate free, or the fault is one of known slip."""
    free = np.ones(where.size, dtype=bool)
    if file.has(PRESCRIBED):
        free = file.array(PRESCRIBED, slice(0, 1))[0] == 0.0
    if file.has(GIVEN_SLIP):
        free |= file.array(GIVEN_SLIP, slice(0, 1))[0] != 0.0
    return free


def _limits(file: H5File, where: np.ndarray, curve: slice) -> Tuple[float, float]:
    """The whole curve, or without its ends on which the deck prescribes the slip rate."""
    free = where[curve][_is_free(file, where)[curve]]
    if free.size > 1:
        return float(free[0]), float(free[-1])
    return float(where[curve][0]), float(where[curve][-1])
