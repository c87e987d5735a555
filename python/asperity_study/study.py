"""A study: a deck, what varies in it and how, as STUDY.xml says it; and the runs that follow."""

import itertools
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

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
    entries = _entries(root, str(path), TOP)
    deck = path.parent / _text(entries, "Deck", str(path))
    if not deck.is_file():
        raise InputError(f"{path}: Deck: there is no file {deck}. Its name is relative to the "
                         "study's folder.")
    sampling = _choice(entries, "Sampling", SAMPLINGS, str(path))
    variables = tuple(_variable(each, f"{path}: {each.get('name')}", sampling)
                      for each in entries.get("Variables", ()))
    settings = _settings(entries.get("Settings", ()), path)
    study = Study(deck, sampling, variables, settings,
                  _count(entries, "Ranks", str(path), 1),
                  *((_count(entries, "Samples", str(path)), _count(entries, "Seed", str(path), 0))
                    if sampling == "Random" else ()))
    _check(study, path)
    return study


def _settings(nodes, path: Path) -> Dict[str, str]:
    settings: Dict[str, str] = {}
    for node in nodes:
        name = node.get("name", "")
        if name in settings:
            raise InputError(f"{path}: Settings: '{name}' is given twice, as '{settings[name]}' "
                             f"and '{node.get('value', '')}'. Keep one.")
        settings[name] = node.get("value", "")
    return settings


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


def _variable(node: ElementTree.Element, where: str, sampling: str) -> Variable:
    entries = _entries(node, where, OF_VARIABLE)
    parameters = tuple(split(_text(entries, "Parameters", where)))
    unit = entries.get("Unit", "")
    if sampling != "Random":
        values = tuple(split(_text(entries, "Values", where)))
        if not values or not parameters:
            raise InputError(f"{where}: Parameters and Values need at least one entry each.")
        return Variable(node.get("name"), parameters, unit, values)
    low, high = (_number(entries, name, where) for name in ("Lowest", "Highest"))
    logarithmic = _choice(entries, "Distribution", DISTRIBUTIONS, where, "Uniform") != "Uniform"
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


def _entries(node: ElementTree.Element, where: str, allowed: set) -> Dict[str, Any]:
    """Values of parameters and children of lists by name; unknown names are refused."""
    found: Dict[str, Any] = {}
    for child in node:
        name = child.get("name", "")
        if name not in allowed:
            raise InputError(f"{where}: '{name}' is unknown; {', '.join(sorted(allowed))} are "
                             "known here.")
        if name in found:
            raise InputError(f"{where}: '{name}' is given twice. Keep one.")
        found[name] = list(child) if child.tag == "ParameterList" else child.get("value", "")
    return found


def _text(entries: Dict[str, Any], name: str, where: str) -> str:
    if not isinstance(entries.get(name), str) or not entries[name].strip():
        raise InputError(f"{where}: '{name}' is missing.")
    return entries[name].strip()


def _choice(entries, name: str, words: Tuple[str, ...], where: str, default="") -> str:
    word = entries.get(name, default) or _text(entries, name, where)
    if word not in words:
        raise InputError(f"{where}: {name} = '{word}'; one of {', '.join(words)} is wanted.")
    return word


def _number(entries: Dict[str, Any], name: str, where: str) -> float:
    text = _text(entries, name, where)
    try:
        value = float(text)
    except ValueError:
        value = float("nan")
    if not np.isfinite(value):
        raise InputError(f"{where}: {name} = '{text}' is no number.")
    return value


def _count(entries: Dict[str, Any], name: str, where: str, default: Optional[int] = None) -> int:
    if default is not None and name not in entries:
        return default
    text = _text(entries, name, where)
    least = 0 if name == "Seed" else 1
    if not re.fullmatch(r"\d+", text) or int(text) < least:
        raise InputError(f"{where}: {name} = '{text}'; a whole number from {least} on is wanted.")
    return int(text)
