"""The other half of a body beside an antisymmetric fault, of which a run computes one half.

The mirror image moves the opposite way. With the mirrored place x' of x, and u_t along the plane of
the fault, u_n across it:

    u_t(x') = -u_t(x),   u_n(x') = u_n(x)

so that slip is twice u_t, and the fault does not open.
"""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from asperity.h5file import H5File
from asperity.run import Run

TYPE = "Antisymmetric Fault"
CONDITIONS = "Boundary Conditions/"
UPRIGHT = 1e-3  # of a unit normal: a plane that leans less is upright


@dataclass(frozen=True)
class Mirror:
    """The plane through `point` [m] with the unit vector `normal` (dimension)."""

    point: np.ndarray
    normal: np.ndarray

    def distance(self, places: np.ndarray) -> np.ndarray:
        """(nodes) [m] from the plane, of places (nodes, dimension)."""
        return np.abs((places - self.point) @ self.normal)

    def places(self, places: np.ndarray) -> np.ndarray:
        """(nodes, dimension) [m] where the images of `places` are."""
        return places - 2.0 * np.outer((places - self.point) @ self.normal, self.normal)

    def displacement(self, values: np.ndarray) -> np.ndarray:
        """(nodes, dimension) of the images; in antiplane motion `values` has one component."""
        if values.ndim == 1 or values.shape[1] == 1:
            return -values
        return 2.0 * np.outer(values @ self.normal, self.normal) - values


def is_half(run: Run) -> bool:
    """Whether the deck has an antisymmetric fault, so that the run is of one half of the body."""
    return any(path.startswith(CONDITIONS) and path.endswith("/Type")
               and run.parameters.text(path) == TYPE for path in run.parameters.paths())


def of(run: Run, upwards: np.ndarray) -> Optional[Mirror]:
    """The mirror of a run whose surface both halves share: the plane of the fault contains the
    direction `upwards`. None if the run is whole, or no file has the nodes of the fault."""
    names = [name for name in ("fault.h5", "rupture.h5") if run.has(name)]
    if not names or not is_half(run):
        return None
    nodes = H5File(run.directory / names[0]).array("geometry/coordinates")
    if len(nodes) < nodes.shape[1]:
        return None
    point = nodes.mean(axis=0)
    normal = np.linalg.svd(nodes - point, full_matrices=False)[2][-1]
    return Mirror(point, normal) if abs(normal @ upwards) < UPRIGHT else None
