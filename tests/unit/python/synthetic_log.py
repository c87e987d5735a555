"""Writes run directories as a run leaves them that has cycles of a known cost in wall time."""

from pathlib import Path

CYCLE, CALM_STEPS, EVENT_STEPS, EVENT = 100.0, 60, 240, 0.5  # [s], of a cycle; [s] of an event
WALL_PER_STEP = 2.0  # [s]
HEADER = "Asperity 0.1.0 on Serial, 2 ranks.\nKokkos 3.4.1, Trilinos 13.2, Open MPI v4.1.4.\n"


def cycle_wall():
    return (CALM_STEPS + EVENT_STEPS) * WALL_PER_STEP


def step_times(cycles):
    """Of every accepted step: long ones, then an event in short ones."""
    times = []
    for cycle in range(cycles):
        begin, onset = cycle * CYCLE, (cycle + 1) * CYCLE - EVENT
        times += [begin + (onset - begin) * (k + 1) / CALM_STEPS for k in range(CALM_STEPS)]
        times += [onset + EVENT * (k + 1) / EVENT_STEPS for k in range(EVENT_STEPS)]
    return times


def write(folder: Path, steps: int, cycles: int, ending="", flushed=None, every=15,
          aftershocks=False):
    """A run of `cycles` cycles after its first `steps` steps, which ends with the text `ending`.
    Tables have `flushed` rows; the log has a line for each `every` steps. With `aftershocks` a
    second event begins soon after each."""
    folder.mkdir(parents=True, exist_ok=True)
    times = step_times(cycles)
    final = cycles * CYCLE
    rows = ["step,time [s],step_size [s],peak_slip_rate [m/s],fixed_point_iterations,"
            "coupled_steps,tnnmg_iterations,energy_rises,failed_steps,friction_work [J/m],"
            "energy_defect [J/m]"]
    lines, onsets = [HEADER.rstrip("\n")], []
    for number, time in enumerate(times[:steps], start=1):
        in_event = time % CYCLE > CYCLE - EVENT or time % CYCLE == 0
        step = (number - 1) % (CALM_STEPS + EVENT_STEPS)
        if step == CALM_STEPS or (aftershocks and step == CALM_STEPS + EVENT_STEPS // 8):
            onsets.append(time)
        rows.append(f"{number},{time},{time - (times[number - 2] if number > 1 else 0.0)},"
                    f"{0.1 if in_event else 1e-9},{9 if number == 77 else 2},1,"
                    f"{40 if number == 77 else 3},0,{1 if number == 77 else 0},{2.0 * time},"
                    f"{-1e-9 * time}")
        if number % every == 0 or number == len(times):
            plural = "" if len(onsets) == 1 else "s"
            lines.append(
                f"t = {time:.6g} s of {final:g} s ({int(100 * time / final)} %), step {number}, "
                f"dt 0.25 s, V 1.0e-09 m/s, 2 iterations, {len(onsets)} event{plural}, "
                f"wall {number * WALL_PER_STEP:.6g} s, about 3 min left")
    table = rows[:1 + (flushed if flushed is not None else steps)]
    (folder / "steps.csv").write_text("\n".join(table) + "\n")
    known = float(table[-1].split(",")[1]) if len(table) > 1 else 0.0
    events = ["number,onset [s],end [s],duration [s],peak_slip [m],complete"]
    events += [f"{number},{onset},{onset + EVENT},{EVENT},0.1,1"
               for number, onset in enumerate(onsets, start=1) if onset <= known]
    (folder / "events.csv").write_text("\n".join(events) + "\n")
    (folder / "run.log").write_text("\n".join(lines) + "\n" + ending)
    return times
