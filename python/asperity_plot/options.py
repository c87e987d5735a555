"""What the command line asks of single figures and tables."""

from dataclasses import dataclass
from typing import Optional, Tuple


@dataclass(frozen=True)
class Options:
    """By default the figure chooses."""

    intervals: Optional[Tuple[float, float]] = None  # [s] of slip profiles, between and in events
    receivers: Tuple[str, ...] = ()                  # by name
    references: Tuple[str, ...] = ()                 # "FILE" or "RECEIVER=FILE"
    depths: Tuple[float, ...] = ()                   # [m] for the table of events
