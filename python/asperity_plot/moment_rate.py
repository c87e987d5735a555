"""Moment rate and moment of each event over the time since its onset."""

from typing import Dict, Iterator, Tuple

import numpy as np

from asperity.errors import NothingToShow
from asperity.run import Run

from . import profiles, style, units, windows
from .windows import View

SMALL = 0.01  # of the largest moment rate of an event
MARGIN = 0.1  # durations of an event, before its onset and after its end


def draw(run: Run, view: View):
    """The figure; NothingToShow without an event in the time shown."""
    events = list(curves(run, view))
    if not events:
        raise NothingToShow("no event is in the time shown")
    last = max(pulse_end(time, rate) for _, time, rate, _ in events)
    clock = units.duration(last)
    per_length, newtons = (" per length", "N") if on_curve(run) else ("", "N m")
    rate_unit = units.scientific([units.largest(rate) for _, _, rate, _ in events], newtons + "/s")
    moment_unit = units.scientific([units.largest(moment) for *_, moment in events], newtons)
    figure, axes = style.panels(1, 2, (11.0, 4.4))
    colours = style.event_colours(axes[0, 1], np.array([number for number, *_ in events]))
    for number, time, rate, moment in events:
        axes[0, 0].plot(clock(time), rate_unit(rate), color=colours(number))
        since = time >= 0.0
        axes[0, 1].plot(clock(time[since]), moment_unit(moment[since]), color=colours(number))
    fast = of_catalogue(run)
    if fast:
        for number, time, _, moment in events:
            if number in fast:
                axes[0, 1].plot(clock(min(fast[number][0], (1.0 + MARGIN) * last)),
                                moment_unit(fast[number][1]), "o", color=colours(number),
                                markerfacecolor="white", markersize=5.0, zorder=4)
        axes[0, 1].plot([], [], "o", color=style.DARK, markerfacecolor="white", markersize=5.0,
                        label="events.csv: while V ≥ threshold")
        _add_legend(axes[0, 1])
    axes[0, 0].set(ylabel=f"Moment rate{per_length} [{rate_unit.name}]", title="Moment rate")
    axes[0, 1].set(ylabel=f"Moment{per_length} [{moment_unit.name}]",
                   title="Moment since the onset")
    for panel in axes[0]:
        panel.set_xlabel(f"Time since the onset of the event [{clock.name}]")
        panel.set_xlim(clock(-MARGIN * last), clock((1.0 + MARGIN) * last))
        panel.grid(True)
    style.note(figure, "Lines: all slip of the fault since the onset. Circles, at the end of the "
                       "event: the moment in events.csv, to which a node\nadds only while it is at "
                       "least as fast as the threshold."
               if fast else "all slip of the fault since the onset")
    style.title(figure, "Moment of the events" + (" per length of the fault" if per_length else ""))
    return figure


def of_catalogue(run: Run) -> Dict[int, Tuple[float, float]]:
    """Duration [s] and moment in events.csv of each complete event by its number."""
    table, name = run.complete_events, "moment_per_length" if on_curve(run) else "moment"
    if name not in table:
        return {}
    return {int(number): (float(duration), float(moment)) for number, duration, moment in
            zip(windows.numbers(table), table["duration"], table[name]) if np.isfinite(moment)}


def _add_legend(axes) -> None:
    """Within the panel, beside that of the events."""
    events = axes.get_legend()
    axes.legend(loc="upper left", fontsize=8, handletextpad=0.2)
    if events is not None:
        axes.add_artist(events)


def pulse_end(time: np.ndarray, rate: np.ndarray) -> float:
    """The last time [s] since the onset with a rate that is not small beside the largest. After it
    the event may creep above the threshold for a long time."""
    fast = time[rate >= SMALL * units.largest(rate)]
    return float(fast[-1]) if fast.size and fast[-1] > 0.0 else float(time[-1])


def on_curve(run: Run) -> bool:
    """Whether the run is in two dimensions, where moments are per length of the fault."""
    return "moment_rate" not in run.totals


def curves(run: Run, view: View) -> Iterator[Tuple[int, np.ndarray, np.ndarray, np.ndarray]]:
    """For each event its number, times [s] since its onset, moment rate [N m/s], and moment [N m]
    since its onset; in two dimensions both per length of the fault."""
    table = run.totals
    suffix = "_per_length" if on_curve(run) else ""
    time, rate, moment = table["time"], table["moment_rate" + suffix], table["moment" + suffix]
    events = profiles.events_within(run, view.sequence)
    if events is None or time.size < 2:
        return
    for number, onset, duration in zip(windows.numbers(events), events["onset"],
                                       events["duration"]):
        margin = MARGIN * duration
        rows = (time >= onset - margin) & (time <= onset + duration + margin)
        times = np.union1d(time[rows], [onset, min(onset + duration, time[-1])])
        yield (number, times - onset, np.interp(times, time, rate),
               np.interp(times, time, moment) - np.interp(onset, time, moment))
