"""An HDF5 file of a result; damage is reported and never read as numbers."""

from pathlib import Path
from typing import List

import h5py
import numpy as np

from .errors import InputError, NoStepYet


class H5File:
    """An open file; its virtual datasets are trusted once every segment behind them opens."""

    def __init__(self, path: Path):
        self.path = path
        self._sound_segments = {"."}
        try:
            self._file = h5py.File(path, "r")
        except OSError as error:
            raise InputError(f"{path} cannot be opened as an HDF5 file ({error}). "
                             "Was the run killed while writing, or is it another file?") from error

    def has(self, name: str) -> bool:
        return self._item(name) is not None

    def _item(self, name: str):
        """The object of this name in the file, or None; InputError if it cannot be opened."""
        try:
            return self._file.get(name)
        except (KeyError, OSError, RuntimeError, ValueError) as error:
            raise InputError(f"{self.path}: '{name}' cannot be opened ({error}). The file is "
                             "damaged.") from error

    def entries(self, folder: str) -> List[str]:
        """The names in a group of the file; none where there is no such group."""
        group = self._item(folder)
        return list(group) if isinstance(group, h5py.Group) else []

    def attribute(self, dataset: str, name: str) -> str:
        """A text that belongs to a dataset, such as its `unit`, or to the file, which is '/'; ''
        where there is none."""
        item = self._file if dataset == "/" else self.dataset(dataset)
        value = item.attrs.get(name, "")
        return value.decode() if isinstance(value, bytes) else str(value)

    def dataset(self, name: str) -> h5py.Dataset:
        """InputError unless there is such a dataset, with all its segments."""
        dataset = self._item(name)
        if not isinstance(dataset, h5py.Dataset):
            raise InputError(f"{self.path} has no dataset '{name}'. {self._contents(name)}")
        for source in dataset.virtual_sources() if dataset.is_virtual else ():
            self._check_segment(source.file_name)
        return dataset

    def array(self, name: str, rows: slice = slice(None)) -> np.ndarray:
        """The `rows` of a dataset as floating point numbers."""
        dataset = self.dataset(name)
        try:
            return np.asarray(dataset[rows], dtype=float)
        except (OSError, ValueError, TypeError) as error:
            raise InputError(f"{self.path}: '{dataset.name}' cannot be read ({error}). "
                             "The file is damaged.") from error
        except MemoryError as error:
            raise InputError(f"{self.path}: '{dataset.name}' has {dataset.size:.3g} numbers, "
                             "more than the memory can hold. If the run was not that long, the "
                             "file is damaged.") from error

    def strings(self, name: str) -> List[str]:
        try:
            return list(self.dataset(name).asstr()[:])
        except (OSError, TypeError, UnicodeDecodeError) as error:
            raise InputError(f"{self.path}: '{name}' cannot be read as text ({error}). "
                             "The file is damaged.") from error

    def times(self) -> np.ndarray:
        """(n_times) increasing [s]; InputError if there are none yet."""
        time = self.array("time")
        if time.ndim != 1 or not time.size:
            raise NoStepYet(f"{self.path} holds no time steps yet. Wait for the run's first "
                            "checkpoint, or look into its run.log.")
        if not np.all(np.isfinite(time)) or np.any(np.diff(time) <= 0.0):
            raise InputError(f"{self.path} is damaged: its times do not increase.")
        return time

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

    def _contents(self, name: str) -> str:
        """A list of the datasets in the folder where one is missing."""
        folder = name.rpartition("/")[0] or "/"
        names = ", ".join(self.entries(folder)) or "none"
        what = "Fields" if folder.endswith("fields") else f"Entries of '{folder}'"
        return f"{what} in it: {names}."
