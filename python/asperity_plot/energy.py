"""Balance of energy over the run: the energies, and the error of their sum."""

from typing import Dict, Optional

import numpy as np

from asperity.errors import NothingToShow
from asperity.run import Run
from asperity.tables import Table

from . import style, units
from .windows import View

SMALL = 1e-3   # of the largest: such a line would lie on zero
POINTS = 4000  # of a line; a reader cannot tell more of them apart
COLOURS = (style.BLUE, style.ORANGE, "#4d8b57", "#7a5195", style.GREY, "#a8893a", "#c06c9b",
           "#3b9aa0")
SINCE_THE_START = ("work", "dissipation")  # in the names of columns that count from there


def draw(run: Run, view: View):
    """The figure; NothingToShow if steps.csv does not account for energy."""
    steps = run.steps
    imbalance, work = _column(steps, "defect", "imbalance"), _column(steps, "friction_work")
    if imbalance is None or work is None:
        raise NothingToShow("steps.csv has no columns for the imbalance of energy and the work of "
                            "friction")
    if not len(steps):
        raise NothingToShow("the run has accepted no step")
    figure, axes = style.panels(2, 1, (9.5, 5.6), sharex=True,
                                gridspec_kw={"height_ratios": [1.5, 1.0]})
    clock = units.duration(units.largest(steps["time"]))
    _energies(axes[0, 0], steps, imbalance, clock)
    relative = _relative(steps[imbalance], _largest_work(steps))
    _closure(axes[1, 0], clock(steps["time"]), relative)
    axes[1, 0].set_xlabel(f"Time [{clock.name}]")
    axes[1, 0].set_xlim(clock(run.span))
    figure.align_ylabels()
    style.title(figure, "Balance of energy since the start of the run")
    return figure


def _column(steps: Table, *words: str) -> Optional[str]:
    """The first column whose name has one of `words` in it."""
    return next((name for name in steps.columns if any(word in name for word in words)), None)


def _largest_work(steps: Table) -> np.ndarray:
    """Of each step the largest of the works so far, as asperity-status has it: that of friction
    alone is 0 while a fault is locked."""
    works = [np.abs(steps[name]) for name in steps.columns if name.endswith("_work")]
    return np.maximum.accumulate(np.max(works, axis=0))


def _relative(imbalance: np.ndarray, size: np.ndarray) -> np.ndarray:
    """|imbalance| over the largest work so far; nan before there is any."""
    return np.divide(np.abs(imbalance), size, out=np.full(size.shape, np.nan), where=size > 0.0)


def _energies(axes, steps: Table, imbalance: str, clock: units.Unit) -> None:
    """Lines for all columns in joules but the imbalance, which would lie on zero.

    Works count from the start of the run, and energies are shown as their change since then.
    """
    rows = np.unique(np.linspace(0, len(steps) - 1, POINTS).astype(int))
    lines: Dict[str, np.ndarray] = {}
    for name, unit in steps.units.items():
        if unit.startswith("J") and name != imbalance:
            label = name.replace("_", " ")
            if any(word in name for word in SINCE_THE_START):
                lines[label.capitalize()] = steps[name][rows]
            else:
                lines[f"Change of {label}"] = steps[name][rows] - steps[name][0]
    unit = units.prefixed(np.concatenate(list(lines.values())), steps.units[imbalance] or "J")
    largest = max(units.largest(values) for values in lines.values())
    small = [label for label, values in lines.items() if units.largest(values) < SMALL * largest]
    shown = {label: values for label, values in lines.items() if label not in small}
    if small:
        axes.set_title(style.wrapped(f"Not drawn, below {100 * SMALL:g} % of the largest: "
                                     f"{', '.join(small).lower()}", 95),
                       fontsize=8.5, loc="left")
    for (label, values), colour in zip(shown.items(), COLOURS):
        axes.plot(clock(steps["time"][rows]), unit(values), color=colour, label=label)
    axes.set_ylabel(f"Energy [{unit.name}]")
    axes.grid(axis="y")
    axes.legend(loc="center left", bbox_to_anchor=(1.01, 0.5), fontsize=8.5)


def _closure(axes, time: np.ndarray, relative: np.ndarray) -> None:
    """The relative imbalance, in steps of the run thinned to the largest of each stretch."""
    positive = np.flatnonzero(relative > 0.0)
    last = relative[np.isfinite(relative)]
    final = f"{last[-1]:.1e}" if last.size else "unknown"
    axes.set_title(f"Imbalance relative to the largest work so far: {final} at the end")
    axes.set_ylabel("Relative imbalance")
    axes.grid(axis="y")
    if positive.size:
        pieces = np.array_split(positive, min(POINTS, positive.size))
        largest = [piece[np.argmax(relative[piece])] for piece in pieces]
        axes.semilogy(time[largest], relative[largest], color=style.BLUE, linewidth=0.8)
