"""Profiles of cumulative slip after every event."""

from typing import Tuple

import numpy as np
from matplotlib.colors import Normalize

from asperity.run import Run

from . import along, profiles, raster, style, units
from .windows import View

PROFILES = 60  # more lines than this would merge


def draw(run: Run, view: View):
    """The figure; NothingToShow if the history has a single row."""
    run.fault.require_two_times()
    times, heading = _times(run)
    slip = profiles.sign(run.fault) * raster.interpolated(run.fault, profiles.FIELD, times)
    where, unit = along.axis(run, run.fault, "fault"), units.length(slip)
    clock = units.duration(run.span[1])
    colours = style.colour_map(style.SEQUENCE_COLOURS, Normalize(*clock(run.span)))
    figure, axes = style.panels(1, 1, (8.0, 4.8))
    for time, profile in zip(times, slip):
        axes[0, 0].plot(where(run.fault.position), unit(profile), linewidth=0.8,
                        color=colours.to_rgba(clock(time)))
    figure.colorbar(colours, ax=axes, pad=0.02, aspect=32).set_label(f"Time [{clock.name}]")
    axes[0, 0].set(title=heading, xlabel=where.label, ylabel=profiles.label(run, unit))
    axes[0, 0].set_xlim(sorted(where(where.limits)))
    axes[0, 0].margins(y=0.08)
    axes[0, 0].grid(True)
    style.shade_zone(axes[0, 0], run, where)
    style.title(figure, profiles.title(run))
    return figure


def _times(run: Run) -> Tuple[np.ndarray, str]:
    """The end of every event, or equal times if there is none, and what to call them."""
    if not run.has("events.csv") or not len(run.complete_events):
        return np.linspace(*run.span, 30), "At 30 equal times; no event ended in the run"
    ends = run.complete_events["onset"] + run.complete_events["duration"]
    every = max(1, -(-ends.size // PROFILES))
    heading = "At the end of every event" if every == 1 else f"At the end of one event in {every}"
    return ends[::every], heading
