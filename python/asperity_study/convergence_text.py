"""The table of a study of convergence as CSV, and as Markdown to read."""

import csv
import io
import math
from pathlib import Path
from typing import List

import numpy as np

from asperity_plot import events, markdown, units
from asperity_plot.markdown import Column

from .convergence import Part, Row, total
from .results import replace

NOTE = ("The limit follows from the three finest levels. The error is that of the first level, "
        "the deck; without an order it is the spread of the values, and so it is where the order "
        "is more than twice or less than half that of theory: such rows are marked with *, their "
        "levels are too coarse or their changes too small to tell a limit. That of the total is "
        "the sum over the variables.")


def write(folder: Path, found: List[Part]) -> List[Path]:
    """convergence.csv and convergence.md, each replaced as a whole."""
    paths = [folder / "convergence.csv", folder / "convergence.md"]
    for path, text in zip(paths, (_csv(found), text_of(found) + "\n")):
        replace(path, lambda new, text=text: new.write_text(text, encoding="utf-8"))
    return paths


def text_of(found: List[Part]) -> str:
    rows = total(found)
    pieces = [f"WARNING: {part.warning}" for part in found if part.warning]
    for part in found:
        pieces += [f"### {part.variable.name}{_theory(part)}", _table(part, rows)]
    return "\n\n".join(pieces + ["### Total", _total(rows), NOTE])


def _theory(part: Part) -> str:
    order = part.variable.refinement.order
    return f": order {order:.2g} in theory" if order else ""


def _table(part: Part, rows: List[Row]) -> str:
    """Of the rows that the part has."""
    lines = []
    for row in rows:
        key = row.event, row.quantity
        if key not in part.values:
            continue
        estimate = part.estimates[key]
        shown = _Shown(row, part.values[key], estimate.error)
        far = " *" if estimate.note and math.isfinite(estimate.order) else ""
        lines.append([*shown.names(), *map(shown.value, part.values[key]),
                      f"{estimate.order:.2f}{far}" if far else estimate.note or
                      f"{estimate.order:.2f}", shown.value(estimate.limit),
                      f"{shown.error(estimate.error)}{far}"])
    return _markdown(["event", "quantity", *levels(part), "order", "limit", "error"], lines)


def levels(part: Part) -> List[str]:
    """'deck', '2 x finer', '4 x finer'; by how much sizes and tolerances differ from the deck's."""
    factors = [float(value) for value in part.variable.values]
    return ["deck" if factor == 1.0 else f"{factor:g} x finer" if factor > 1.0
            else f"{1.0 / factor:g} x coarser" for factor in factors]


def _total(rows: List[Row]) -> str:
    lines = []
    for row in rows:
        shown = _Shown(row, [row.value], row.error)
        lines.append([*shown.names(), shown.value(row.value), shown.value(row.limit),
                      shown.error(row.error) + (" *" if row.is_doubtful else ""),
                      shown.error(100.0 * relative(row), 1.0)])
    return _markdown(["event", "quantity", "deck", "limit", "error", "%"], lines)


def _markdown(names: List[str], lines: List[List[str]]) -> str:
    columns = list(zip(*lines)) or [[] for _ in names]
    return markdown.table([Column(name, values) for name, values in zip(names, columns)])


def relative(row: Row) -> float:
    return row.error / abs(row.value) if row.value else np.nan


class _Shown:
    """A row in a unit that suits its values, with two digits of its error."""

    def __init__(self, row: Row, values: List[float], error: float):
        name = row.quantity.unit
        self._row = row
        self._unit = events.unit_of(np.array(values), name) if name in ("s", "m", "m/s") \
            else units.Unit(name, 1.0)
        size = units.largest(values)
        self._digits = min(max(2 + math.ceil(math.log10(size / error)), 3), 9) \
            if size > 0.0 and error > 0.0 else 6

    def names(self) -> List[str]:
        label = self._row.quantity.name.replace("_", " ")
        return [f"{self._row.event or ''}",
                f"{label} [{self._unit.name}]" if self._unit.name else label]

    def value(self, value: float) -> str:
        return _text(value / self._unit.factor, self._digits)

    def error(self, error: float, factor: float = 0.0) -> str:
        return _text(error / (factor or self._unit.factor), 2)


def _text(number: float, digits: int) -> str:
    return f"{number:.{digits}g}" if math.isfinite(number) else ""


def _csv(found: List[Part]) -> str:
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    header = ["event", "quantity", "unit", "value", "limit", "error", "relative error"]
    for part in found:
        header += [f"{part.variable.name} {word}" for word in
                   (*part.variable.values, "order", "limit", "error", "note")]
    writer.writerow(header)
    for row in total(found):
        key = row.event, row.quantity
        cells = [row.event or "", *row.quantity, *map(repr, (row.value, row.limit, row.error,
                                                            relative(row)))]
        for part in found:
            cells += _cells(part, key)
        writer.writerow(cells)
    return text.getvalue()


def _cells(part: Part, key) -> List[str]:
    if key not in part.values:
        return ["nan"] * (len(part.variable.values) + 3) + [part.warning]
    estimate = part.estimates[key]
    return [*map(repr, (*part.values[key], estimate.order, estimate.limit, estimate.error)),
            estimate.note]
