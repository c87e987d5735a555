"""One figure of a study: events and cost of each run side by side, or over what was sampled."""

from pathlib import Path
from typing import Dict, List

import numpy as np

from asperity_plot import boxes, style, units

from .results import Column
from .study import Study, Variable

MOST_LABELS = 40


def draw(study: Study, table: List[Column], path: Path, note: str = "") -> Path:
    """Rows: number of events, quartiles of what describes them, steps, wall time; then a note."""
    style.use()
    data = {name: values for name, _, values in table}
    places, names = _places(study, data)
    rows = [row for row in _rows(data) if row[1] is not None]
    figure, axes = style.panels(len(rows), len(places),
                                (max(7.0, 3.2 * len(places)), 1.0 + 1.35 * len(rows)),
                                sharex="col", sharey="row")
    for row, (label, middle, ends, logarithmic) in enumerate(rows):
        for column, (name, where) in enumerate(places):
            panel = axes[row, column]
            panel.plot(where, middle, "o", color=style.BLUE, markersize=4)
            if ends is not None:
                panel.vlines(where, *ends, color=style.BLUE, linewidth=1.5)
            if logarithmic and np.nanmin(middle, initial=np.inf) > 0.0:
                panel.set_yscale("log")
            panel.grid(True)
            if column == 0:
                panel.set_ylabel(label)
            if row == len(rows) - 1:
                panel.set_xlabel(name)
            if study.sampling == "Random" and study.variables[column].logarithmic:
                panel.set_xscale("log")
    if names:
        axes[-1, 0].set_xticks(places[0][1], names, rotation=90, fontsize=7)
    style.title(figure, f"{len(data['run'])} runs of {study.deck.stem}; lines: quartiles")
    if note:
        style.note(figure, note)
    return style.save(figure, path, 150)


def _places(study: Study, data: Dict):
    """Where runs stand: side by side under their values, or over each variable sampled."""
    if study.sampling == "Random":
        return [(_label(each), np.array(data[each.name], dtype=float))
                for each in study.variables], []
    names = [", ".join(f"{data[each.name][run]:g}" if isinstance(data[each.name][run], float)
                       else data[each.name][run] for each in study.variables)
             for run in range(len(data["run"]))]
    label = ", ".join(_label(each) for each in study.variables)
    return [(label, np.array(data["run"]))], names if len(names) <= MOST_LABELS else []


def _label(variable: Variable) -> str:
    return f"{variable.name} [{variable.unit}]" if variable.unit else variable.name


def _rows(data: Dict):
    """(label, middles, (lower, upper), whether logarithmic)."""
    yield "Events", _numbers(data, "complete_events"), None, False
    for label, name, unit in boxes.QUANTITIES + boxes.SIZES:
        middle = _numbers(data, f"{name}_median")
        if middle is None or not np.isfinite(middle).any():
            continue
        shown = boxes.unit_of(middle, unit)
        ends = tuple(shown(_numbers(data, f"{name}_{word}"))
                     for word in ("lower_quartile", "upper_quartile"))
        yield f"{label}\n[{shown.name}]" if unit else label, shown(middle), ends, False
    yield "Steps", _numbers(data, "steps"), None, True
    wall = _numbers(data, "wall_time")
    if wall is not None:
        clock = units.duration(units.largest(wall))
        yield f"Wall time\n[{clock.name}]", clock(wall), None, True


def _numbers(data: Dict, name: str):
    return np.array(data[name], dtype=float) if name in data else None
