"""Profiles of cumulative slip after every event."""

from dataclasses import replace
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
    faults = [replace(where, is_downwards=False) for where in along.faults(run, run.fault)]
    unit = units.length(slip)
    clock = units.duration(run.span[1])
    colours = style.colour_map(style.SEQUENCE_COLOURS, _norm(clock(times)))
    figure, axes = style.fault_panels(faults, (8.0, 4.8))
    for panel, where in zip(axes, faults):
        for time, profile in zip(times, unit(slip)):
            where.line(panel, run.fault.position, profile, linewidth=0.8,
                       color=colours.to_rgba(clock(time)))
        panel.set(xlabel=where.label, ylabel=profiles.label(run, unit))
        panel.set_xlim(sorted(where(where.limits)))
        panel.margins(y=0.08)
        panel.grid(True)
        style.shade_zone(panel, run, where)
    style.share_labels(axes)
    style.share_limits(axes, "y")
    axes[0].set_title(heading, loc="left" if len(faults) > 1 else "center")
    figure.colorbar(colours, ax=axes, pad=0.02, aspect=32).set_label(f"Time [{clock.name}]")
    style.title(figure, profiles.title(run))
    return figure


def _norm(times: np.ndarray) -> Normalize:
    """From the first profile to the last, so that their colours differ also where all events come
    late in the run."""
    first, last = float(times.min()), float(times.max())
    return Normalize(first, last) if last > first else Normalize(0.0, last or 1.0)


def _times(run: Run) -> Tuple[np.ndarray, str]:
    """The end of every event, or equal times if there is none, and what to call them."""
    if not run.has("events.csv") or not len(run.complete_events):
        return np.linspace(*run.span, 30), "At 30 equal times; no event ended in the run"
    ends = run.complete_events["onset"] + run.complete_events["duration"]
    every = max(1, -(-ends.size // PROFILES))
    heading = "At the end of every event" if every == 1 else f"At the end of one event in {every}"
    return ends[::every], heading
