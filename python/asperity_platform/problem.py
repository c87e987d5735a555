"""What is to be known of a benchmark problem: its files, and what a platform demands of them."""

import re
from dataclasses import dataclass
from typing import Optional, Sequence, Tuple

from .columns import Column

# Ways in which the rows of a file are laid out.
SERIES, PROFILE, PLACES = "series", "profile", "places"


@dataclass(frozen=True)
class FileKind:
    """Files of the same columns; `name` is a regular expression for the whole name."""

    what: str
    name: str
    columns: Tuple[Column, ...]
    keys: Tuple[str, ...]  # of the header; "a|b" is one of both
    layout: str = SERIES
    is_needed: bool = True
    is_station: bool = False

    def matches(self, name: str) -> bool:
        return re.fullmatch(self.name, name) is not None


@dataclass(frozen=True)
class Problem:
    """`stations` are those of the platform, each with the places that symmetry makes equal to it:
    one of them is needed. Without them any station counts, and one is needed."""

    names: Tuple[str, ...]
    platform: str
    kinds: Tuple[FileKind, ...]
    stations: Tuple[Tuple[str, ...], ...] = ()
    has_equal_steps: bool = False
    mark: str = ".*"  # a name of this kind tells it from others of the same name

    def kind_of(self, file_name: str) -> Optional[FileKind]:
        return next((kind for kind in self.kinds if kind.matches(file_name)), None)

    def takes(self, file_name: str) -> bool:
        """Whether the platform has a place for a file of a known kind."""
        kind = self.kind_of(file_name)
        if kind is None or not self.stations or not kind.is_station:
            return kind is not None
        return any(file_name in equal for equal in self.stations)


def plain(name: str) -> str:
    """'SEAS Benchmark BP1-QD' and 'bp1-qd' are one problem."""
    return re.sub(r"^(SEAS|SCEC)\s*(BENCHMARK)?\s*", "", name.strip().upper())


def find(problems: Sequence[Problem], name: str, files: Sequence[str]) -> Optional[Problem]:
    """The problem of this name that has such files; None if there is none of the name."""
    named = [each for each in problems if plain(name) in each.names]
    fitting = [each for each in named if any(re.fullmatch(each.mark, file) for file in files)]
    return next(iter(fitting or named), None)
