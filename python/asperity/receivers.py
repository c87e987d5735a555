"""Time series at the receivers on and off the fault, as receivers.h5 holds them."""

from pathlib import Path
from typing import Dict, List, Sequence, Tuple

import numpy as np

from .errors import InputError, NothingToShow
from .h5file import H5File
from .series import Series

ON_FAULT, IN_BODY = "on_fault", "off_fault"
GROUPS = {ON_FAULT: "on the fault", IN_BODY: "in the body"}
AXES = {1: "z", 2: "xy", 3: "xyz"}  # of a motion with so many components
FIELDS = ("slip_rate", "traction", "theta", "slip")  # of a Series


class Receivers(H5File):
    """An open receivers.h5: receivers["dp075"]["slip"] is (n_times) or (n_times, components)."""

    def __init__(self, path: Path):
        super().__init__(path)
        self.time = self.times()
        self._names = {group: self.strings(f"{group}/names") for group in GROUPS
                       if self.has(f"{group}/names")}

    @property
    def names(self) -> List[str]:
        return [name for names in self._names.values() for name in names]

    def __getitem__(self, name: str) -> Dict[str, np.ndarray]:
        """All fields of a receiver by their names."""
        group, column = self._place(name)
        return {field: self.values(group, field)[:, column]
                for field in self.entries(f"{group}/fields")}

    def coordinates(self, name: str) -> np.ndarray:
        """(dimension) [m]; of one on the fault, projected to it."""
        group, column = self._place(name)
        return self.array(f"{group}/coordinates")[column]

    def on_fault(self, wanted: Sequence[str] = ()) -> List[str]:
        """The names in `wanted`, or all on the fault; InputError for one that is none of these,
        NothingToShow if no receiver lies on the fault."""
        if ON_FAULT not in self._names:
            raise NothingToShow(f"{self.path.name} has no receiver on the fault")
        names = self._names[ON_FAULT]
        for name in wanted:
            if name not in names:
                raise InputError(f"{self.path} has no receiver '{name}' on the fault. There are "
                                 f"{', '.join(names)}.")
        return list(wanted) or names

    def shown(self, group: str, wanted: Sequence[str] = ()) -> List[str]:
        """Those of the names in `wanted` that are in the group, ON_FAULT or IN_BODY, which has
        those on the ground, too; or all of it. InputError for a name that the file does not have,
        NothingToShow if there is no receiver to show."""
        if group not in self._names:
            raise NothingToShow(f"{self.path.name} has no receiver {GROUPS[group]}")
        places = " or ".join(GROUPS[each] for each in self._names)
        for name in wanted:
            if name not in self.names:
                raise InputError(f"{self.path} has no receiver '{name}' {places}. There are "
                                 f"{', '.join(self.names)}.")
        chosen = [name for name in wanted if name in self._names[group]]
        if wanted and not chosen:
            raise NothingToShow(f"no receiver named {', '.join(wanted)} lies {GROUPS[group]}")
        return chosen or self._names[group]

    def has_motion(self, field: str) -> bool:
        """Whether the run wrote this field of receivers in the body."""
        return self.has(f"{IN_BODY}/fields/{field}")

    def motion(self, names: Sequence[str], field: str) -> List[Series]:
        """One for each of `names` in the body: the components of a displacement or velocity by
        their axes, 'x', 'y', 'z'; of an antiplane body 'z' alone."""
        values = self.values(IN_BODY, field)
        values = values.reshape(*values.shape[:2], -1)
        axes = AXES.get(values.shape[2])
        if axes is None:
            raise InputError(f"{self.path}: '{IN_BODY}/fields/{field}' has {values.shape[2]} "
                             "components. The file is damaged.")
        columns = [self._names[IN_BODY].index(name) for name in names]
        return [Series(name, self.time, {axis: values[:, column, number]
                                         for number, axis in enumerate(axes)})
                for name, column in zip(names, columns)]

    def fields(self) -> List[str]:
        """Those of FIELDS that the run wrote of receivers on the fault."""
        return [field for field in FIELDS if self.has(f"{ON_FAULT}/fields/{field}")]

    def series(self, names: Sequence[str]) -> List[Series]:
        """One for each of `names` on the fault, with its fields()."""
        values = {field: self._along_slip(field) for field in self.fields()}
        columns = [self._names[ON_FAULT].index(name) for name in names]
        return [Series(name, self.time, {field: array[:, column]
                                         for field, array in values.items()})
                for name, column in zip(names, columns)]

    def _place(self, name: str) -> Tuple[str, int]:
        for group, names in self._names.items():
            if name in names:
                return group, names.index(name)
        raise InputError(f"{self.path} has no receiver '{name}'. There are "
                         f"{', '.join(self.names)}.")

    def values(self, group: str, field: str) -> np.ndarray:
        """(n_times, n_receivers[, components])"""
        values = self.array(f"{group}/fields/{field}")
        expected = (self.time.size, len(self._names[group]))
        if values.shape[:2] != expected:
            raise InputError(f"{self.path}: '{group}/fields/{field}' has shape {values.shape}, "
                             f"expected {expected}. The file is damaged.")
        return values

    def _along_slip(self, field: str) -> np.ndarray:
        """(n_times, n_on_fault), magnitudes of vectors; slip and traction count along the total
        slip, which may be against the tangent of the fault."""
        values = self.values(ON_FAULT, field)
        if values.ndim == 3 and values.shape[2] > 1:
            return np.linalg.norm(values, axis=2)
        values = values.reshape(values.shape[:2])
        is_backward = field in ("slip", "traction") and "slip" in self.fields() \
            and self.array(f"{ON_FAULT}/fields/slip", slice(-1, None)).sum() < 0.0
        return -values if is_backward else values
