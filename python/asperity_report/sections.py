"""The sections of the page, each from what the run left for it."""

from typing import List

import numpy as np

from asperity.errors import InputError, NothingToShow
from asperity.log import RunLog
from asperity.run import Run
from asperity_plot import boxes, event_table
from asperity_plot.markdown import Column
from asperity_plot.windows import View
from asperity_status.facts import Facts
from asperity_status.text import describe

from . import page

MOST_COLUMNS = 9  # of a table that need not be moved sideways
SUMS = ("coupled_steps", "rate_problems", "tnnmg_iterations", "corrections", "v_cycles",
        "failed_steps", "energy_rises")
EACH = ("fixed_point_iterations", "tnnmg_iterations", "step_size", "error")


def summary(facts: Facts) -> str:
    return "\n".join(page.paragraph(line, "wrong" if line.startswith("WARNING") else "")
                     for line in describe(facts).splitlines())


def parameters(run: Run) -> str:
    changed = run.parameters.changed()
    if not changed:
        return page.paragraph("The run left no parameters.xml, or all values are the defaults.")
    note = "" if len(changed) < len(run.parameters.paths()) else page.paragraph(
        "parameters.xml does not say which values are the defaults: these are all.", "note")
    return note + page.table(["parameter", "value"], list(changed.items()), True)


def _columns(columns: List[Column]) -> str:
    """As many tables as fit the page, each with the first column."""
    parts = []
    for first in range(1, len(columns), MOST_COLUMNS - 1):
        shown = columns[:1] + columns[first:first + MOST_COLUMNS - 1]
        rows = list(zip(*(column.cells() for column in shown)))
        parts.append(page.table([column.header for column in shown], rows))
    return "\n".join(parts)


def events(run: Run, view: View, wrong: List[str]) -> str:
    try:
        if not len(run.events):
            return page.paragraph(f"No event. {run.selection}".strip())
        parts = [page.table(["", "events", "lower quartile", "median", "upper quartile"],
                            boxes.summary(run)),
                 _columns(event_table.events(run, view))]
        for table in (event_table.cycles, event_table.energy):
            try:
                parts.append(_columns(table(run)))
            except NothingToShow:
                pass
        return "\n".join(parts) + page.paragraph(
            " ".join((str(run.selection), event_table.MOMENT_NOTE, event_table.CYCLE_NOTE,
                      event_table.ENERGY_NOTE)).strip(), "note")
    except InputError as error:
        wrong.append(str(error))
        return page.paragraph(str(error), "wrong")


def solver(run: Run, log: RunLog) -> str:
    parts = []
    if run.has("steps.csv") and len(run.steps):
        parts.append(page.table(["in all steps", "number"], [["accepted_steps", len(run.steps)]] + [
            [name, f"{run.steps[name].sum():.0f}"] for name in SUMS if name in run.steps]))
        rows = []
        for name in EACH:
            if name in run.steps:
                values = np.percentile(run.steps[name], [0, 50, 90, 99, 100])
                unit = run.steps.units[name]
                rows.append([f"{name} [{unit}]" if unit else name,
                             *(f"{value:.4g}" for value in values)])
        parts.append(page.table(["of a step", "least", "median", "90 %", "99 %", "most"], rows))
    if log.work:
        parts.append(page.table(["work", "min [s]", "max [s]", "share", "count"], log.work))
        parts.append(page.paragraph("Wall time of the last process, least and most of its ranks.",
                                    "note"))
    parts += [page.paragraph(line) for line in log.report
              if line.startswith(("Effort:", "Energy", "WARNING"))]
    return "\n".join(parts) or page.paragraph("There is no step yet.")
