"""Time series at the receivers on and off the fault, as receivers.h5 holds them."""

from pathlib import Path
from typing import Dict, List

import numpy as np

from .errors import InputError
from .h5file import H5File

GROUPS = ("on_fault", "off_fault")


class Receivers(H5File):
    """An open receivers.h5: receivers["dp075"]["slip"] is (n_times) or (n_times, components)."""

    def __init__(self, path: Path):
        super().__init__(path)
        self.time = self.times()
        self._places = {name: (group, column) for group in GROUPS if self.has(f"{group}/names")
                        for column, name in enumerate(self.strings(f"{group}/names"))}

    @property
    def names(self) -> List[str]:
        return list(self._places)

    def __getitem__(self, name: str) -> Dict[str, np.ndarray]:
        """All fields of a receiver by their names."""
        group, column = self._place(name)
        return {field: self._column(f"{group}/fields/{field}", column)
                for field in self.entries(f"{group}/fields")}

    def coordinates(self, name: str) -> np.ndarray:
        """(dimension) [m]; of one on the fault, projected to it."""
        group, column = self._place(name)
        return self.array(f"{group}/coordinates")[column]

    def _place(self, name: str):
        if name not in self._places:
            raise InputError(f"{self.path} has no receiver '{name}'. There are "
                             f"{', '.join(self.names)}.")
        return self._places[name]

    def _column(self, path: str, column: int) -> np.ndarray:
        values = self.array(path)
        if values.ndim < 2 or values.shape[0] != self.time.size or values.shape[1] <= column:
            raise InputError(f"{self.path}: '{path}' has shape {values.shape}, which does not fit "
                             f"{self.time.size} times. The file is damaged.")
        return values[:, column]
