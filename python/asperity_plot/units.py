"""Readable units: data stay in SI, axes carry a decimal prefix that suits the largest value."""

import math
from dataclasses import dataclass

import numpy as np

from asperity.durations import DAY, HOUR, YEAR

PREFIXES = {-12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}


@dataclass(frozen=True)
class Unit:
    """`factor` is the size of the unit in SI: values are divided by it."""

    name: str
    factor: float

    def __call__(self, values):
        return np.asarray(values, dtype=float) / self.factor


def largest(values) -> float:
    """The largest finite magnitude of `values`; 0 where there is none."""
    magnitude = np.abs(np.asarray(values, dtype=float))
    magnitude = magnitude[np.isfinite(magnitude)]
    return float(magnitude.max()) if magnitude.size else 0.0


def prefixed(values, name: str) -> Unit:
    """`name` [SI] with the prefix that brings the largest of `values` to between 1 and 1000."""
    exponent = min(max(_thousands(largest(values)), min(PREFIXES)), max(PREFIXES))
    return Unit(PREFIXES[exponent] + name, 10.0**exponent)


def scientific(values, name: str) -> Unit:
    """As `prefixed`, with a power of ten instead of a prefix for what is very large."""
    if largest(values) < 1e6:
        return prefixed(values, name)
    exponent = _thousands(largest(values))
    return Unit(f"$10^{{{exponent}}}$ {name}", 10.0**exponent)


def _thousands(size: float) -> int:
    """The exponent of the power of 1000 next below `size`; 0 of 0."""
    return 3 * math.floor(math.log10(size) / 3 + 1e-9) if size > 0.0 else 0


def length(values) -> Unit:
    """Metres with a prefix, and centimetres for what is a few decimetres long."""
    if 0.02 <= largest(values) < 2.0:
        return Unit("cm", 0.01)
    return prefixed(values, "m")


def duration(span: float) -> Unit:
    """A unit of time for an interval of `span` seconds: µs to s, then hours, days and years."""
    if span < 1.0:
        return prefixed(span, "s")
    for name, factor in (("yr", YEAR), ("d", DAY), ("h", HOUR)):
        if span >= 3.0 * factor:
            return Unit(name, factor)
    return Unit("s", 1.0)


def text(value: float, name: str, digits: int = 3) -> str:
    """`value` [SI] as a reader writes it: '24.1 cm', '85 ms', '0 s'."""
    unit = duration(abs(value)) if name == "s" else prefixed(value, name)
    if name == "m":
        unit = length(value)
    return f"{rounded(value / unit.factor, digits)} {unit.name}"


def plain(value: float, name: str) -> str:
    """As `text`, without trailing zeros: '5 yr', '250 ms' for 0.25 s."""
    unit = duration(abs(value)) if name == "s" else prefixed(value, name)
    return f"{value / unit.factor:.4g} {unit.name}"


def rounded(number: float, digits: int) -> str:
    """`number` with `digits` significant digits and no exponent: '17.0', '1800', '0.0124'."""
    if number == 0.0 or not math.isfinite(number):
        return f"{number:g}"
    return f"{number:.{max(digits - 1 - math.floor(math.log10(abs(number))), 0)}f}"


def nice(step: float) -> float:
    """The number 1, 2 or 5 times a power of ten that is next below `step` > 0."""
    power = 10.0**math.floor(math.log10(step))
    return power * max(factor for factor in (1.0, 2.0, 5.0) if factor * power <= step * 1.0001)
