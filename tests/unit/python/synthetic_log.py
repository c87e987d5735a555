"""Writes run directories as a run leaves them that has cycles of a known cost in wall time."""

import json
from pathlib import Path

CYCLE, CALM_STEPS, EVENT_STEPS, EVENT = 100.0, 60, 240, 0.5  # [s], of a cycle; [s] of an event
WALL_PER_STEP = 2.0  # [s]
HEADER = "Asperity 0.1.0 on Serial, 2 ranks.\nKokkos 3.4.1, Trilinos 13.2, Open MPI v4.1.4.\n"
DECK = """<ParameterList name="Asperity"><ParameterList name="Time Stepping">
<Parameter name="Final Time" type="double" value="{}"/></ParameterList></ParameterList>
"""


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


def write(folder: Path, steps: int, cycles: int, ending="", flushed=None, every=15):
    """A run of `cycles` cycles after its first `steps` steps, whose log ends with the text
    `ending`. Tables have `flushed` rows; run.jsonl has a line for each `every` steps."""
    folder.mkdir(parents=True, exist_ok=True)
    times = step_times(cycles)
    rows = ["step,time [s],step_size [s],peak_slip_rate [m/s],fixed_point_iterations,"
            "coupled_steps,tnnmg_iterations,energy_increases,failed_steps,friction_work [J/m],"
            "energy_defect [J/m]"]
    lines, onsets = [{"event": "begin", "step": 0, "time": 0}], []
    for number, time in enumerate(times[:steps], start=1):
        in_event = time % CYCLE > CYCLE - EVENT or time % CYCLE == 0
        if (number - 1) % (CALM_STEPS + EVENT_STEPS) == CALM_STEPS:
            onsets.append(time)
        rows.append(f"{number},{time},{time - (times[number - 2] if number > 1 else 0.0)},"
                    f"{0.1 if in_event else 1e-9},{9 if number == 77 else 2},1,"
                    f"{40 if number == 77 else 3},0,{1 if number == 77 else 0},{2.0 * time},"
                    f"{-1e-9 * time}")
        if number % every == 0 or number == len(times):
            lines.append({"event": "progress", "step": number, "time": time,
                          "wall_time": number * WALL_PER_STEP, "peak_slip_rate": 1e-9,
                          "events": len(onsets), "knows_cycles": len(onsets) > 1,
                          "seconds_left": (len(times) - number) * WALL_PER_STEP})
    table = rows[:1 + (flushed if flushed is not None else steps)]
    (folder / "steps.csv").write_text("\n".join(table) + "\n")
    known = float(table[-1].split(",")[1]) if len(table) > 1 else 0.0
    events = ["number,onset [s],end [s],duration [s],peak_slip [m],complete"]
    events += [f"{number},{onset},{onset + EVENT},{EVENT},0.1,1"
               for number, onset in enumerate(onsets, start=1) if onset <= known]
    (folder / "events.csv").write_text("\n".join(events) + "\n")
    (folder / "run.jsonl").write_text("".join(json.dumps(line) + "\n" for line in lines))
    (folder / "run.log").write_text(HEADER + ending)
    (folder / "parameters.xml").write_text(DECK.format(cycles * CYCLE))
    return times
