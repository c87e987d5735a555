"""A study: a deck, what varies in it and how, as STUDY.xml says it; and the runs that follow."""

import itertools
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np

from asperity.errors import InputError

ROOT, SAMPLINGS = "Asperity Study", ("Grid", "List", "Random")
TOP = {"Deck", "Sampling", "Samples", "Seed", "Ranks", "Settings", "Variables"}
OF_VARIABLE = {"Parameters", "Unit", "Values", "Lowest", "Highest", "Distribution"}
DISTRIBUTIONS = ("Uniform", "Logarithmic")


@dataclass(frozen=True)
class Variable:
    """`values` for grids and lists, `limits` and `logarithmic` for random samples. A value goes to
    all `parameters` (paths below the deck's root) alike."""

    name: str
    parameters: Tuple[str, ...]
    unit: str = ""
    values: Tuple[str, ...] = ()
    limits: Optional[Tuple[float, float]] = None
    logarithmic: bool = False


@dataclass(frozen=True)
class Study:
    """`settings` are the same in all runs; `ranks` is the number of each run."""

    deck: Path
    sampling: str
    variables: Tuple[Variable, ...]
    settings: Dict[str, str] = field(default_factory=dict)
    ranks: int = 1
    samples: int = 0
    seed: int = 0

    def runs(self) -> List[Dict[str, str]]:
        """Of each run the value of each variable by its name, in a fixed order."""
        names = [variable.name for variable in self.variables]
        if self.sampling == "Random":
            return self._random(names)
        values = [variable.values for variable in self.variables]
        rows = itertools.product(*values) if self.sampling == "Grid" else zip(*values)
        return [dict(zip(names, row)) for row in rows]

    def overrides(self, values: Dict[str, str]) -> List[str]:
        """Those of a run, for --set."""
        pairs = list(self.settings.items())
        pairs += [(path, values[variable.name]) for variable in self.variables
                  for path in variable.parameters]
        return [f"{path}={value}" for path, value in pairs]

    def _random(self, names: List[str]) -> List[Dict[str, str]]:
        """All digits, so that a value can be used again; the same for a seed on any machine."""
        shares = np.random.Generator(np.random.PCG64(self.seed)).random((self.samples, len(names)))
        return [{variable.name: repr(_within(variable, float(share)))
                 for variable, share in zip(self.variables, row)} for row in shares]


def _within(variable: Variable, share: float) -> float:
    low, high = variable.limits
    if variable.logarithmic:
        return float(low * (high / low)**share)
    return float(low + share * (high - low))


def read(path: Path) -> Study:
    """InputError, with the name of the entry, for whatever is wrong with the file."""
    try:
        root = ElementTree.parse(path).getroot()
    except OSError as error:
        raise InputError(f"{path} cannot be read ({error.strerror}).") from error
    except ElementTree.ParseError as error:
        raise InputError(f"{path} is not well-formed XML: {error}.") from error
    if root.tag != "ParameterList" or root.get("name") != ROOT:
        raise InputError(f"{path}: the root is not the list '{ROOT}'. A deck is no study; "
                         "examples/study has studies.")
    entries = Entries(root, str(path), TOP)
    deck = path.parent / entries.text("Deck")
    if not deck.is_file():
        raise InputError(f"{path}: Deck: there is no file {deck}. Its name is relative to the "
                         "study's folder.")
    sampling = entries.choice("Sampling", SAMPLINGS)
    is_random = sampling == "Random"
    study = Study(deck, sampling,
                  tuple(_variable(each, f"{path}: {each.get('name')}", is_random)
                        for each in entries.lists("Variables")),
                  Entries(entries.lists("Settings"), f"{path}: Settings").values,
                  entries.count("Ranks", 1, default=1),
                  entries.count("Samples", 1) if is_random else 0,
                  entries.count("Seed", 0, default=0) if is_random else 0)
    _check(study, path)
    return study


def _check(study: Study, path: Path) -> None:
    if not study.variables:
        raise InputError(f"{path}: Variables has no list: nothing varies. Run the deck itself.")
    names = [each.name for each in study.variables]
    paths = [each for variable in study.variables for each in variable.parameters]
    for what, given in (("variable", names), ("parameter", paths + list(study.settings))):
        twice = [each for each in given if given.count(each) > 1]
        if twice:
            raise InputError(f"{path}: the {what} '{twice[0]}' is given twice.")
    if study.sampling == "List":
        lengths = {each.name: len(each.values) for each in study.variables}
        if len(set(lengths.values())) > 1:
            raise InputError(f"{path}: with Sampling = List all variables need the same number of "
                             f"values; there are {lengths}.")


def _variable(node: ElementTree.Element, where: str, is_random: bool) -> Variable:
    entries = Entries(node, where, OF_VARIABLE)
    parameters = tuple(split(entries.text("Parameters")))
    unit = entries.values.get("Unit", "")
    if not is_random:
        values = tuple(split(entries.text("Values")))
        if not values or not parameters:
            raise InputError(f"{where}: Parameters and Values need at least one entry each.")
        return Variable(node.get("name"), parameters, unit, values)
    low, high = entries.number("Lowest"), entries.number("Highest")
    logarithmic = entries.choice("Distribution", DISTRIBUTIONS, "Uniform") == "Logarithmic"
    if not low < high or (logarithmic and low <= 0.0):
        raise InputError(f"{where}: Lowest = {low:g} and Highest = {high:g}: the second must be "
                         "larger, and with Distribution = Logarithmic both above 0.")
    return Variable(node.get("name"), parameters, unit, limits=(low, high),
                    logarithmic=logarithmic)


def split(text: str) -> List[str]:
    """'{a, f(b, c)}' as ['a', 'f(b, c)']; without braces one entry."""
    text = text.strip()
    if not (text.startswith("{") and text.endswith("}")):
        return [text] if text else []
    parts, depth = [""], 0
    for letter in text[1:-1]:
        depth += (letter in "({") - (letter in ")}")
        if letter == "," and depth == 0:
            parts.append("")
        else:
            parts[-1] += letter
    return [part.strip() for part in parts if part.strip()]


class Entries:
    """The entries of a list by their names; InputError, with `where`, for what is wrong."""

    def __init__(self, nodes: Iterable[ElementTree.Element], where: str,
                 allowed: Optional[set] = None):
        self.where = where
        self.values: Dict[str, Any] = {}  # text of parameters, children of lists
        for node in nodes:
            name = node.get("name", "")
            value = list(node) if node.tag == "ParameterList" else node.get("value", "")
            if allowed and name not in allowed:
                raise InputError(f"{where}: '{name}' is unknown; {', '.join(sorted(allowed))} are "
                                 "known here.")
            if name in self.values:
                raise InputError(f"{where}: '{name}' is given twice, as '{self.values[name]}' and "
                                 f"'{value}'. Keep one.")
            self.values[name] = value

    def lists(self, name: str) -> List[ElementTree.Element]:
        return self.values.get(name, [])

    def text(self, name: str, default: str = "") -> str:
        value = self.values.get(name, default)
        if not isinstance(value, str) or not value.strip():
            raise InputError(f"{self.where}: '{name}' is missing.")
        return value.strip()

    def choice(self, name: str, words: Tuple[str, ...], default: str = "") -> str:
        word = self.text(name, default)
        if word not in words:
            raise InputError(f"{self.where}: {name} = '{word}'; one of {', '.join(words)} is "
                             "wanted.")
        return word

    def number(self, name: str) -> float:
        text = self.text(name)
        try:
            value = float(text)
        except ValueError:
            value = float("nan")
        if not np.isfinite(value):
            raise InputError(f"{self.where}: {name} = '{text}' is no number.")
        return value

    def count(self, name: str, least: int, default: Any = "") -> int:
        text = self.text(name, str(default))
        if not re.fullmatch(r"\d+", text) or int(text) < least:
            raise InputError(f"{self.where}: {name} = '{text}'; a whole number from {least} on is "
                             "wanted.")
        return int(text)
