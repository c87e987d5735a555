"""Columns of the platforms' files: how they are made, their units, what their numbers may be."""

from dataclasses import dataclass
from typing import Callable, Dict, Mapping, Optional, Tuple

import numpy as np

# What is wrong with the numbers of a column: the row and the words, or nothing.
Fault = Optional[Tuple[int, str]]
Rule = Callable[[np.ndarray], Fault]
Directions = Mapping[str, Tuple[float, ...]]

NO_LOGARITHM = -99.0  # of what has none, such as the slip rate of a fault at rest


def logarithm(values: np.ndarray) -> np.ndarray:
    """Decimal, of magnitudes."""
    with np.errstate(divide="ignore"):
        return np.maximum(np.log10(np.abs(values)), NO_LOGARITHM)


# By the first of a column's units, how it follows from SI numbers; others are these numbers.
FROM_SI: Dict[str, Callable[[np.ndarray], np.ndarray]] = {
    "MPa": lambda values: 1e-6 * values, "log10 m/s": logarithm, "log10 s": logarithm,
    "log-seconds": logarithm}


@dataclass(frozen=True)
class Column:
    """`words` describe it in a header; '{unit}' in them is the first of `units`, which stands at
    their end otherwise. A header may also give another of the units, in small or large letters.

    It is made of the `field` of a run's result: of a vector, of its part along the direction of the
    name `along`. Where a model has no such direction, it is 0.
    """

    name: str
    words: str
    field: str
    units: Tuple[str, ...]
    low: float
    high: float
    rules: Tuple[Rule, ...] = ()
    along: Optional[str] = None

    def description(self, **more: str) -> str:
        text = self.words if "{unit}" in self.words else self.words + " ({unit})"
        return text.format(unit=self.units[0], **more)

    def made_of(self, fields: Mapping[str, np.ndarray], directions: Directions) -> np.ndarray:
        """(rows, ...) of fields (rows, ...[, components])."""
        values = fields[self.field]
        if self.along is not None:
            values = _part(values, directions.get(self.along), fields["time"].size)
        return FROM_SI.get(self.units[0], np.asarray)(values)

    def has_unit(self, text: str) -> bool:
        return text.strip().lower() in [unit.lower() for unit in self.units]

    def fault(self, values: np.ndarray) -> Fault:
        outside = (values < self.low) | (values > self.high)
        if outside.any():
            row = int(np.argmax(outside))
            return row, (f"{values[row]:g} is outside [{self.low:g}, {self.high:g}] "
                         f"{self.units[0]}; check the unit")
        found = (rule(values) for rule in self.rules)
        return next((fault for fault in found if fault), None)


def _part(values: np.ndarray, direction: Optional[Tuple[float, ...]], rows: int) -> np.ndarray:
    """A field along the tangent of a fault in two dimensions has one component and no axis for
    it."""
    if values.ndim < 3:
        values = values.reshape(rows, -1, 1)
    result = np.zeros(values.shape[:2])
    for component, share in enumerate((direction or ())[:values.shape[2]]):
        result = result + share * values[..., component]
    return result


def is_logarithm(values: np.ndarray) -> Fault:
    return None if (values < 0.0).any() else (0, "no value is below 0; write log10 of the slip "
                                                 "rate, not the slip rate itself")


def is_positive(values: np.ndarray) -> Fault:
    """Where the largest number is more than rounding and small waves, as the -3e-9 m with which
    BP5-FD begins."""
    row = int(np.argmax(np.abs(values)))
    return None if values[row] >= -1e-6 else (row, f"{values[row]:g}, the largest of this file, "
                                                   "has the wrong sign; it must be positive")


def starts_within(bound: float) -> Rule:
    return lambda values: None if abs(values[0]) <= bound else (
        0, f"begins with {values[0]:g}; it must be 0 within {bound:g} (and no logarithm)")


def starts_above(bound: float) -> Rule:
    return lambda values: None if abs(values[0]) >= bound else (
        0, f"begins with {values[0]:g}; it must be {bound:g} at least (and no logarithm)")


def reaches(bound: float) -> Rule:
    return lambda values: None if values.max() >= bound else (
        int(np.argmax(values)), f"never exceeds {values.max():g}; {bound:g} is the least (and no "
                                "logarithm)")


TIME = Column("t", "Time", "time", ("s",), 0.0, 1e15)
PEAK_RATE = Column("max_slip_rate", "Max slip rate", "peak_slip_rate", ("log10 m/s",), -100.0, 3.0,
                   (is_logarithm,))


def slip(name: str, words: str, along: str, *rules: Rule) -> Column:
    return Column(name, words, "slip", ("m",), -1e3, 1e3, (starts_within(1e-3), *rules), along)


def slip_at_nodes(name: str) -> Column:
    return Column(name, "Slip", "slip", ("m",), -1e3, 1e3)


def log_rate(name: str, words: str, along: Optional[str] = None) -> Column:
    """Of the magnitude of the slip rate, or of its part along a direction."""
    return Column(name, words, "slip_rate" if along is None else "slip_velocity", ("log10 m/s",),
                  -100.0, 3.0, (is_logarithm,), along)


def rate(name: str, words: str, field: str, along: str, *rules: Rule) -> Column:
    return Column(name, words, field, ("m/s",), -100.0, 100.0, (starts_within(1e-3), *rules), along)


def shear_stress(name: str, words: str, along: str, *rules: Rule) -> Column:
    return Column(name, words, "traction", ("MPa",), -500.0, 500.0, rules, along)


def normal_stress(name: str, words: str, field: str, *rules: Rule) -> Column:
    return Column(name, words, field, ("MPa",), -500.0, 500.0, rules)


def log_state(name: str, words: str, *units: str) -> Column:
    return Column(name, words, "theta", units, -50.0, 25.0)


def displacement(name: str, words: str, along: str) -> Column:
    return Column(name, words, "displacement", ("m",), -1e3, 1e3, along=along)


def velocity(name: str, words: str, along: str) -> Column:
    return Column(name, words, "velocity", ("m/s",), -100.0, 100.0, along=along)


def pressure(name: str, words: str, field: str) -> Column:
    return Column(name, words, field, ("MPa",), -100.0, 500.0)


def moment_rate(in_space: bool) -> Column:
    if in_space:
        return Column("moment_rate", "Moment rate", "moment_rate", ("N m/s", "N-m/s"), 0.0, 1e25,
                      (reaches(100.0),))
    return Column("moment_rate", "Moment rate per length", "moment_rate_per_length", ("N/s",), 0.0,
                  1e25, (reaches(100.0),))


def places_and_arrival(along_strike: str, down_dip: str, most: float) -> Tuple[Column, ...]:
    """`most` [s]: of a rupture that never arrives."""
    return (Column(along_strike, "Distance along strike ({unit}) from {origin}", "along_strike",
                   ("m",), -1e7, 1e7),
            Column(down_dip, "Distance down dip ({unit}), {top} at the upper end of the fault",
                   "down_dip", ("m",), -1e7, 1e7),
            Column("t", "Time ({unit}) at which the slip rate first reached {threshold} m/s; "
                        "{never}: never", "arrival", ("s",), 0.0, most))
