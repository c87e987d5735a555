"""The platforms. A further one is a module with a PLATFORM, and its name here."""

from typing import Optional

from . import scec, seas
from .problem import Platform, plain

PLATFORMS = (seas.PLATFORM, scec.PLATFORM)


def named(name: str) -> Platform:
    return next(each for each in PLATFORMS if each.name == name.upper())


def of_problem(name: str) -> Optional[Platform]:
    """That of a problem, also of one without a table here."""
    return next((each for each in PLATFORMS if plain(name).startswith(each.prefix)), None)
