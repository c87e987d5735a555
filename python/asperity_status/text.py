"""The facts of a run in sentences."""

from typing import List, Optional

from asperity import durations

from .facts import Facts

def describe(now: Facts) -> str:
    """Several lines; what the files do not tell is left out."""
    lines = [f"{now.directory}: {_state(now)}.", _place(now), _speed(now), _left(now),
             _balance(now), _worst(now),
             *now.damaged, *(f"WARNING: {each['text']}" for each in now.warnings)]
    return "\n".join(line for line in lines if line)


def line(now: Facts) -> str:
    """The same in one line, for --follow."""
    return ", ".join(part.rstrip(".") for part in (_place(now), _speed(now), _left(now)) if part)


def _state(now: Facts) -> str:
    on = (f"`--restart {now.directory}/checkpoint.h5` continues it" if now.has_checkpoint
          else "there is no checkpoint of it")
    if now.state == "failed":
        why = (now.message or "the log says why").rstrip(".")
        if now.kind == "useless_run":
            return f"failed: {why}"
        if not now.has_checkpoint:
            return f"failed: {why}; {on}"
        from_here = f"`--restart-from {now.directory}/checkpoint.h5`"
        if now.kind == "input":  # what --restart does not let change
            return f"failed: {why}; correct the deck and begin again, from here with {from_here}"
        again = "once the disk has space" if now.exit_status == 5 else (
            "but as it is, it fails there again: change what the message names; `TNNMG`, "
            "`Coupling` and in `Time Stepping` the tolerance and the smallest step may change; "
            f"for other changes {from_here}")
        return f"failed: {why}; {on}, {again}"
    if now.state == "killed":
        return f"killed: its process is gone; {on}"
    if now.state == "silent":
        return (f"silent for {durations.text(now.age)}: killed, or hanging; if no process of it "
                f"is left, {on}")
    return f"stopped before its end; {on}" if now.state == "stopped" else now.state


def _place(now: Facts) -> str:
    if now.time is None:
        return "There is no step yet."
    of_final = f" of {simulated(now.final_time)} ({100 * now.time / now.final_time:.1f} %)" \
        if now.final_time else ""
    if now.state == "finished" and of_final and now.time < now.final_time * (1.0 - 1e-9):
        of_final = (f", before the final time {simulated(now.final_time)}: it has as many events "
                    "as 'Event Catalogue / Most Events' allows")
    events = "" if now.events is None else f", {now.events} event{'' if now.events == 1 else 's'}"
    return (f"t = {simulated(now.time)}{of_final}, step {now.step}{events}, "
            f"peak slip rate {now.peak_slip_rate:.1e} m/s.")


def _speed(now: Facts) -> str:
    if now.speed is None:
        return ""
    parts = [f"{simulated(60.0 * now.speed)} of simulated time"]
    if now.steps_per_minute:
        parts.append(f"{now.steps_per_minute:.3g} steps")
    restarts = f" in {now.processes} processes" if now.processes > 1 else ""
    return (f"Last minutes: {' and '.join(parts)} per minute; "
            f"{durations.text(now.wall)} of wall time so far{restarts}.")


def _left(now: Facts) -> str:
    if now.seconds_left is None or now.state == "failed":
        return ""
    left = durations.text(now.seconds_left) + (" left" if now.state == "running"
                                               else " more once it is continued")
    if now.knows_cycles:
        return f"About {left}, by the cost of past cycles."
    return f"{left} at this speed; no whole cycle is known yet, and events cost most."


def _balance(now: Facts) -> str:
    if now.relative_energy_defect is None:
        return ""
    return f"Energy: the balance misses {now.relative_energy_defect:.2g} of the largest work in it."


def _worst(now: Facts) -> str:
    parts: List[Optional[str]] = []
    worst = now.worst_step
    if worst:
        counts = [f"{worst[name]:.0f} {words}" for name, words in
                  (("fixed_point_iterations", "fixed point iterations"),
                   ("tnnmg_iterations", "TNNMG iterations")) if name in worst]
        parts.append(f"Most iterations: step {worst['step']} at t = {simulated(worst['time'])}, "
                     f"{', '.join(counts)}.")
    if now.failed_steps:
        parts.append(f"Failed attempts at a step, repeated with a smaller one: "
                     f"{now.failed_steps}.")
    return " ".join(part for part in parts if part)


def simulated(seconds: float) -> str:
    """'612.4 s', '3.2 h', '196.4 yr'."""
    for name, size in (("yr", durations.YEAR), ("d", durations.DAY), ("h", durations.HOUR)):
        if abs(seconds) >= 3.0 * size:
            return f"{seconds / size:.5g} {name}"
    return f"{seconds:.5g} s"
