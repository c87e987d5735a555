"""The table of a study of convergence: how far the results of a deck are from their limits."""

from dataclasses import dataclass, field
from typing import Dict, List, Optional

import numpy as np

from asperity.errors import InputError
from asperity.run import Run
from asperity.selection import Selection

from . import order, quantities
from .order import Estimate
from .quantities import Quantity
from .runner import Job
from .study import Study, Variable

EVENTS = Quantity("events", "")  # their number


@dataclass
class Part:
    """What one variable does: of each row `values` on all levels and the `estimates` from them. A
    row is (event, quantity); events have the numbers 1, 2, ... among those that count, and how many
    there are is a quantity of 0."""

    variable: Variable
    values: Dict = field(default_factory=dict)
    estimates: Dict[object, Estimate] = field(default_factory=dict)
    warning: str = ""


@dataclass
class Row:
    """`value` of the deck; `limit` and `error` with the parts of all variables, nan where one has
    none."""

    event: int
    quantity: Quantity
    value: float
    limit: float
    error: float
    is_doubtful: bool = False  # the order of some part is far from theory


def parts(study: Study, jobs: List[Job], values: List[Dict[str, str]],
          selection: Selection = Selection()) -> List[Part]:
    """One for each variable, from the runs in which only that one differs from the deck."""
    runs = [_finished(job, selection) for job in jobs]
    first = values[0]
    found = []
    for variable in study.variables:
        wanted = [{**first, variable.name: factor} for factor in variable.values]
        found.append(_part(variable, [runs[values.index(each)] for each in wanted],
                           study.receivers))
    return found


def _finished(job: Job, selection: Selection) -> Optional[Run]:
    """None of a run that has not come to its end, or cannot be read."""
    if job.state != "finished":
        return None
    try:
        run = Run(job.folder, selection)
        run.events
        return run
    except InputError as error:
        job.message = job.message or str(error)
        return None


def _part(variable: Variable, runs: List[Optional[Run]], receivers) -> Part:
    part, ratio = Part(variable), variable.refinement.ratio
    levels = dict(zip(variable.values, runs))
    missing = [factor for factor, run in levels.items() if run is None]
    if missing:
        part.warning = f"{variable.name}: no results with {_listed(missing)}, and so no errors."
        return part
    counts = [len(run.events) for run in runs]
    common = quantities.number_in_common(runs)
    if common < max(counts):
        part.warning = (f"{variable.name}: {_listed(counts)} events with "
                        f"{_listed(variable.values)}; those after the first {common} do not "
                        "correspond and have no numbers.")
    _add(part, (0, EVENTS), counts, order.of_counts(counts, ratio))
    measured = [quantities.measured(run, receivers) for run in runs]
    for event in range(common):
        for quantity in measured[0]:
            on_levels = [float(each[quantity][event]) for each in measured]
            if not np.isnan(on_levels).all():
                _add(part, (event + 1, quantity), on_levels,
                     order.estimate(on_levels, ratio, variable.refinement.order))
    return part


def _add(part: Part, row, values, estimate: Estimate) -> None:
    part.values[row], part.estimates[row] = [float(value) for value in values], estimate


def _listed(items) -> str:
    return ", ".join(f"{item}" for item in items)


def total(found: List[Part]) -> List[Row]:
    """The rows of all parts. The error is the sum of those of the parts, so that they do not cancel
    each other; the limit is corrected by all of them. A row is marked where the order of some
    part is far from theory."""
    rows = []
    for event, quantity in dict.fromkeys(row for part in found for row in part.values):
        key = event, quantity
        estimates = [part.estimates.get(key, Estimate()) for part in found]
        value = next(part.values[key][0] for part in found if key in part.values)
        rows.append(Row(event, quantity, value,
                        value + sum(each.limit - value for each in estimates),
                        sum(each.error for each in estimates),
                        any(each.note and np.isfinite(each.order) for each in estimates)))
    return sorted(rows, key=lambda row: row.event)
