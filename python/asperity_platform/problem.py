"""What is to be known of a platform and its problems: files, and what it demands of them."""

import re
from dataclasses import dataclass
from typing import Callable, Optional, Sequence, Tuple

from .columns import Column, Directions
from .model import Model

# What a file is made of: a group of receivers.h5, or a file of the run.
ON_FAULT, OFF_FAULT, TOTALS, PROFILES, RUPTURE = ("on_fault", "off_fault", "global.csv", "fault.h5",
                                                  "rupture.h5")


@dataclass(frozen=True)
class FileKind:
    """Files of the same columns, made of `source`. The name of a station's file is `prefix` with
    the name of the receiver, for which `place` is a regular expression."""

    what: str
    source: str
    prefix: str
    columns: Tuple[Column, ...]
    keys: Tuple[str, ...]  # of the header; "a|b" is one of both
    place: str = ""
    is_needed: bool = True

    @property
    def is_station(self) -> bool:
        return self.source in (ON_FAULT, OFF_FAULT)

    def matches(self, name: str) -> bool:
        return re.fullmatch(re.escape(self.prefix) + self.place, name) is not None


@dataclass(frozen=True)
class Problem:
    """`stations` are those of the platform, each with the places that symmetry makes equal to it:
    one of them is needed. Without them any station counts, and one is needed."""

    names: Tuple[str, ...]
    kinds: Tuple[FileKind, ...]
    stations: Tuple[Tuple[str, ...], ...] = ()
    mark: str = ".*"  # a name of this kind tells it from others of the same name

    def kind_of(self, file_name: str) -> Optional[FileKind]:
        return next((kind for kind in self.kinds if kind.matches(file_name)), None)

    def takes(self, file_name: str) -> bool:
        """Whether the platform has a place for a file of a known kind."""
        kind = self.kind_of(file_name)
        if kind is None or not self.stations or not kind.is_station:
            return kind is not None
        return any(file_name in equal for equal in self.stations)


@dataclass(frozen=True)
class Platform:
    """`files` are those of any model; `directions` are what the names in Column.along mean for a
    source. Rows of stations are those of receivers.h5, or have equal steps."""

    name: str
    prefix: str  # of the names of its problems, in large letters
    problems: Tuple[Problem, ...]
    files: Callable[[Model], Tuple[FileKind, ...]]
    directions: Callable[[Model, str], Directions]
    has_equal_steps: bool = False

    @property
    def folder(self) -> str:
        """In that of a run."""
        return self.name.lower()


def plain(name: str) -> str:
    """'SEAS Benchmark BP1-QD' and 'bp1-qd' are one problem."""
    return re.sub(r"^(SEAS|SCEC)\s*(BENCHMARK)?\s*", "", name.strip().upper())


def find(problems: Sequence[Problem], name: str, files: Sequence[str]) -> Optional[Problem]:
    """The problem of this name that has such files; None if there is none of the name."""
    named = [each for each in problems if plain(name) in each.names]
    fitting = [each for each in named if any(re.fullmatch(each.mark, file) for file in files)]
    return next(iter(fitting or named), None)
