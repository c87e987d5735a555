"""A series at one place: of a receiver, or of another code to compare with."""

from dataclasses import dataclass, replace
from typing import Dict, Optional, Tuple

import numpy as np


@dataclass(frozen=True)
class Series:
    """`values` in SI, each (n_times) as `time`: on the fault by field (slip_rate, traction, theta,
    slip), in the body by the axes of a motion."""

    label: str
    time: np.ndarray
    values: Dict[str, np.ndarray]
    receiver: Optional[str] = None  # of a reference: the name of what it is compared with

    def rise(self, threshold: float, near: float) -> Optional[float]:
        """When V rises through `threshold` [m/s], the time closest to `near`; None if never.

        Between times the logarithm of V is linear.
        """
        rate = self.values.get("slip_rate")
        if rate is None:
            return None
        before = np.flatnonzero((rate[:-1] < threshold) & (rate[1:] >= threshold))
        if not before.size:
            return None
        low, high = np.log(np.maximum([rate[before], rate[before + 1]], np.finfo(float).tiny))
        share = (np.log(threshold) - low) / (high - low)
        rises = self.time[before] + share * (self.time[before + 1] - self.time[before])
        return float(rises[np.argmin(np.abs(rises - near))])

    def within(self, window: Tuple[float, float]) -> "Series":
        """The part with times in `window`, and one more time on either side where there is one."""
        first = max(np.searchsorted(self.time, window[0], side="right") - 1, 0)
        rows = slice(first, np.searchsorted(self.time, window[1], side="left") + 1)
        return replace(self, time=self.time[rows],
                       values={field: array[rows] for field, array in self.values.items()})

    def shifted(self, delay: float, label: str) -> "Series":
        return replace(self, time=self.time + delay, label=label)
