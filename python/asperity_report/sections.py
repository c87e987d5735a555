"""The sections of the page, each from what the run left for it."""

import ast
import operator
import re
from typing import List

import numpy as np

from asperity.errors import InputError, NothingToShow
from asperity.log import RunLog
from asperity.parameters import NUMBER
from asperity.run import Run
from asperity_plot import event_table
from asperity_plot.events import summary as event_summary
from asperity_plot.markdown import Column
from asperity_plot.windows import View
from asperity_status.facts import Facts
from asperity_status.text import describe

from . import page

MOST_COLUMNS = 9  # of a table that need not be moved sideways
SUMS = ("coupled_steps", "rate_problems", "tnnmg_iterations", "corrections", "v_cycles",
        "failed_steps", "energy_increases")
EACH = ("fixed_point_iterations", "tnnmg_iterations", "step_size", "error")


def summary(facts: Facts) -> str:
    return "\n".join(page.paragraph(line, "wrong" if line.startswith("WARNING") else "")
                     for line in describe(facts).splitlines())


def model(log: RunLog) -> str:
    """Unknowns, cells, and how well they resolve the fault, as the run tells them."""
    return "\n".join(page.paragraph(line) for line in log.model) \
        or page.paragraph("The log does not tell them.")


def parameters(run: Run) -> str:
    changed = run.parameters.changed()
    if not changed:
        return page.paragraph("The run left no parameters.xml, or all values are the defaults.")
    note = "" if len(changed) < len(run.parameters.paths()) else page.paragraph(
        "parameters.xml does not say which values are the defaults: these are all.", "note")
    if any(text != plain(text) for text in changed.values()):
        note += page.paragraph("The run has put its values in the place of the deck's names; "
                               "formulas of numbers have their result beside them.", "note")
    return note + page.table(["parameter", "value"],
                             [(path, plain(text)) for path, text in changed.items()], True)


def plain(text: str) -> str:
    """A formula without the brackets that replaced names leave around numbers, and with its value
    if it is made of numbers alone: '(1e-09) / 2' is '1e-09 / 2 = 5e-10'."""
    short = re.sub(rf"(?<![A-Za-z0-9_])\(({NUMBER})\)(?!\s*\^)",
                   lambda found: found[0] if found[1].startswith("-") else found[1], text)
    if short == text or re.search(r"[^-+*/^() .0-9eE]", short):
        return short
    try:
        value = _value(ast.parse(short.strip().replace("^", "**"), mode="eval").body)
    except (SyntaxError, ValueError, ArithmeticError):
        return short
    return short if re.fullmatch(NUMBER, short.strip()) else f"{short} = {value:.6g}"


_OPERATIONS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
               ast.Div: operator.truediv, ast.Pow: operator.pow}


def _value(node: ast.AST) -> float:
    """ValueError for anything but numbers and the four operations and powers of them."""
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)):
        return float(node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        return -_value(node.operand)
    if isinstance(node, ast.BinOp) and type(node.op) in _OPERATIONS:
        return _OPERATIONS[type(node.op)](_value(node.left), _value(node.right))
    raise ValueError("not arithmetic")


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
                            event_summary(run)),
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
