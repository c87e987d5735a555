"""The state of a run from its files, as one flat record."""

import time as clock
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any, Dict, List, Optional

import numpy as np

from asperity import estimate
from asperity.journal import Journal
from asperity.lock import owner_is_gone
from asperity.log import RunLog
from asperity.run import Run

FINISHED, STOPPED, FAILED = "finished", "stopped", "failed"
KILLED, SILENT, RUNNING = "killed", "silent", "running"
WORKS = ("boundary_work", "load_work", "friction_work", "viscous_work")
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
    wall: Optional[float]       # of all of them
    speed: Optional[float]      # simulated per wall time, of the last two minutes
    steps_per_minute: Optional[float]
    seconds_left: Optional[float]
    knows_cycles: bool
    relative_energy_defect: Optional[float]  # of the largest work in the balance
    failed_steps: Optional[int]
    energy_rises: Optional[int]
    worst_step: Optional[Dict[str, float]]
    message: Optional[str]      # why a failed run has ended
    exit_status: Optional[int]  # of the program, where it has ended by itself
    has_checkpoint: bool
    warnings: List[Dict[str, Any]]  # topic, text, step, time


def facts(directory: Path, silent_after: float) -> Facts:
    """InputError if `directory` has no log of a run, or what is there cannot be read."""
    log = RunLog.read(directory / "run.log")
    journal = Journal.read(directory / "run.jsonl")
    run = Run(directory)
    age = max(clock.time() - (directory / "run.log").stat().st_mtime, 0.0)
    state = _state(log, journal, directory, age, silent_after)
    moments = estimate.moments(run, log)
    left = estimate.time_left(run, log) if state != FINISHED else None
    since = age if state == RUNNING else 0.0  # the last line of the log
    return Facts(directory=str(directory), state=state, age=age, final_time=log.final_time,
                 processes=log.processes, wall=log.wall + since or None, **_place(run, log),
                 **_speed(log, *moments), **_steps(run),
                 message=journal.message or log.failure or None, exit_status=journal.exit_status,
                 has_checkpoint=run.has("checkpoint.h5"), warnings=_warnings(log, journal),
                 seconds_left=max(left.seconds - since, 0.0) if left else None,
                 knows_cycles=bool(left and left.knows_cycles))


def _state(log: RunLog, journal: Journal, directory: Path, age: float,
           silent_after: float) -> str:
    """From run.jsonl; from the log if the run has no run.jsonl, as of an earlier version."""
    if journal.how:
        return journal.how
    if log.failure:
        return FAILED
    if log.ending:
        return FINISHED if log.ending == "Finished" else STOPPED
    if owner_is_gone(directory):
        return KILLED
    return SILENT if age > silent_after else RUNNING


def _warnings(log: RunLog, journal: Journal) -> List[Dict[str, Any]]:
    if journal.walls:
        return [asdict(each) for each in journal.warnings]
    return [{"topic": None, "text": text, "step": None, "time": None}
            for text in dict.fromkeys(log.warnings)]


def _place(run: Run, log: RunLog) -> Dict[str, Any]:
    """From the log or from steps.csv, whichever is further."""
    last = log.progress[-1] if log.progress else None
    place = {"time": last and last.time, "step": last and last.step,
             "events": last and last.num_events, "peak_slip_rate": last and last.peak_slip_rate}
    if run.has("steps.csv") and len(run.steps) and (last is None
                                                    or run.steps["step"][-1] >= last.step):
        place.update(time=float(run.steps["time"][-1]), step=int(run.steps["step"][-1]),
                     peak_slip_rate=float(run.steps["peak_slip_rate"][-1]))
    if run.has("events.csv"):
        place["events"] = max(place["events"] or 0, len(run.events))
    return place


def _speed(log: RunLog, time: np.ndarray, wall: np.ndarray) -> Dict[str, Any]:
    lines = [line for line in log.progress if line.wall is not None]
    walls, steps = np.array([[line.wall, line.step] for line in lines]).reshape(-1, 2).T
    return {"speed": estimate.recent_speed(time, wall) or None,
            "steps_per_minute": 60.0 * estimate.recent_speed(steps, walls) or None}


def _steps(run: Run) -> Dict[str, Any]:
    """The energy balance, and the step with the most iterations, from steps.csv."""
    found: Dict[str, Any] = dict.fromkeys(
        ("relative_energy_defect", "failed_steps", "energy_rises", "worst_step"))
    if not run.has("steps.csv") or not len(run.steps):
        return found
    table = run.steps
    largest = max((abs(table[name][-1]) for name in WORKS if name in table), default=0.0)
    if "energy_defect" in table and largest > 0.0:
        found["relative_energy_defect"] = float(table["energy_defect"][-1] / largest)
    for name in ("failed_steps", "energy_rises"):
        if name in table:
            found[name] = int(table[name].sum())
    cost = next((name for name in WORST[1::-1] if name in table), None)
    if cost and "step" in table:
        row = int(np.argmax(table[cost]))
        found["worst_step"] = {"step": int(table["step"][row]),
                               **{name: float(table[name][row]) for name in WORST
                                  if name in table}}
    return found
