"""A field on a curve over time, as fault.h5 and surface.h5 hold it; read in blocks of rows."""

from functools import cached_property
from pathlib import Path
from typing import Iterator, Optional, Tuple

import h5py
import numpy as np

from .errors import InputError, NothingToShow

BLOCK_BYTES = 16 * 2**20


class History:
    """An open history; arrays are (rows in time, nodes), nodes in the order of `position`."""

    def __init__(self, path: Path):
        self.path = path
        self._sound_segments = {"."}
        try:
            self._file = h5py.File(path, "r")
        except OSError as error:
            raise InputError(f"{path} cannot be opened as an HDF5 file ({error}). "
                             "Was the run killed while writing, or is it another file?") from error
        self.time = self._array("time")
        if self.time.ndim != 1 or not self.time.size:
            raise InputError(f"{self.path} holds no time steps yet. Wait for the run's first "
                             "checkpoint, or look into its run.log.")
        if not np.all(np.isfinite(self.time)) or np.any(np.diff(self.time) <= 0.0):
            raise InputError(f"{self.path} is damaged: its times do not increase.")

    @cached_property
    def position(self) -> np.ndarray:
        """(nodes) distance [m] along the curve; NothingToShow if the nodes lie on a surface."""
        if "geometry/positions" not in self._file:
            coordinates = self._file.get("geometry/coordinates")
            if coordinates is not None and coordinates.shape[-1] == 3:
                raise NothingToShow(f"{self.path.name} is not over a curve, as in two dimensions")
        positions = self._array("geometry/positions")
        if positions.size < 2 or np.any(np.diff(positions) <= 0.0):
            raise InputError(f"{self.path} has no two nodes with increasing positions, which a "
                             "figure over position needs.")
        return positions

    def _dataset(self, name: str) -> h5py.Dataset:
        dataset = self._file.get(name)
        if not isinstance(dataset, h5py.Dataset):
            raise InputError(f"{self.path} has no dataset '{name}'. {self._contents()}")
        for source in dataset.virtual_sources() if dataset.is_virtual else ():
            self._check_segment(source.file_name)
        return dataset

    def _check_segment(self, name: str) -> None:
        """HDF5 silently reads zeros where the file behind a virtual dataset cannot be opened."""
        if name in self._sound_segments:
            return
        segment = self.path.parent / name
        try:
            h5py.File(segment, "r").close()
        except OSError as error:
            raise InputError(
                f"{self.path} needs {segment}, which cannot be opened ({error}). Copy a result "
                "with its folder 'segments'; restart a killed run.") from error
        self._sound_segments.add(name)

    def _contents(self) -> str:
        fields = self._file.get("fields")
        names = ", ".join(fields) if isinstance(fields, h5py.Group) and len(fields) else "none"
        return f"Fields in it: {names}."

    def _array(self, name: str) -> np.ndarray:
        return self._read(self._dataset(name), slice(None))

    def _read(self, dataset: h5py.Dataset, rows: slice) -> np.ndarray:
        try:
            return np.asarray(dataset[rows], dtype=float)
        except (OSError, ValueError, TypeError) as error:
            raise InputError(f"{self.path}: '{dataset.name}' cannot be read ({error}). "
                             "The file is damaged.") from error

    def rows(self, window: Tuple[float, float]) -> slice:
        """The rows with times in `window`, and one more on either side where there is one."""
        first = np.searchsorted(self.time, window[0], side="right") - 1
        last = np.searchsorted(self.time, window[1], side="left") + 1
        return slice(max(int(first), 0), min(int(last), self.time.size))

    def components(self, field: str) -> int:
        shape = self._dataset(f"fields/{field}").shape
        return shape[2] if len(shape) == 3 else 1

    def read(self, field: str, rows: slice, direction: Optional[np.ndarray] = None) -> np.ndarray:
        """(rows, nodes) of `field`: a vector's component along `direction`, or its magnitude."""
        dataset = self._dataset(f"fields/{field}")
        if dataset.shape[:2] != (self.time.size, self.position.size):
            raise InputError(f"{self.path}: 'fields/{field}' has shape {dataset.shape}, expected "
                             f"({self.time.size}, {self.position.size}). The file is damaged.")
        values = self._read(dataset, rows)
        if values.ndim == 3:
            if direction is not None:
                values = values @ np.asarray(direction)[:values.shape[2]]
            elif values.shape[2] == 1:
                values = values[..., 0]
            else:
                values = np.linalg.norm(values, axis=2)
        return values

    def blocks(self, field: str, rows: slice,
               direction: Optional[np.ndarray] = None) -> Iterator[Tuple[slice, np.ndarray]]:
        """`read` in consecutive pieces of bounded size, with the rows of each."""
        step = max(1, BLOCK_BYTES // (self.position.size * self.components(field) * 8))
        for first in range(rows.start, rows.stop, step):
            part = slice(first, min(first + step, rows.stop))
            yield part, self.read(field, part, direction)
