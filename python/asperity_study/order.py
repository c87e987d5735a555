"""The observed order of a quantity and the error of its value, from three levels or more."""

from dataclasses import dataclass
from typing import Optional, Sequence

import numpy as np

NAN = float("nan")
EQUAL, MISSING = "equal on all levels", "no value on some level"
ALTERNATING = "no order: the changes alternate"
GROWING = "no order: the changes do not fall"
VANISHING = "no order: the last change is 0"
COUNT = "no order: a count"
FAR = 2.0  # times or part of the order in theory: an order beyond says nothing of the limit


@dataclass(frozen=True)
class Estimate:
    """`order` p and `limit` of q = limit + c h^p, and the `error` of q on the first level. Without
    an order, or with one that is far from theory, `note` says why, the limit is nan, and the error
    is the spread of the values."""

    order: float = NAN
    limit: float = NAN
    error: float = NAN
    note: str = ""


def estimate(values: Sequence[float], ratio: float, theory: Optional[float] = None) -> Estimate:
    """Of `values` on levels each of which is finer by `ratio` than the one before, or coarser where
    that is below 1. The three finest levels count (Richardson's extrapolation). `theory` is the
    order that the method has, if it is known."""
    values, first = np.asarray(values, dtype=float), float(values[0])
    if not np.isfinite(values).all():
        return Estimate(note=MISSING)
    if np.ptp(values) == 0.0:
        return Estimate(limit=first, error=0.0, note=EQUAL)
    if ratio < 1.0:
        values, ratio = values[::-1], 1.0 / ratio
    coarse, fine = np.diff(values[-3:])
    why = _without_order(coarse, fine)
    if why:
        return Estimate(error=float(np.ptp(values)), note=why)
    found = float(np.log(coarse / fine) / np.log(ratio))
    if theory and not theory / FAR <= found <= theory * FAR:
        return Estimate(found, error=float(np.ptp(values)),
                        note=f"{found:.2f} is far from {theory:.2g} of theory")
    limit = float(values[-1] + fine / (coarse / fine - 1.0))
    return Estimate(found, limit, abs(limit - first))


def _without_order(coarse: float, fine: float) -> str:
    """Of the changes between coarser and between finer levels; '' if they have an order."""
    if coarse * fine < 0.0:
        return ALTERNATING
    if abs(fine) >= abs(coarse):
        return GROWING
    return VANISHING if fine == 0.0 else ""


def of_counts(values: Sequence[float], ratio: float) -> Estimate:
    """As `estimate`, of whole numbers, which have no order."""
    found = estimate(values, ratio)
    return Estimate(error=float(np.ptp(values)), note=COUNT) if found.error > 0.0 else found
