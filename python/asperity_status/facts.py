"""The state of a run from its files, as one flat record."""

import time as clock
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional

import numpy as np

from asperity.errors import InputError
from asperity.journal import Journal, Progress
from asperity.lock import owner_is_gone
from asperity.run import Run
from asperity.tables import Table

FINISHED, KILLED, SILENT, RUNNING = "finished", "killed", "silent", "running"
RECENT = 120.0  # [s] of wall time, over which a speed is taken
WORKS = ("boundary_work", "load_work", "friction_work", "viscous_work", "inelastic_work")
PLACE = ("step", "time", "peak_slip_rate")
WORST = ("fixed_point_iterations", "tnnmg_iterations", "step_size", "time")


@dataclass(frozen=True)
class Facts:
    """SI units; None is what the files do not tell."""

    directory: str
    state: str
    age: float                  # [s] since the log was last written
    time: Optional[float]
    final_time: Optional[float]
    step: Optional[int]
    events: Optional[int]
    peak_slip_rate: Optional[float]
    processes: int              # one, and one more for every restart
    wall: Optional[float]       # of all of them, without what a restart computed again
    speed: Optional[float]      # simulated per wall time, of the last two minutes
    steps_per_minute: Optional[float]
    seconds_left: Optional[float]
    knows_cycles: bool
    relative_energy_defect: Optional[float]  # of the largest work in the balance
    failed_steps: Optional[int]
    energy_increases: Optional[int]
    worst_step: Optional[Dict[str, float]]
    message: Optional[str]      # why a failed run has ended
    kind: Optional[str]         # of its failure, as in run.jsonl
    exit_status: Optional[int]  # of the program, where it has ended by itself
    has_checkpoint: bool
    warnings: List[Dict[str, Any]]  # topic, text, step, time
    damaged: List[str]          # what is wrong with files that add to the journal


def facts(directory: Path, silent_after: float) -> Facts:
    """InputError if `directory` has no log of a run. The journal decides, tables add: one that is
    damaged is told in `damaged`."""
    journal, run = Journal.read(directory), Run(directory).readable("steps.csv", "events.csv")
    damaged = list(run.damage.values())
    steps = _table(run, damaged)
    age = max(clock.time() - (directory / "run.log").stat().st_mtime, 0.0)
    state = journal.how or _without_end(directory, age, silent_after)
    since = age if state == RUNNING else 0.0  # the last line of the log
    return Facts(directory=str(directory), state=state, age=age,
                 final_time=run.parameters.number("Time Stepping/Final Time"),
                 processes=journal.log.processes,
                 wall=None if journal.wall_time is None else journal.wall_time + since,
                 **_place(run, journal, steps), **_speed(journal.progress), **_steps(steps),
                 **_left(journal.progress if state != FINISHED else [], since),
                 message=journal.message or None, kind=journal.kind or None,
                 exit_status=journal.exit_status,
                 has_checkpoint=(directory / "checkpoint.h5").exists(),
                 warnings=[asdict(each) for each in journal.warnings], damaged=damaged)


def _without_end(directory: Path, age: float, silent_after: float) -> str:
    """The state of a run whose files tell no end."""
    if owner_is_gone(directory):
        return KILLED
    return SILENT if age > silent_after else RUNNING


def _place(run: Run, journal: Journal, steps: Optional[Table]) -> Dict[str, Any]:
    """From run.jsonl or from steps.csv, whichever is further."""
    place: Dict[str, Any] = dict.fromkeys(("time", "step", "events", "peak_slip_rate"))
    if journal.progress:
        last = asdict(journal.progress[-1])
        place = {name: last[name] for name in place}
    if steps and steps["step"][-1] >= (place["step"] or 0):
        place.update(time=float(steps["time"][-1]), step=int(steps["step"][-1]),
                     peak_slip_rate=float(steps["peak_slip_rate"][-1]))
    if run.has("events.csv"):
        place["events"] = max(place["events"] or 0, len(run.events))
    return place


def _table(run: Run, damaged: List[str]) -> Optional[Table]:
    """steps.csv, if it has a row and tells where the run is."""
    if not run.has("steps.csv") or not len(run.steps):
        return None
    try:
        for name in PLACE:
            run.steps[name]
    except InputError as error:
        damaged.append(str(error))
        return None
    return run.steps


def _speed(progress: List[Progress]) -> Dict[str, Any]:
    """Simulated time and steps for wall time, in the last two minutes of that."""
    wall = np.array([each.wall_time for each in progress])
    begin = max(wall[-1] - RECENT, wall[0]) if wall.size else 0.0
    if not wall.size or not wall[-1] > begin:
        return {"speed": None, "steps_per_minute": None}

    def rate(values: List[float]) -> float:
        return float(values[-1] - np.interp(begin, wall, values)) / (wall[-1] - begin)

    return {"speed": rate([each.time for each in progress]),
            "steps_per_minute": 60.0 * rate([each.step for each in progress])}


def _left(progress: List[Progress], since: float) -> Dict[str, Any]:
    """What the program has estimated, less the time that has passed since then."""
    if not progress or progress[-1].seconds_left is None:
        return {"seconds_left": None, "knows_cycles": False}
    return {"seconds_left": max(progress[-1].seconds_left - since, 0.0),
            "knows_cycles": progress[-1].knows_cycles}


def _steps(table: Optional[Table]) -> Dict[str, Any]:
    """The energy balance, and the step with the most iterations, from steps.csv."""
    found: Dict[str, Any] = dict.fromkeys(
        ("relative_energy_defect", "failed_steps", "energy_increases", "worst_step"))
    if not table:
        return found
    largest = max((abs(table[name][-1]) for name in WORKS if name in table), default=0.0)
    if "energy_defect" in table and largest > 0.0:
        found["relative_energy_defect"] = float(table["energy_defect"][-1] / largest)
    for name in ("failed_steps", "energy_increases"):
        if name in table:
            found[name] = int(table[name].sum())
    cost = next((name for name in WORST[1::-1] if name in table), None)
    if cost and "step" in table:
        row = int(np.argmax(table[cost]))
        found["worst_step"] = {"step": int(table["step"][row]),
                               **{name: float(table[name][row]) for name in WORST
                                  if name in table}}
    return found
