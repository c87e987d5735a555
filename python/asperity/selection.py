"""Which events of a catalogue count: a smallest size, and a time within which events are one."""

import argparse
from dataclasses import dataclass
from typing import Optional

from .durations import text
from .program import not_negative, number, time


@dataclass(frozen=True)
class Selection:
    """Events that follow one another within `merging_time` [s] are one; of these, those of at least
    `smallest_width` [m] and, in three dimensions, `smallest_magnitude` count, if they begin at
    `start` [s] or later."""

    smallest_width: float = 0.0
    smallest_magnitude: Optional[float] = None
    merging_time: float = 0.0
    start: float = 0.0

    def __bool__(self) -> bool:
        return self != Selection()

    def __str__(self) -> str:
        parts = []
        if self.merging_time > 0.0:
            parts.append(f"less than {text(self.merging_time)} apart are one")
        if self.smallest_width > 0.0:
            parts.append(f"narrower than {self.smallest_width:g} m are left out")
        if self.smallest_magnitude is not None:
            parts.append(f"below Mw {self.smallest_magnitude:g} are left out")
        if self.start > 0.0:
            parts.append(f"before {text(self.start)} are left out")
        return "Events " + ", ".join(parts) + "." if parts else ""


def add_options(parser: argparse.ArgumentParser) -> None:
    group = parser.add_argument_group("which events count")
    group.add_argument("--smallest-width", metavar="METRES", type=not_negative(number), default=0.0,
                       help="leave out events with a smaller rupture width; by default all count, "
                            "also those in which a single node was fast, whose width is 0")
    group.add_argument("--smallest-magnitude", metavar="MW", type=number, default=None,
                       help="leave out smaller events, in three dimensions")
    group.add_argument("--merging-time", metavar="TIME", type=not_negative(time), default=0.0,
                       help="events are one if less than this lies between them, in seconds or as "
                            "30d, so that aftershocks do not count in recurrence times")
    group.add_argument("--from", metavar="TIME", dest="start", type=not_negative(time), default=0.0,
                       help="leave out events that begin earlier in the run, in seconds or as "
                            "200yr, such as the first one, which remembers the start of the run")


def chosen(options: argparse.Namespace) -> Selection:
    return Selection(options.smallest_width, options.smallest_magnitude, options.merging_time,
                     options.start)
