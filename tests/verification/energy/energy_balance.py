"""Stick-slip: where the energy goes, step by step (steps.csv)."""

import pathlib
import sys

import asperity_run

DECK = pathlib.Path(__file__).with_name("stick_slip.xml")


def run(name, *settings, ranks=1):
    options = [word for setting in settings for word in ("--set", setting)]
    folder = asperity_run.run_to_end(name, DECK, *options, ranks=ranks)
    rows = asperity_run.table(folder / "steps.csv")
    events = asperity_run.table(folder / "events.csv")
    print(f"{name}: {len(rows)} steps, {len(events)} events, friction "
          f"{rows[-1]['friction_work']:.6g} J/m, defect {rows[-1]['energy_defect']:.3g} J/m")
    return rows, events


def mechanical(row):
    return row["kinetic_energy"] + row["elastic_energy"]


def works(row):
    return row["load_work"] + row["boundary_work"] - row["friction_work"] - row["viscous_work"]


def closes(rows, events, tolerance):
    """Every step closes to a part `tolerance` of all the work of friction; and it had work to do."""
    defects = [0] + [row["energy_defect"] for row in rows]
    worst = max(abs(after - before) for before, after in zip(defects, defects[1:]))
    friction = rows[-1]["friction_work"]
    print(f"  worst step: {worst / friction:.2g} of the friction work")
    # The columns say the same, to their eight digits.
    change = mechanical(rows[-1]) - mechanical(rows[0])
    balance = change - (works(rows[-1]) - works(rows[0]))
    scale = max(abs(rows[-1][name]) for name in ("load_work", "boundary_work", "elastic_energy"))
    lively = len(events) >= 2 and friction > 0.1 and rows[-1]["viscous_work"] > 0.01
    return lively and worst <= tolerance * friction and abs(balance) <= 1e-6 * scale


def newmark():
    """Exact for equal and for unequal steps, whoever solves the linear problems."""
    rows, events = run("newmark")
    equal = closes(rows, events, 1e-12)
    unequal = closes(*run("unequal", "Time Stepping/Control=Step Doubling",
                          "Time Stepping/Step Doubling/Tolerance=1e-3"), 1e-12)
    parallel, parallel_events = run("parallel", "TNNMG/Linear Correction=MueLu", ranks=2)
    same = abs(parallel[-1]["friction_work"] / rows[-1]["friction_work"] - 1)
    print(f"  two ranks differ by {same:.2g} in the friction work")
    return equal and unequal and closes(parallel, parallel_events, 1e-9) and same <= 1e-5


def backward_euler():
    """Loses energy at all times, in proportion to the step."""
    lost = []
    for level in range(3):
        rows, _ = run(f"backward_euler_{level}", "Time Stepping/Scheme=Backward Euler",
                      f"Time Stepping/Prescribed/Levels={{{level}}}")
        if max(row["energy_defect"] for row in rows) > 0:
            print("  gains energy")
            return False
        lost.append(-rows[-1]["energy_defect"] / rows[-1]["friction_work"])
    ratios = [coarse / fine for coarse, fine in zip(lost, lost[1:])]
    print("  lost, of the friction work:", lost, "ratios:", ratios)
    return lost[0] > 0.01 and 1.6 < ratios[0] < ratios[1] < 2.1


if __name__ == "__main__":
    sys.exit(0 if all([newmark(), backward_euler()]) else 1)
