"""Profiles of cumulative slip: after every event, and how they come about."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.colors import Normalize

from . import maps, raster, style, units
from .errors import NothingToShow
from .history import History
from .run import Run
from .windows import View

FIELD = "slip"
PROFILES = 60        # more lines than this would merge
FEW_EVENTS = 12      # in the window; the course of more would merge
INTERSEISMIC = 40    # lines over the window at equal times, at least
COSEISMIC = 6        # lines over an event at equal times, at least


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    if run.fault.time.size < 2:
        raise NothingToShow("fault.h5 has a single time")
    figure, axes = style.panels(1, 2, (11.0, 4.8))
    along = units.length(run.fault.position)
    sign = _sign(run.fault)
    _all_events(run, axes[0, 0], along, sign, figure)
    _window(run, view, axes[0, 1], along, sign)
    for panel in axes[0]:
        low, high = min(panel.get_ylim()[0], 0.0), panel.get_ylim()[1]
        panel.set_ylim(low - 0.08 * (high - low), high + 0.08 * (high - low))
        panel.set_xlabel(style.position_label(run, "fault", along))
        panel.set_xlim(along(run.fault.position[0]), along(run.fault.position[-1]))
        panel.grid(True)
        _shade_zone(panel, run, along)
    style.title(figure, "Cumulative slip on the base of the wedge" if run.is_wedge
                else "Cumulative slip on the fault")
    return figure


def _sign(fault: History) -> float:
    """-1 if the fault slips against its tangent on the whole, so that profiles grow upwards."""
    last = fault.time.size - 1
    return -1.0 if fault.read(FIELD, slice(last, last + 1)).mean() < 0.0 else 1.0


def _label(run: Run, sign: float, unit: units.Unit) -> str:
    """On the wedge the tangent points away from the trench."""
    return f"{'Trenchward slip' if run.is_wedge and sign < 0.0 else 'Slip'} [{unit.name}]"


def _ends(run: Run) -> np.ndarray:
    if not run.has("events.csv"):
        return np.empty(0)
    return run.complete_events["onset"] + run.complete_events["duration"]


def _all_events(run: Run, axes: Axes, along: units.Unit, sign: float, figure) -> None:
    """Slip at the end of every event, or at equal times if there is none."""
    times = _ends(run)
    every = max(1, -(-times.size // PROFILES))
    heading = "At the end of every event" if every == 1 else f"At the end of one event in {every}"
    times = times[::every]
    if not times.size:
        times = np.linspace(*run.span, 30)
        heading = "At 30 equal intervals of the run, which has no event"
    profiles = sign * raster.interpolated(run.fault, FIELD, times)
    unit = units.length(profiles)
    clock = units.duration(run.span[1])
    norm = Normalize(clock(run.span[0]), clock(run.span[1]))
    colours = style.colour_map(style.SEQUENCE_COLOURS, norm)
    for time, profile in zip(times, profiles):
        axes.plot(along(run.fault.position), unit(profile), linewidth=0.8,
                  color=colours.to_rgba(clock(time)))
    figure.colorbar(colours, ax=axes, pad=0.02, aspect=32).set_label(f"Time [{clock.name}]")
    axes.set_title(heading)
    axes.set_ylabel(_label(run, sign, unit))


def _window(run: Run, view: View, axes: Axes, along: units.Unit, sign: float) -> None:
    """Slip since the window's start: at equal times between events, and at shorter ones in them."""
    interval = units.nice((view.cycles[1] - view.cycles[0]) / INTERSEISMIC)
    families = [(np.arange(view.cycles[0], view.cycles[1], interval), interval, style.BLUE)]
    families += _coseismic(run, view)
    start = raster.interpolated(run.fault, FIELD, families[0][0][:1])
    profiles = [sign * (raster.interpolated(run.fault, FIELD, times) - start)
                for times, _, _ in families]
    unit = units.length(np.concatenate(profiles))
    for values, (_, interval, colour) in zip(profiles, families):
        lines = axes.plot(along(run.fault.position), unit(values).T, color=colour, linewidth=0.6)
        lines[0].set_label(f"every {units.text(interval, 's', 1)}")
    axes.legend(loc="upper right", fontsize=8.5, ncol=2)
    clock = maps.cycles_unit(view)
    first, last = (units.rounded(time, 4) for time in clock(view.cycles))
    axes.set_title(f"From {first} to {last} {clock.name}")
    axes.set_ylabel(_label(run, sign, unit))


def _coseismic(run: Run, view: View) -> list:
    """Times within the events of the window, their interval and colour; empty for none or many."""
    if not run.has("events.csv"):
        return []
    onsets, durations = run.complete_events["onset"], run.complete_events["duration"]
    inside = (onsets >= view.cycles[0]) & (onsets <= view.cycles[1]) & (durations > 0.0)
    if not 0 < np.count_nonzero(inside) <= FEW_EVENTS:
        return []
    interval = units.nice(float(np.median(durations[inside])) / COSEISMIC)
    times = [np.arange(onset, onset + duration, interval)
             for onset, duration in zip(onsets[inside], durations[inside])]
    return [(np.concatenate(times), interval, style.ORANGE)]


def _shade_zone(axes: Axes, run: Run, along: units.Unit) -> None:
    zone = run.seismogenic_zone
    if zone is None:
        return
    low, high = along(zone)
    axes.axvspan(low, high, color="#eeeeee", zorder=0)
    axes.text(0.5 * (low + high), 0.02, "seismogenic zone", ha="center", va="bottom",
              color=style.DARK, fontsize=8.5, transform=axes.get_xaxis_transform())
