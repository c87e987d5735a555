"""One figure of a study: events and cost of each run side by side, or over what was sampled."""

from pathlib import Path
from typing import Dict, List, Optional, Tuple

import numpy as np

from asperity_plot import events, style, units

from .results import Column
from .study import Study, Variable

MOST_LABELS = 40
MOST_LINES = 12
WIDE = 20.0  # from the least value to the largest: the axis is logarithmic


def draw(study: Study, table: List[Column], path: Path, note: str = "") -> Path:
    """Rows: number of events, quartiles of what describes them, steps, wall time; then a note."""
    style.use()
    data = {name: values for name, _, values in table}
    places, names = _places(study, data)
    groups = _groups(study, data)
    rows = [row for row in _rows(data) if row[1] is not None]
    figure, axes = style.panels(len(rows), len(places),
                                (max(7.0, 3.2 * len(places)), 1.0 + 1.35 * len(rows)),
                                sharex="col", sharey="row")
    for row, (label, middle, ends, logarithmic) in enumerate(rows):
        for column, (name, where) in enumerate(places):
            panel = axes[row, column]
            for (text, mine), colour in zip(groups, style.spread(len(groups))):
                panel.plot(where[mine], middle[mine], "o-" if len(groups) > 1 else "o",
                           color=colour, markersize=4, linewidth=0.8, label=text)
                if ends is not None:
                    panel.vlines(where[mine], ends[0][mine], ends[1][mine], color=colour,
                                 linewidth=1.5)
            if logarithmic and np.nanmin(middle, initial=np.inf) > 0.0:
                panel.set_yscale("log")
            panel.grid(True)
            if column == 0:
                panel.set_ylabel(label)
            if row == len(rows) - 1:
                panel.set_xlabel(name)
            if study.sampling == "Random" and study.variables[column].logarithmic \
                    or study.sampling != "Random" and not names and _is_wide(where):
                panel.set_xscale("log")
    if len(groups) > 1:
        axes[0, -1].legend(loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8.5)
    if names:
        axes[-1, 0].set_xticks(places[0][1], names, rotation=90, fontsize=7)
    style.title(figure, f"{len(data['run'])} runs of {study.deck.stem}; lines: quartiles")
    if note:
        style.note(figure, note)
    return style.save(figure, path, 150)


def _axis(study: Study, data: Dict) -> Optional[Variable]:
    """The variable of a grid over which its runs stand: of those that are numbers the one with the
    most values."""
    if study.sampling != "Grid":
        return None
    numeric = [each for each in study.variables if len(each.values) > 1
               and all(isinstance(value, float) for value in data[each.name])]
    return max(numeric, key=lambda each: len(each.values), default=None)


def _groups(study: Study, data: Dict) -> List[Tuple[str, np.ndarray]]:
    """(name, runs) of the lines of a grid: the runs that have all but one value in common; all runs
    of other studies."""
    over = _axis(study, data)
    others = [each for each in study.variables if each is not over] if over else []
    found: Dict[str, List[int]] = {}
    for run in range(len(data["run"])):
        text = ", ".join(f"{each.name} {_value(data, each, run)} {each.unit}".strip()
                         for each in others)
        found.setdefault(text, []).append(run)
    if len(found) > MOST_LINES:
        return [("", np.arange(len(data["run"])))]
    key = np.array(data[over.name], dtype=float) if over else np.arange(len(data["run"]))
    return [(text, np.array(sorted(runs, key=lambda run: key[run])))
            for text, runs in found.items()]


def _is_wide(where: np.ndarray) -> bool:
    return where.min() > 0.0 and where.max() >= WIDE * where.min()


def _value(data: Dict, variable: Variable, run: int) -> str:
    value = data[variable.name][run]
    return f"{value:g}" if isinstance(value, float) else value


def _places(study: Study, data: Dict):
    """Where runs stand: over each variable sampled, over one of a grid, or side by side under their
    values."""
    if study.sampling == "Random":
        return [(_label(each), np.array(data[each.name], dtype=float))
                for each in study.variables], []
    over = _axis(study, data)
    if over:
        return [(_label(over), np.array(data[over.name], dtype=float))], []
    names = [", ".join(_value(data, each, run) for each in study.variables)
             for run in range(len(data["run"]))]
    label = ", ".join(_label(each) for each in study.variables)
    return [(label, np.array(data["run"]))], names if len(names) <= MOST_LABELS else []


def _label(variable: Variable) -> str:
    return f"{variable.name} [{variable.unit}]" if variable.unit else variable.name


def _rows(data: Dict):
    """(label, middles, (lower, upper), whether logarithmic)."""
    yield "Events", _numbers(data, "complete_events"), None, False
    for label, name, unit in events.QUANTITIES + events.SIZES:
        middle = _numbers(data, f"{name}_median")
        if middle is None or not np.isfinite(middle).any():
            continue
        shown = events.unit_of(middle, unit)
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
