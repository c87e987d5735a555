"""Series at receivers on the fault: slip rate, shear traction, state and slip over time."""

from typing import Dict, List, Tuple

import numpy as np

from asperity.errors import NothingToShow
from asperity.receivers import ON_FAULT
from asperity.run import Run
from asperity.series import Series

from . import maps, reference, style, units, windows
from .windows import View

MANY = 12  # receivers; the lines of more would merge
LABELS = {"slip_rate": "Slip rate V", "traction": "Shear traction τ", "theta": "State θ",
          "slip": "Slip"}
LOGARITHMIC = {"slip_rate": "m/s", "theta": "s"}

Line = Tuple[Series, Dict]  # and how it is drawn


def draw(run: Run, view: View):
    """The figure; NothingToShow without receivers on the fault or fields in LABELS there."""
    names = thinned(run.receivers.shown(ON_FAULT, view.options.receivers))
    fields = [field for field in LABELS if field in run.receivers.fields()]
    if not fields:
        raise NothingToShow(f"receivers.h5 has none of the fields {', '.join(LABELS)}")
    series = run.receivers.series(names)
    references = reference.read_all(view.options.references, names)
    figure, axes, beside = panels(len(fields), [2.25] if view.zoom is None else [1.25, 1.0])
    whole = windows.over_sequence(run, view)
    _column(axes[:, 0], fields, _lines(series, references), whole.cycles, 0.0)
    maps.label_cycles(axes[0, 0], whole, axes[-1, 0])
    if view.zoom is not None:
        references = [aligned(each, series, run.threshold, view.onset) for each in references]
        _column(axes[:, 1], fields, _lines(series, references), view.zoom, view.onset)
        maps.label_zoom(axes[0, 1], view, axes[-1, 1])
    beside.legend(*axes[0, -1].get_legend_handles_labels(), loc="upper left", fontsize=8.5,
                  borderaxespad=0.0)
    figure.align_ylabels()
    style.title(figure, "Receivers on the fault: slip and traction along the total slip")
    return figure


def panels(rows: int, widths: List[float], sharey: str = "row"):
    """A figure, its axes (rows, columns), and empty axes beside all rows for the legend."""
    figure, axes = style.panels(rows, len(widths) + 1, (11.0, 1.0 + 1.9 * rows), sharex="col",
                                sharey=sharey, gridspec_kw={"width_ratios": widths + [0.3]})
    for panel in axes[:, -1]:
        panel.remove()
    beside = figure.add_subplot(axes[0, 0].get_gridspec()[:, -1])
    beside.set_axis_off()
    return figure, axes[:, :-1], beside


def thinned(names: List[str]) -> List[str]:
    """At most MANY of them, evenly chosen."""
    return [names[row] for row in np.unique(np.linspace(0, len(names) - 1, MANY).astype(int))]


def aligned(other: Series, series: List[Series], threshold: float, onset: float) -> Series:
    """`other` so that it becomes seismic when its receiver does, in the event at `onset` [s].

    Codes differ by years in an onset and by fractions of a second in the rupture's course. Nothing
    is moved where no receiver belongs to it or either does not become seismic.
    """
    mine = next((each for each in series if each.label == other.receiver), None)
    rise = mine.rise(threshold, onset) if mine else None
    begin = other.rise(threshold, onset)
    if rise is None or begin is None:
        return other
    delay = rise - begin
    sense = "later" if delay > 0.0 else "earlier"
    return other.shifted(delay, f"{other.label}\nshown {units.text(abs(delay), 's')} {sense}")


def _lines(series: List[Series], references: List[Series]) -> List[Line]:
    """Colours from the first receiver to the last; of many, a reference has its receiver's."""
    colours = dict(zip((each.label for each in series), style.spread(len(series))))
    lines = [(each, {"color": colours[each.label], "linewidth": 1.1}) for each in series]
    for each in references:
        single = style.ORANGE if len(series) == 1 else style.DARK
        colour = colours[each.receiver] if each.receiver and len(series) > 1 else single
        lines.append((each, {"color": colour, "linewidth": 1.3, "linestyle": (0, (4, 2))}))
    return lines


def _column(axes, fields: List[str], lines: List[Line], window: windows.Window,
            origin: float) -> None:
    """One panel below the other over the part of the time since `origin` [s] in `window`."""
    clock = units.duration(max(abs(window[0] - origin), window[1] - origin))
    lines = [(each.within(window), look) for each, look in lines]
    for panel, field in zip(axes, fields):
        drawn = [(each, look) for each, look in lines if field in each.values]
        unit = _unit(field, [each for each, _ in drawn])
        for each, look in drawn:
            values = unit(each.values[field])
            if field in LOGARITHMIC:
                values = np.where(values > 0.0, values, np.nan)
            panel.plot(clock(each.time - origin), values, label=style.wrapped(each.label), **look)
        panel.set_yscale("log" if field in LOGARITHMIC else "linear")
        panel.grid(True)
        if panel.get_subplotspec().is_first_col():
            panel.set_ylabel(f"{LABELS[field]} [{unit.name}]")


def _unit(field: str, series: List[Series]) -> units.Unit:
    if field in LOGARITHMIC:
        return units.Unit(LOGARITHMIC[field], 1.0)
    sizes = [units.largest(each.values[field]) for each in series]
    return units.length(sizes) if field == "slip" else units.prefixed(sizes, "Pa")
