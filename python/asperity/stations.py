"""The receivers on the fault, as receivers.h5 holds them."""

from pathlib import Path
from typing import List

import numpy as np

from .errors import InputError, NothingToShow
from .h5file import H5File
from .series import Series

FIELDS = ("slip_rate", "traction", "theta", "slip")


class Stations(H5File):
    """An open receivers.h5; NothingToShow if no receiver lies on the fault."""

    def __init__(self, path: Path):
        super().__init__(path)
        self.time = self.times()
        if not self.has("on_fault/names"):
            raise NothingToShow(f"{path.name} has no receiver on the fault")
        self.names = self.strings("on_fault/names")

    def chosen(self, wanted) -> List[str]:
        """The names in `wanted`, or all; InputError for one that is no receiver."""
        for name in wanted:
            if name not in self.names:
                raise InputError(f"{self.path} has no receiver '{name}' on the fault. There are "
                                 f"{', '.join(self.names)}.")
        return list(wanted) or self.names

    def fields(self) -> List[str]:
        return [field for field in FIELDS if self.has(f"on_fault/fields/{field}")]

    def all_series(self, names: List[str]) -> List[Series]:
        """One for each of `names`, with those of FIELDS that the run wrote."""
        values = {field: self._values(field) for field in self.fields()}
        columns = [self.names.index(name) for name in names]
        return [Series(name, self.time, {field: array[:, column]
                                         for field, array in values.items()})
                for name, column in zip(names, columns)]

    def _values(self, field: str) -> np.ndarray:
        """(n_times, n_on), magnitudes of vectors; slip and traction count along the total slip."""
        values = self.array(f"on_fault/fields/{field}")
        if values.shape[:2] != (self.time.size, len(self.names)):
            raise InputError(f"{self.path}: 'on_fault/fields/{field}' has shape {values.shape}, "
                             f"expected ({self.time.size}, {len(self.names)}). The file is "
                             "damaged.")
        if values.ndim == 3 and values.shape[2] > 1:
            return np.linalg.norm(values, axis=2)
        values = values.reshape(values.shape[:2])
        return self._direction() * values if field in ("slip", "traction") else values

    def _direction(self) -> float:
        """-1 if the fault slips against its tangent on the whole."""
        if not self.has("on_fault/fields/slip"):
            return 1.0
        return -1.0 if self.array("on_fault/fields/slip", slice(-1, None)).sum() < 0.0 else 1.0
