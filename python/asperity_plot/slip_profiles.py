"""Cumulative slip over depth or along the fault: some years apart, and seconds in ruptures."""

import textwrap
from dataclasses import replace
from typing import List

import numpy as np
from matplotlib.axes import Axes

from asperity.run import Run

from . import along, profiles, style, units
from .windows import View

MOST = 12  # events in the panel of a fault, on the average
ADVICE = "let Fault History write more rows"


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    run.fault.require_two_times()
    faults = along.alike(along.faults(run, run.fault))
    view = _with_few_events(run, view, len(faults))
    families = lines(run, view)
    figure, axes = style.fault_panels(
        faults, (7.5, 5.0) if faults[0].is_downwards else (9.0, 5.0))
    unit = units.length([units.largest(each.slip) for each in families])
    for panel, where in zip(axes, faults):
        _draw(panel, run, families, where, unit)
    style.share_labels(axes)
    style.share_limits(axes, "x" if faults[0].is_downwards else "y")
    _legend(style.upper_right(axes))
    clock = units.duration(view.sequence[1])
    first, last = (units.rounded(time, 4) for time in clock(view.sequence))
    axes[0].set_title(f"From {first} to {last} {clock.name}", loc="left")
    remark = doubts(families)
    if remark:
        style.note(figure, textwrap.fill(remark, 110))
    style.title(figure, profiles.title(run))
    return figure


def _with_few_events(run: Run, view: View, num_faults: int) -> View:
    """The lines of more than MOST events on a fault would be one block: some cycles instead."""
    events = profiles.events_within(run, view.sequence)
    many = events is not None and len(events) > MOST * num_faults and not view.chosen
    return replace(view, sequence=view.cycles) if many else view


def lines(run: Run, view: View) -> List[profiles.Family]:
    """The profiles between events and those in them; slip since the start of the time shown."""
    window = view.sequence
    events = profiles.events_within(run, window)
    between, during = view.options.intervals or profiles.intervals(window, events)
    families = [
        profiles.family(run.fault, profiles.between_events(window, between, events), between),
        profiles.family(run.fault, profiles.in_events(window, during, events), during)]
    if _is_cut(run, view):
        start = profiles.family(run.fault, np.array(window[:1]), between).slip
        families = [replace(each, slip=each.slip - start) for each in families]
    return families


def _is_cut(run: Run, view: View) -> bool:
    """Whether slip counts from a later time than the start of the run."""
    return view.sequence[0] > run.span[0]


def doubts(families: List[profiles.Family]) -> str:
    """A remark about lines that are interpolated between rows far apart; or ''."""
    remarks = [f"{each.num_doubtful} of the {each.times.size} lines {name} are interpolated "
               f"between times more than {units.plain(each.interval, 's')} apart"
               for each, name in zip(families, ("between events", "in events"))
               if each.num_doubtful]
    return f"{' and '.join(remarks)}: {ADVICE}" if remarks else ""


def _draw(axes: Axes, run: Run, families: List[profiles.Family], where: along.Axis,
          unit: units.Unit) -> None:
    """Slip across and depth downwards, or slip upwards over the position."""
    for each, colour in zip(families, (style.BLUE, style.ORANGE)):
        for number, slip in enumerate(unit(each.slip)):
            label = f"every {units.plain(each.interval, 's')}" if number == 0 else None
            where.line(axes, run.fault.position, slip, color=colour, linewidth=0.6, label=label)
    if where.is_downwards:
        axes.set_ylim(where.range)
    else:
        axes.set_xlim(where.range)
        axes.margins(y=0.08)
    style.frame(axes, run, where, profiles.label(run, unit))


def _legend(axes: Axes) -> None:
    """Above the panel and its title."""
    legend = axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncol=2, fontsize=8.5,
                         borderaxespad=2.4)
    for line in legend.get_lines():
        line.set_linewidth(1.5)
