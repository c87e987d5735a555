"""Fields over time, as fault.h5, surface.h5 and volume.h5 hold them; large ones in blocks."""

from functools import cached_property
from pathlib import Path
from typing import Iterator, List, Optional, Tuple

import numpy as np

from .errors import InputError, NothingToShow, OtherModel
from .h5file import H5File

BLOCK_BYTES = 16 * 2**20


def is_surface(file: H5File) -> bool:
    """Whether the nodes lie on a surface, as in three dimensions, and not along a curve."""
    return not file.has("geometry/positions") and file.has("geometry/coordinates") \
        and file.dataset("geometry/coordinates").shape[-1] == 3


def positions(file: H5File) -> np.ndarray:
    """(nodes) distance [m] along the curve; OtherModel if the nodes lie on a surface.

    Two are equal where a fault cuts the curve: it has a node on each side. Two are also equal where
    the curve has a gap.
    """
    if is_surface(file):
        raise OtherModel(f"{file.path.name} is not over a curve, as in two dimensions")
    along = file.array("geometry/positions")
    if along.size < 2 or along[0] == along[-1] or not np.all(np.diff(along) >= 0.0):
        raise InputError(f"{file.path} has no two nodes with increasing positions, which a "
                         "figure over position needs.")
    return along


class History(H5File):
    """An open history. history["slip"] is all of a field, (rows in time, nodes[, components]).

    The functions with `rows` or `window` read a part, and need nodes along a curve, in the order of
    `position`.
    """

    def __init__(self, path: Path):
        super().__init__(path)
        self.time = self.times()

    def require_two_times(self) -> None:
        """NothingToShow where there is one, between which and another nothing can change."""
        if self.time.size < 2:
            raise NothingToShow(f"{self.path.name} has a single time")

    @property
    def fields(self) -> List[str]:
        return self.entries("fields")

    def __getitem__(self, field: str) -> np.ndarray:
        return self.array(f"fields/{field}")

    def unit(self, field: str) -> str:
        return self.attribute(f"fields/{field}", "unit")

    def component_names(self, field: str) -> List[str]:
        """Of a tensor, such as ["xx", "xy", "xz", "yy", "yz", "zz"]; [] of other fields."""
        return self.attribute(f"fields/{field}", "components").split()

    def is_of_elements(self, field: str) -> bool:
        """Whether it is constant in each of `elements`: (rows, elements[, components])."""
        return self.attribute(f"fields/{field}", "centring") == "elements"

    @cached_property
    def elements(self) -> np.ndarray:
        """(elements, corners) the nodes of each, as rows of `coordinates`."""
        return self.dataset("geometry/connectivity")[:]

    @cached_property
    def coordinates(self) -> np.ndarray:
        """(nodes, dimension) [m]."""
        return self.array("geometry/coordinates")

    @cached_property
    def position(self) -> np.ndarray:
        return positions(self)

    def rows(self, window: Tuple[float, float]) -> slice:
        """The rows with times in `window`, and one more on either side where there is one."""
        first = np.searchsorted(self.time, window[0], side="right") - 1
        last = np.searchsorted(self.time, window[1], side="left") + 1
        return slice(max(int(first), 0), min(int(last), self.time.size))

    def components(self, field: str) -> int:
        shape = self.dataset(f"fields/{field}").shape
        return shape[2] if len(shape) == 3 else 1

    def read(self, field: str, rows: slice, direction: Optional[np.ndarray] = None) -> np.ndarray:
        """(rows, nodes) of `field`: a vector's component along `direction`, or its magnitude."""
        shape = self.dataset(f"fields/{field}").shape
        if shape[:2] != (self.time.size, self.position.size):
            raise InputError(f"{self.path}: 'fields/{field}' has shape {shape}, expected "
                             f"({self.time.size}, {self.position.size}). The file is damaged.")
        values = self.array(f"fields/{field}", rows)
        if values.ndim == 3:
            if direction is not None:
                values = values @ np.asarray(direction)[:values.shape[2]]
            elif values.shape[2] == 1:
                values = values[..., 0]
            else:
                values = np.linalg.norm(values, axis=2)
        return values

    def at(self, field: str, time: float) -> np.ndarray:
        """(nodes[, components]) of `field` at a time, linear between its rows, the first or the
        last row beyond them; over a curve or a surface."""
        row = int(np.clip(np.searchsorted(self.time, time) - 1, 0, max(self.time.size - 2, 0)))
        values = self.array(f"fields/{field}", slice(row, row + 2))
        if values.shape[0] < 2:
            return values[0]
        part = (time - self.time[row]) / (self.time[row + 1] - self.time[row])
        return values[0] + min(max(part, 0.0), 1.0) * (values[1] - values[0])

    def blocks(self, field: str, rows: slice,
               direction: Optional[np.ndarray] = None) -> Iterator[Tuple[slice, np.ndarray]]:
        """`read` in consecutive pieces of bounded size, with the rows of each."""
        step = max(1, BLOCK_BYTES // (self.position.size * self.components(field) * 8))
        for first in range(rows.start, rows.stop, step):
            part = slice(first, min(first + step, rows.stop))
            yield part, self.read(field, part, direction)
