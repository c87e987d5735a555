"""Displacement of the free surface in the years before an event, in the event, and in the plane
after it where the run has no other; of a run without events over the whole time shown.

Where a fault cuts the surface there is one node on each side of it, and the lines break. Beside an
antisymmetric fault the other half is drawn as well. Under back slip it is the displacement of the
bodies, without the steady motion of the plates.
"""

from typing import List, Tuple

import numpy as np
from matplotlib.axes import Axes

from asperity.errors import NothingToShow
from asperity.run import Run

from . import along, deformation_maps, mirror, plane, style, units
from .along import Axis
from .deformation_maps import FIELD, SHOWN
from .windows import View, Window

SETTLING = 5.0  # durations of an event in which its waves leave


def draw(run: Run, view: View):
    """The figure; NothingToShow if the time shown has none of the events of the run, in a history
    with a single row, or if nothing moves."""
    run.surface.require_two_times()
    if not view.number and run.has("events.csv") and len(run.complete_events):
        raise NothingToShow("no event ended in the time shown")
    spans = _spans(run, view) if view.number else [view.cycles]
    lengths = [units.text(last - first, "s") for first, last in spans]
    titles = [f"In the {lengths[0]} before event {view.number}",
              f"In the {lengths[1]} from the onset of event {view.number}"
              ] if view.number else [f"In {lengths[0]}"]
    if plane.is_surface(run.surface):
        return deformation_maps.draw(run, spans, titles)
    directions = _directions(run)
    if view.number and len(run.complete_events["onset"]) == 1:
        spans.append((spans[1][1], run.surface.time[-1]))
        titles.append(f"In the {units.text(spans[2][1] - spans[2][0], 's')} after it")
    positions, changes = _whole(run, spans, directions)
    changes, titles = deformation_maps.moving(changes, titles)
    where, unit = along.axis(run, run.surface, "surface"), units.length(np.array(changes))
    size = [6.5, 11.0, 13.0][len(titles) - 1], 4.2
    figure, axes = style.panels(1, len(titles), size, sharex=True)
    for panel, lines in zip(axes[0], changes):
        for (name, _, colour), line in zip(directions, lines):
            _line(panel, where, positions, unit(line), colour, name)
        panel.axhline(0.0, color=style.GREY, linewidth=0.6, zorder=0)
        panel.set(xlabel=where.label, ylabel=f"Displacement [{unit.name}]")
        panel.grid(True)
    axes[0, 0].set_xlim(_limits(where, positions, np.array(changes)))
    if len(directions) > 1:
        axes[0, 0].legend()
    for panel, text in zip(axes[0], titles):
        panel.set_title(text)
    style.title(figure, deformation_maps.heading(run, run.upwards(2)))
    return figure


def _spans(run: Run, view: View) -> List[Window]:
    """From the event before, or the run's start, to the onset; and the event with its waves."""
    events = run.complete_events
    onsets, durations = events["onset"], events["duration"]
    later = np.append(onsets[1:], run.surface.time[-1])
    settled = np.minimum(onsets + (1.0 + SETTLING) * durations, later)
    before = settled[onsets < view.onset]
    return [(before[-1] if before.size else run.span[0], view.onset),
            (view.onset, settled[onsets == view.onset][0])]


def _directions(run: Run) -> List[Tuple[str, np.ndarray, str]]:
    """Name, direction in the plane, and colour; an antiplane displacement has one."""
    if run.surface.components(FIELD) < 2:
        return [("along strike", None, style.BLUE)]
    up = run.upwards(2)
    return [("horizontal", np.array([up[1], -up[0]]), style.BLUE), ("up", up, style.ORANGE)]


def _whole(run: Run, spans: List[Window], directions) -> Tuple[np.ndarray, List[List[np.ndarray]]]:
    """Positions [m] along the surface, and for each span and direction by how much the displacement
    changed [m] there; beyond the surface, those of the other half if the run has one half."""
    surface, positions = run.surface, run.surface.position
    changes = [surface.at(FIELD, last) - surface.at(FIELD, first) for first, last in spans]
    image = mirror.of(run, run.upwards(2))
    if image is not None:
        gaps = image.distance(surface.coordinates[[0, -1]])  # between the surface and the fault
        is_first = gaps[0] <= gaps[1]
        fault = positions[0] - gaps[0] if is_first else positions[-1] + gaps[1]
        positions = _joined(2.0 * fault - positions[::-1], positions, is_first)
        changes = [_joined(image.displacement(one)[::-1], one, is_first) for one in changes]
    return positions, [[_along(one, direction) for _, direction, _ in directions]
                       for one in changes]


def _joined(image: np.ndarray, own: np.ndarray, is_first: bool) -> np.ndarray:
    return np.concatenate((image, own) if is_first else (own, image))


def _along(values: np.ndarray, direction) -> np.ndarray:
    """(nodes) the component along `direction`, or the only one."""
    return values.reshape(len(values), -1)[:, 0] if direction is None else values @ direction


def _line(axes: Axes, where: Axis, positions: np.ndarray, values: np.ndarray, colour: str,
          name: str) -> None:
    """A line that breaks where two nodes are at one place."""
    cuts = np.flatnonzero(np.diff(positions) == 0.0) + 1
    axes.plot(np.insert(where(positions), cuts, np.nan), np.insert(values, cuts, np.nan),
              color=colour, label=name)


def _limits(where: Axis, positions: np.ndarray, changes: np.ndarray):
    """Coordinates between which something moves."""
    size = np.abs(changes).max(axis=(0, 1))
    moving = where(positions[size >= SHOWN * size.max()])
    return moving.min(), moving.max()
