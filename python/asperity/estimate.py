"""Estimates when a run ends, from the wall time of past cycles, as the program itself does.

Between earthquakes a run may be a thousand times faster than in them, so that the speed of the last
minutes does not tell the end. Once a whole cycle is known, from one event to the next, the rest is
assumed to cost the same as past cycles (packages/io/files/TimeLeft.hpp does the same); an
aftershock begins no cycle. Before that, the estimate uses the speed of the last minutes, and a text
with it should say so.
"""

from dataclasses import dataclass
from typing import Optional, Tuple

import numpy as np

from .log import RunLog
from .run import Run

CYCLES = 10        # the last ones, which the estimate looks at
RECENT = 120.0     # [s] of wall time, over which a speed is taken
AFTERSHOCK = 1e-3  # of the longest time between events


@dataclass(frozen=True)
class TimeLeft:
    """`seconds` of wall time; from past cycles, or at the speed of the last minutes."""

    seconds: float
    knows_cycles: bool


def time_left(run: Run, log: RunLog) -> Optional[TimeLeft]:
    """None where the log tells no speed or no final time."""
    time, wall = moments(run, log)
    if log.final_time is None or time.size < 2 or not wall[-1] > wall[0]:
        return None
    onsets = _onsets(run, log)
    onsets = onsets[(onsets > time[0]) & (onsets <= time[-1])]
    onsets = _without_aftershocks(onsets, time[0])[-(CYCLES + 1):]
    seconds = _of_cycles(time, wall, onsets, log.final_time) if onsets.size > 1 else 0.0
    if seconds > 0.0:
        return TimeLeft(seconds, True)
    speed = recent_speed(time, wall)
    if not speed > 0.0:
        return None
    return TimeLeft((log.final_time - time[-1]) / speed, onsets.size > 1)


def moments(run: Run, log: RunLog) -> Tuple[np.ndarray, np.ndarray]:
    """Simulated time and wall time [s] of each step, increasing, as far as they are known.

    The log has the wall time of some steps; between its lines the cost of a step is assumed to be
    in proportion to its TNNMG iterations, or to its coupled steps.
    """
    lines = [line for line in log.progress if line.wall is not None]
    if not lines:
        return np.empty(0), np.empty(0)
    steps, work, time = _work(run)
    marks = np.array([line.step for line in lines])
    walls = np.array([line.wall for line in lines])
    # the process began at wall time 0 with the step that its first line counts from
    known = steps <= marks[-1]
    at_marks = np.interp(marks, steps, work) if steps.size else np.empty(0)
    inside = marks <= (steps[-1] if steps.size else -1)
    if inside.sum() < 2:
        return np.array([line.time for line in lines]), walls
    first = known & (steps >= marks[0])
    wall = np.interp(work[first], at_marks[inside], walls[inside])
    chosen = steps[first] <= marks[inside][-1]
    after = ~inside
    return (np.concatenate((time[first][chosen], [lines[i].time for i in np.flatnonzero(after)])),
            np.concatenate((wall[chosen], walls[after])))


def recent_speed(time: np.ndarray, wall: np.ndarray, recent: float = RECENT) -> float:
    """Simulated seconds per second of wall time, over the last `recent` seconds of that."""
    if time.size < 2:
        return 0.0
    begin = max(wall[-1] - recent, wall[0])
    elapsed = wall[-1] - begin
    return float((time[-1] - np.interp(begin, wall, time)) / elapsed) if elapsed > 0.0 else 0.0


def _work(run: Run):
    """Numbers of the steps, what was solved up to each, their times; of steps.csv."""
    if not run.has("steps.csv") or not len(run.steps) or "step" not in run.steps:
        return np.empty(0), np.empty(0), np.empty(0)
    table = run.steps
    weight = next((table[name] for name in ("tnnmg_iterations", "coupled_steps",
                                            "fixed_point_iterations") if name in table), None)
    work = np.ones(len(table)) if weight is None else np.maximum(weight, 1.0)
    return table["step"], np.cumsum(work), table["time"]


def _onsets(run: Run, log: RunLog) -> np.ndarray:
    """Onsets [s] of the events in events.csv, and of those that so far only the log has."""
    known = run.events["onset"] if run.has("events.csv") else np.empty(0)
    later = [line.time for before, line in zip(log.progress, log.progress[1:])
             if line.num_events > max(before.num_events, known.size)]
    return np.sort(np.concatenate((known, later)))


def _without_aftershocks(onsets: np.ndarray, begin: float) -> np.ndarray:
    """Without events that follow another within AFTERSHOCK of the longest time without one."""
    quiet = np.diff(onsets, prepend=begin)
    longest_before = np.concatenate(([0.0], np.maximum.accumulate(quiet)[:-1]))
    return onsets[quiet > AFTERSHOCK * longest_before]


def _of_cycles(time, wall, onsets, final: float) -> float:
    """Wall time [s] of the rest of the current cycle, and of the cycles after it. Of the cycle in
    which the run ends only a part counts, by the course of the last cycle. The current cycle adds
    0 once it has cost more than past cycles."""
    at = np.interp(onsets, time, wall)
    length, cost = np.diff(onsets).mean(), np.diff(at).mean()

    def part(share: float) -> float:
        """The share of a cycle's wall time that the first `share` of its simulated time takes."""
        if share >= 1.0 or not at[-1] > at[-2]:
            return 1.0
        there = onsets[-2] + max(share, 0.0) * (onsets[-1] - onsets[-2])
        return (np.interp(there, time, wall) - at[-2]) / (at[-1] - at[-2])

    of_this = max(cost * part((final - onsets[-1]) / length) - (wall[-1] - at[-1]), 0.0)
    more = max(final - max(onsets[-1] + length, time[-1]), 0.0) / length
    return of_this + cost * (np.floor(more) + part(more - np.floor(more)))
