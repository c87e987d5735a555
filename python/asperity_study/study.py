"""A study: a deck, what varies in it and how, as STUDY.xml says it; and the runs that follow."""

import itertools
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, Iterable, List, Optional, Tuple

import numpy as np

from asperity.errors import InputError
from asperity.parameters import Parameters

from . import refinement
from .refinement import Refinement

CONVERGENCE = "Convergence"
ROOT, SAMPLINGS = "Asperity Study", ("Grid", "List", "Random", CONVERGENCE)
TOP = {"Deck", "Sampling", "Samples", "Seed", "Ranks", "Receivers", "Settings", "Variables"}
OF_VARIABLE = {"Parameters", "Unit", "Values", "Lowest", "Highest", "Distribution"}
OF_REFINED = {"Parameters", "Ratio", "Levels", "Change", "Order"}
RECEIVERS = "Output/Receivers/On Fault/"
DISTRIBUTIONS = ("Uniform", "Logarithmic")


@dataclass(frozen=True)
class Variable:
    """`values` for grids and lists, `limits` and `logarithmic` for random samples. A value goes to
    all `parameters` (paths below the deck's root) alike. With a `refinement` the values are factors
    by which it changes each of them."""

    name: str
    parameters: Tuple[str, ...]
    unit: str = ""
    values: Tuple[str, ...] = ()
    limits: Optional[Tuple[float, float]] = None
    logarithmic: bool = False
    refinement: Optional[Refinement] = None

    def settings(self, value: str) -> Dict[str, str]:
        """Of the parameters by their paths, in a run with this value."""
        return {path: self.refinement.value(path, value) if self.refinement else value
                for path in self.parameters}


@dataclass(frozen=True)
class Study:
    """`settings` are the same in all runs; `ranks` is the number of each run. Arrivals at the
    `receivers` are in the table of a study of convergence."""

    deck: Path
    sampling: str
    variables: Tuple[Variable, ...]
    settings: Dict[str, str] = field(default_factory=dict)
    ranks: int = 1
    samples: int = 0
    seed: int = 0
    receivers: Tuple[str, ...] = ()

    def runs(self) -> List[Dict[str, str]]:
        """Of each run the value of each variable by its name, in a fixed order."""
        names = [variable.name for variable in self.variables]
        if self.sampling == "Random":
            return self._random(names)
        if self.sampling == CONVERGENCE:
            return self._cross()
        values = [variable.values for variable in self.variables]
        rows = itertools.product(*values) if self.sampling == "Grid" else zip(*values)
        return [dict(zip(names, row)) for row in rows]

    def overrides(self, values: Dict[str, str]) -> List[str]:
        """Those of a run, for --set."""
        pairs = dict(self.settings)
        for variable in self.variables:
            pairs.update(variable.settings(values[variable.name]))
        return [f"{path}={value}" for path, value in pairs.items()]

    def _cross(self) -> List[Dict[str, str]]:
        """The deck, and then one variable after the other on all its other levels."""
        deck = {variable.name: variable.values[0] for variable in self.variables}
        return [deck] + [{**deck, variable.name: value} for variable in self.variables
                         for value in variable.values[1:]]

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
    settings = Entries(entries.lists("Settings"), f"{path}: Settings").values
    of_deck, receivers = {}, ()
    if sampling == CONVERGENCE:
        of_deck = {**_parameters(deck), **settings}
        receivers = _receivers(entries, of_deck)
    study = Study(deck, sampling,
                  tuple(_refined(each, f"{path}: {each.get('name')}", of_deck)
                        if sampling == CONVERGENCE else
                        _variable(each, f"{path}: {each.get('name')}", is_random)
                        for each in entries.lists("Variables")),
                  settings,
                  entries.count("Ranks", 1, default=1),
                  entries.count("Samples", 1) if is_random else 0,
                  entries.count("Seed", 0, default=0) if is_random else 0,
                  receivers)
    _check(study, path)
    return study


def _parameters(deck: Path) -> Dict[str, str]:
    """All that the deck gives, by their paths."""
    given = Parameters.read(deck)
    return {path: given[path] for path in given.paths()}


def _receivers(entries: "Entries", given: Dict[str, str]) -> Tuple[str, ...]:
    names = tuple(split(entries.values.get("Receivers", "")))
    known = [path[len(RECEIVERS):] for path in given if path.startswith(RECEIVERS)]
    for name in names:
        if name not in known:
            raise InputError(f"{entries.where}: Receivers: the deck has no receiver '{name}' on "
                             f"the fault; it has {', '.join(known) or 'none'}.")
    return names


def _check(study: Study, path: Path) -> None:
    if not study.variables:
        raise InputError(f"{path}: Variables has no list: nothing varies. Run the deck itself.")
    _refuse_twice([(each.name, "Variables") for each in study.variables], "variable", path)
    places = [(each, f"Variables / {variable.name}") for variable in study.variables
              for each in variable.parameters]
    if study.sampling != CONVERGENCE:  # there Settings give the values of the first level
        places += [(each, "Settings") for each in study.settings]
    _refuse_twice(places, "parameter", path)
    if study.sampling == "List":
        lengths = {each.name: len(each.values) for each in study.variables}
        if len(set(lengths.values())) > 1:
            raise InputError(f"{path}: with Sampling = List all variables need the same number of "
                             f"values; there are {lengths}.")


def _refuse_twice(places: List[Tuple[str, str]], what: str, path: Path) -> None:
    """`places` are names with the lists that give them."""
    for name in dict.fromkeys(name for name, _ in places):
        where = [place for each, place in places if each == name]
        if len(where) > 1:
            raise InputError(f"{path}: the {what} '{name}' is given twice, in "
                             f"{' and in '.join(dict.fromkeys(where))}. Keep one.")


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


def _refined(node: ElementTree.Element, where: str, given: Dict[str, str]) -> Variable:
    """`given` are the parameters of the deck."""
    entries = Entries(node, where, OF_REFINED)
    parameters = tuple(split(entries.text("Parameters")))
    if not parameters:
        raise InputError(f"{where}: Parameters needs at least one entry.")
    how = refinement.checked(parameters, given, entries.number("Ratio", "2"),
                             entries.count("Levels", refinement.FEWEST, refinement.FEWEST),
                             entries.choice("Change", refinement.CHANGES, "Divide"), where,
                             entries.number("Order") if "Order" in entries.values else None)
    return Variable(node.get("name"), parameters, values=how.factors(), refinement=how)


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

    def number(self, name: str, default: str = "") -> float:
        text = self.text(name, default)
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
