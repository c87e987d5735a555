"""The study of convergence of any deck: cells, tolerances and the largest step, one by one."""

import subprocess
from pathlib import Path
from typing import Dict, List, Tuple

from asperity.errors import InputError
from asperity.parameters import Parameters

from . import refinement
from .study import CONVERGENCE, RECEIVERS, Study, Variable

STEPPING = "Time Stepping"
LARGEST, SMALLEST = f"{STEPPING}/Largest Step", f"{STEPPING}/Smallest Step"
# With a scheme of second order the error of a step is of third order: an eighth halves the steps.
RATIO, OF_TOLERANCES = 2.0, 8.0
FIRST_ORDER = "Backward Euler"


def convergence(deck: Path, program: Path, changes: List[str], coarser: bool) -> Study:
    """`changes` are 'path=value', as for --set. With `coarser` the deck is the finest level."""
    if not deck.is_file():
        raise InputError(f"--convergence: there is no file {deck}.")
    changed = dict(_change(each) for each in changes)
    own = Parameters.read(deck)
    named = {**{path: own[path] for path in own.paths()}, **changed}
    defaults = _defaults(program)
    given = {**{path: defaults[path] for path in defaults.paths()}, **named}
    variables = tuple(_variable(name, paths, given, ratio, change, coarser)
                      for name, paths, ratio, change in _refined(named, given))
    receivers = tuple(path[len(RECEIVERS):] for path in named if path.startswith(RECEIVERS))
    return Study(deck, CONVERGENCE, variables, changed, receivers=receivers)


def _change(text: str):
    path, separator, value = text.partition("=")
    if not separator:
        raise InputError(f"--set {text}: 'Path/To/Parameter=value' is wanted.")
    return path, value


def _defaults(program: Path) -> Parameters:
    result = subprocess.run([str(program), "--print-parameters", "--format", "xml"], text=True,
                            capture_output=True, check=False)
    if result.returncode != 0:
        raise InputError(f"{program} does not print its parameters: {result.stderr.strip()}")
    return Parameters.of_text(result.stdout, f"what {program} prints")


def _refined(named: Dict[str, str], given: Dict[str, str]):
    """(name, parameters, ratio, change) of each variable; `named` are those of the deck alone."""
    mesh = f"Mesh/{given['Mesh/Type']}/"
    if f"{mesh}Cell Size" in named and f"{mesh}Cell Size Factor" in given:
        yield "cells", (f"{mesh}Cell Size Factor",), RATIO, "Divide"
    elif f"{mesh}Cell Size" in given:
        yield "cells", (f"{mesh}Cell Size",), RATIO, "Divide"
    else:
        yield "cells", ("Mesh/Refinements",), RATIO, "Add"
    tolerance = f"{STEPPING}/{given[f'{STEPPING}/Control']}/Tolerance"
    if tolerance not in given:
        yield "step", tuple(path for path in (LARGEST, SMALLEST) if path in named), RATIO, "Divide"
        return
    yield "tolerance", (tolerance, "Coupling/Tolerance"), OF_TOLERANCES, "Divide"
    yield "largest step", (LARGEST,), RATIO, "Divide"


def _theory(name: str, given: Dict[str, str]) -> Tuple[float, float]:
    """The order of the error, and the power with which the cost grows, in the factor by which
    a variable is refined. Linear elements have second order. With a scheme of order p the error of
    a step is of order p + 1: p / (p + 1) in a tolerance, whose factor^(1 / (p + 1)) cuts steps."""
    scheme = 1.0 if given.get(f"{STEPPING}/Scheme") == FIRST_ORDER else 2.0
    if name == "cells":
        return 2.0, 3.0 if given.get("Bulk/Model") == "Solid" else 2.0
    if name == "tolerance":
        return scheme / (scheme + 1.0), 1.0 / (scheme + 1.0)
    return scheme, 1.0


def _variable(name: str, paths, given: Dict[str, str], ratio: float, change: str,
              coarser: bool) -> Variable:
    how = refinement.checked(paths, given, 1.0 / ratio if coarser else ratio, refinement.FEWEST,
                             change, f"--convergence: {name} (--set may give a number)",
                             *_theory(name, given))
    return Variable(name, tuple(paths), values=how.factors(), refinement=how)
