"""How the parameters of a variable change from level to level of a study of convergence."""

import math
import re
from dataclasses import dataclass
from typing import Dict, Optional, Tuple

from asperity.errors import InputError
from asperity.parameters import Parameters

FEWEST = 3  # levels: an order needs two differences
CHANGES = ("Divide", "Multiply", "Add")


@dataclass(frozen=True)
class Refinement:
    """Level 0 is the deck, with the texts `first` of the parameters; level n is finer by the factor
    ratio^n, or coarser with a ratio below 1. `change` is one of CHANGES: a size is divided by the
    factor, a number of cells multiplied; to a number of halvings its binary logarithm is added.
    `order` of the error in the factor is what theory expects, `cost` the power of the factor with
    which the cost of a run grows, if they are known."""

    first: Dict[str, str]
    ratio: float
    levels: int
    change: str
    order: Optional[float] = None
    cost: Optional[float] = None

    def factors(self) -> Tuple[str, ...]:
        """By which each level is finer than the deck; '1' first."""
        return tuple(f"{self.ratio**level:g}" for level in range(self.levels))

    def value(self, path: str, factor: str) -> str:
        """Of the parameter on the level of one of factors()."""
        level, text = self.factors().index(factor), self.first[path]
        if level == 0:
            return text
        if Parameters(self.first).number(path) is None:
            return _formula(text, self.change, self.ratio, level)
        number = {"Divide": lambda first: first / self.ratio**level,
                  "Multiply": lambda first: first * self.ratio**level,
                  "Add": lambda first: first + level * math.log2(self.ratio)
                  }[self.change](float(text))
        return str(int(number)) if text.isdigit() and number.is_integer() else repr(number)


def _formula(text: str, change: str, ratio: float, level: int) -> str:
    if change == "Add":
        return f"({text}) + {level * math.log2(ratio):g}"
    return f"({text}) {'/' if change == 'Divide' else '*'} {ratio**level!r}"


def _is_formula(text: str, given: Dict[str, str]) -> bool:
    """Of names and numbers; one with x, y, z or t is a field."""
    words = set(re.findall(r"[A-Za-z_]\w*", text))
    return "{" not in text and not words & {"x", "y", "z", "t"} and (
        re.search(r"[-+*/^(]", text) is not None or f"Names/{text.strip()}" in given)


def checked(paths: Tuple[str, ...], given: Dict[str, str], ratio: float, levels: int, change: str,
            where: str, order: Optional[float] = None, cost: Optional[float] = None) -> Refinement:
    """Of the parameters `paths`, whose values on level 0 are in `given`; InputError with `where`
    for what cannot be refined in this way."""
    if ratio <= 0.0 or ratio == 1.0:
        raise InputError(f"{where}: Ratio = {ratio:g}; a positive number other than 1 is wanted: 2 "
                         "halves the size, 0.5 doubles it.")
    if change == "Add" and not math.log2(ratio).is_integer():
        raise InputError(f"{where}: Ratio = {ratio:g}; with Change = Add a power of 2 is wanted.")
    texts = Parameters(given)
    for path in paths:
        if texts.text(path) is None:
            raise InputError(f"{where}: neither the deck nor Settings gives '{path}'. Give the "
                             "value of the first level in Settings, for example the default.")
        if texts.number(path) is None and not _is_formula(texts.text(path), given):
            raise InputError(f"{where}: '{path}' = '{' '.join(given[path].split())}' is no number. "
                             "Refine a parameter that is one, such as a factor or a name in it.")
    if order is not None and not order > 0.0:
        raise InputError(f"{where}: Order = {order:g}; a number above 0 is wanted.")
    return Refinement({path: given[path].strip() for path in paths}, ratio, levels, change, order,
                      cost)
