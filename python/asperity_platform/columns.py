"""Columns of the platforms' files: names, units, and what their numbers may be."""

from dataclasses import dataclass
from typing import Callable, Optional, Tuple

import numpy as np

# What is wrong with the numbers of a column: the row and the words, or nothing.
Fault = Optional[Tuple[int, str]]
Rule = Callable[[np.ndarray], Fault]


@dataclass(frozen=True)
class Column:
    """`units` are the texts any of which the header may give, in small or large letters."""

    name: str
    units: Tuple[str, ...]
    low: float
    high: float
    rules: Tuple[Rule, ...] = ()

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


def is_logarithm(values: np.ndarray) -> Fault:
    return None if (values < 0.0).any() else (0, "no value is below 0; write log10 of the slip "
                                                 "rate, not the slip rate itself")


def is_positive(values: np.ndarray) -> Fault:
    """Where the largest number is more than rounding and small waves: BP5-FD begins with -3e-9 m,
    after which 1e-6 was chosen."""
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


TIME = Column("t", ("s",), 0.0, 1e15)
PEAK_RATE = Column("max_slip_rate", ("log10 m/s",), -100.0, 3.0, (is_logarithm,))


def slip(name: str, *rules: Rule) -> Column:
    return Column(name, ("m",), -1e3, 1e3, (starts_within(1e-3), *rules))


def log_rate(name: str) -> Column:
    return Column(name, ("log10 m/s",), -100.0, 3.0, (is_logarithm,))


def rate(name: str, *rules: Rule) -> Column:
    return Column(name, ("m/s",), -100.0, 100.0, (starts_within(1e-3), *rules))


def stress(name: str, *rules: Rule) -> Column:
    return Column(name, ("MPa",), -500.0, 500.0, rules)


def log_state(name: str) -> Column:
    return Column(name, ("log10 s", "log-seconds"), -50.0, 25.0)


def displacement(name: str) -> Column:
    return Column(name, ("m",), -1e3, 1e3)


def velocity(name: str) -> Column:
    return Column(name, ("m/s",), -100.0, 100.0)


def pressure(name: str) -> Column:
    return Column(name, ("MPa",), -100.0, 500.0)


def place(name: str) -> Column:
    return Column(name, ("m",), -1e7, 1e7)


def moment_rate(*units: str) -> Column:
    return Column("moment_rate", units, 0.0, 1e25, (reaches(100.0),))
