"""The positions of the nodes of a fault or surface, as an axis with name and unit."""

from dataclasses import dataclass
from typing import Tuple

import numpy as np

from asperity.catalogue import begins_at_upper_end
from asperity.h5file import H5File
from asperity.history import positions
from asperity.run import Run

from . import units

PRESCRIBED = "fields/prescribed"


@dataclass(frozen=True)
class Axis:
    """Coordinate along a curve: `axis(positions [m])` are the numbers beside its ticks."""

    name: str
    unit: units.Unit
    origin: float                # [m] of the coordinate where positions are 0
    sign: float                  # -1 if it decreases along the curve
    limits: Tuple[float, float]  # positions [m] of what is worth showing
    is_downwards: bool = False   # counted from the upper end, so that figures have it vertical

    def __call__(self, where):
        return self.unit(self.metres(where))

    def metres(self, where):
        """The coordinate [m] at positions [m]."""
        return self.origin + self.sign * np.asarray(where, dtype=float)

    def positions(self, metres):
        """The positions [m] of coordinates [m]."""
        return (np.asarray(metres, dtype=float) - self.origin) * self.sign

    def line(self, axes, where, values, **look):
        """Draws `values` over the positions `where` [m], or across where these grow downwards."""
        x, y = (values, self(where)) if self.is_downwards else (self(where), values)
        return axes.plot(x, y, **look)

    @property
    def range(self) -> Tuple[float, float]:
        """What is worth showing, as the limits of a vertical axis, which may grow downwards."""
        low, high = sorted(self(self.limits).tolist())
        return (high, low) if self.is_downwards else (low, high)

    @property
    def label(self) -> str:
        return f"{self.name} [{self.unit.name}]"


def axis(run: Run, file: H5File, place: str) -> Axis:
    """The axis of the 'fault' or 'surface' whose nodes `file` lists.

    Depth on a vertical fault below y = 0, x on a horizontal one, else the distance from the upper
    end of a fault, and from the start of a surface.
    """
    where = positions(file)
    name, origin, sign, is_downwards = f"Position along the {place}", 0.0, 1.0, False
    if run.is_wedge:
        name = f"Distance from the trench along the {'base' if place == 'fault' else 'surface'}"
    elif file.has("geometry/coordinates"):
        nodes = file.array("geometry/coordinates")
        if _is_vertical(run, nodes, where):
            sign = 1.0 if begins_at_upper_end(nodes, where) else -1.0
            name, origin, is_downwards = "Depth", -nodes[0, 1], True
        elif _is_constant(nodes[:, 1], where):
            origin = nodes[0, 0]
        elif place == "fault":
            name, is_downwards = "Distance from the upper end of the fault", True
            if not begins_at_upper_end(nodes, where):
                origin, sign = where[-1], -1.0
    limits = _limits(file, where)
    shown = units.length(origin + sign * np.array(limits))
    return Axis(name, shown, origin, sign, limits, is_downwards)


def _is_constant(coordinate: np.ndarray, where: np.ndarray) -> bool:
    return float(np.ptp(coordinate)) <= 1e-9 * (where[-1] - where[0])


def _is_vertical(run: Run, nodes: np.ndarray, where: np.ndarray) -> bool:
    below = nodes[:, 1].max() <= 1e-9 * (where[-1] - where[0])
    return below and _is_constant(nodes[:, 0], where) and run.upwards(2)[1] > 1.0 - 1e-9


def _limits(file: H5File, where: np.ndarray) -> Tuple[float, float]:
    """The whole curve, or without its ends on which the deck prescribes the slip rate."""
    if file.has(PRESCRIBED):
        free = where[file.array(PRESCRIBED, slice(0, 1))[0] == 0.0]
        if free.size > 1:
            return float(free[0]), float(free[-1])
    return float(where[0]), float(where[-1])
