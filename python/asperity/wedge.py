"""The mesh `Wedge` of a deck: where its base is, and where the base weakens with the slip rate."""

import math
from typing import List, Optional, Tuple

import numpy as np

from .parameters import Parameters


def is_wedge(parameters: Parameters) -> bool:
    return parameters.text("Mesh/Type") == "Wedge"


def dip(parameters: Parameters) -> Optional[float]:
    """Angle th [rad] between base and surface; None without a wedge."""
    height = parameters.number("Mesh/Wedge/Height")
    length = parameters.number("Mesh/Wedge/Length")
    if not is_wedge(parameters) or height is None or not length:
        return None
    return math.atan2(height, length)


def upwards(parameters: Parameters) -> Optional[np.ndarray]:
    """Unit vector off the surface of a wedge in the plane; None without a wedge."""
    angle = dip(parameters)
    return None if angle is None else np.array([-math.sin(angle), math.cos(angle)])


def seismogenic_zones(parameters: Parameters) -> List[Tuple[float, float]]:
    """Positions [m] along the base between which it weakens with the slip rate, and the further
    intervals with small cells, which are for patches that weaken; in order. Empty without a wedge.

    The deck measures the zone's end along the surface, its width along the base.
    """
    angle = dip(parameters)
    end = parameters.number("Mesh/Wedge/Seismogenic Zone End")
    width = parameters.number("Mesh/Wedge/Seismogenic Zone Width")
    if angle is None or end is None or width is None:
        return []
    end /= math.cos(angle)
    more = parameters.numbers("Mesh/Wedge/Refined Intervals")
    return sorted([(end - width, end), *zip(more[::2], more[1::2])])
