"""Box plots of the quantities that describe a rupture, and the same as numbers."""

from typing import Dict, List, Tuple

import matplotlib
import numpy as np

from asperity.errors import NothingToShow
from asperity.run import Run

from . import style, units
from .windows import View

QUANTITIES = (("Recurrence time", "recurrence", "s"), ("Rupture width", "width", "m"),
              ("Peak slip", "peak_slip", "m"), ("Duration", "duration", "s"),
              ("Peak slip rate", "peak_slip_rate", "m/s"))
FEWEST = 5    # events of a box
WIDE = 100.0  # from the least to the largest: the axis is logarithmic
HORIZONTAL = {"orientation": "horizontal"} if matplotlib.__version_info__ >= (3, 10) \
    else {"vert": False}  # of boxplot; the old name is deprecated
SIZES = (("Moment per length", "moment_per_length", "N"), ("Moment", "moment", "N m"),
         ("Magnitude Mw", "magnitude", ""))


def samples(run: Run) -> Dict[str, np.ndarray]:
    """Finite values [SI] of each of QUANTITIES, of the complete events.

    Recurrence is the time between the onsets of all events, since an incomplete event has an onset,
    too. An event in which a single node slipped fast has no width: it is less than two cells.
    """
    columns = dict(run.complete_events.columns, recurrence=np.diff(run.events["onset"]))
    if "width" in columns:
        columns["width"] = columns["width"][columns["width"] > 0.0]
    return {name: columns[name][np.isfinite(columns[name])] if name in columns else np.empty(0)
            for _, name, _ in QUANTITIES + SIZES}


def quantities(run: Run):
    """QUANTITIES and those of SIZES that the run has: per length on a curve, else both others."""
    return QUANTITIES + tuple(each for each in SIZES if each[1] in run.events)


def summary(run: Run) -> List[Tuple[str, int, str, str, str]]:
    """Rows of name, count, lower quartile, median, upper quartile, for the terminal."""
    rows = []
    values_of = samples(run)
    for label, name, unit in quantities(run):
        values = values_of[name]
        if values.size:
            quartiles = np.percentile(values, [25, 50, 75])
            rows.append((label, values.size, *_texts(quartiles, unit)))
    return rows


def _texts(values: np.ndarray, unit: str) -> List[str]:
    """In one unit, so that they can be compared. Moments have no prefix; a magnitude is a number
    alone."""
    if unit in ("N", "N m", ""):
        return [f"{value:.3g} {unit}" if unit else f"{value:.2f}" for value in values]
    shown = unit_of(values, unit)
    return [f"{units.rounded(float(value), 3)} {shown.name}" for value in shown(values)]


def draw(run: Run, view: View):
    """The figure; NothingToShow for a run without a complete event."""
    if not len(run.complete_events):
        left = " that is not left out" if str(run.selection) else ""
        raise NothingToShow(f"the run has no complete event{left}")
    shown = quantities(run)
    figure, axes = style.panels(len(shown), 1, (7.5, 0.95 + 1.05 * len(shown)))
    values = samples(run)
    for panel, (label, name, unit) in zip(axes[:, 0], shown):
        _box(panel, label, values[name], unit)
    count = style.counted(len(run.complete_events), "event")
    style.title(figure, f"Recurrence, size and speed of {count}")
    boxed = any(values[name].size >= FEWEST for _, name, _ in shown)
    style.note(figure, ("box: quartiles and median; whiskers: extremes; ticks: single events"
                        if boxed else "circles: single events") + _note(run))
    return figure


def _note(run: Run) -> str:
    """A note about the events that the box of widths leaves out."""
    single = int(np.sum(run.complete_events["width"] == 0.0)) \
        if "width" in run.complete_events else 0
    note = f"\nwithout width: {style.counted(single, 'event')} of a single node" if single else ""
    return note + (f"\n{run.selection}" if run.selection else "")


def unit_of(values: np.ndarray, name: str) -> units.Unit:
    if name == "s":
        return units.duration(units.largest(values))
    if not name:
        return units.Unit("", 1.0)
    if name in ("N", "N m"):
        return units.scientific(values, name)
    return units.length(values) if name == "m" else units.prefixed(values, name)


def _box(axes, label: str, values: np.ndarray, name: str) -> None:
    """Whiskers reach to the extremes; every event is a faint point below the box. Fewer than FEWEST
    events are circles: a box of them would show a distribution that nobody knows."""
    axes.set_ylim(-0.75, 0.6)
    unit = unit_of(values, name)
    axes.set_yticks([0.0], [f"{label} [{unit.name}]" if name else label])
    axes.tick_params(axis="y", length=0)
    axes.spines["left"].set_visible(False)
    if not values.size:
        axes.set_xticks([])
        axes.text(0.5, 0.5, "too few events", transform=axes.transAxes, ha="center", va="center",
                  color=style.GREY)
        return
    shown = unit(values)
    if shown.min() > 0.0 and shown.max() > WIDE * shown.min():
        axes.set_xscale("log")
    axes.grid(axis="x")
    axes.set_axisbelow(True)
    if values.size < FEWEST:
        axes.plot(shown, np.zeros(shown.size), "o", color=style.BLUE, markersize=6, alpha=0.7)
        axes.set_title(", ".join(_texts(np.sort(values), name)), loc="right", fontsize=8.5,
                       color=style.ORANGE, pad=1)
        return
    axes.boxplot(shown, **HORIZONTAL, positions=[0.0], widths=0.55, whis=(0, 100),
                 manage_ticks=False, patch_artist=True,
                 boxprops={"facecolor": "#d5e0ea", "edgecolor": style.BLUE},
                 medianprops={"color": style.ORANGE, "linewidth": 1.8},
                 whiskerprops={"color": style.BLUE}, capprops={"color": style.BLUE})
    axes.plot(shown, np.full(shown.size, -0.52), "|", color=style.GREY, markersize=6, alpha=0.6)
    axes.set_title(f"median {unit(float(np.median(values))):.3g} {unit.name}", loc="right",
                   fontsize=8.5, color=style.ORANGE, pad=1)
