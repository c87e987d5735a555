"""Stick-slip: where the energy goes, step by step (steps.csv)."""

import pathlib
import sys

import asperity_run

DECK = pathlib.Path(__file__).with_name("stick_slip.xml")
PUSH = 0.02  # m/s, what the deck prescribes at the backstop


def run(name, *settings, ranks=1):
    folder = asperity_run.run_to_end(name, DECK, *asperity_run.settings(*settings), ranks=ranks)
    rows = asperity_run.table(folder / "steps.csv")
    print(f"{name}: {len(rows)} steps, friction {rows[-1]['friction_work']:.6g} J/m, "
          f"defect {rows[-1]['energy_defect']:.3g} J/m")
    return rows


def mechanical(row):
    return row["kinetic_energy"] + row["elastic_energy"]


def works(row):
    return (row["load_work"] + row["boundary_work"] - row["friction_work"] - row["viscous_work"]
            - row["numerical_dissipation"])


def closes(rows, tolerance):
    """Every step closes to a part `tolerance` of all the work of friction; and there was some."""
    defects = [0] + [row["energy_defect"] for row in rows]
    worst = max(abs(after - before) for before, after in zip(defects, defects[1:]))
    friction = rows[-1]["friction_work"]
    print(f"  worst step: {worst / friction:.2g} of the friction work")
    # The columns say the same, to their eight digits.
    change = mechanical(rows[-1]) - mechanical(rows[0])
    balance = change - (works(rows[-1]) - works(rows[0]))
    scale = max(abs(rows[-1][name]) for name in ("load_work", "boundary_work", "elastic_energy"))
    slipped = max(row["peak_slip_rate"] for row in rows) > 3 * PUSH and friction > 0.02
    return slipped and worst <= tolerance * friction and abs(balance) <= 1e-6 * scale


def newmark():
    """Exact for equal and for unequal steps, whoever solves the linear problems."""
    equal = run("newmark")
    unequal = run("unequal", "Time Stepping/Control=Step Doubling",
                  "Time Stepping/Step Doubling/Tolerance=1e-3")
    parallel = run("parallel", "TNNMG/Linear Correction=Multigrid", "Time Stepping/Final Time=0.2",
                   ranks=2)
    one_rank = equal[len(parallel) - 1]["friction_work"]
    difference = abs(parallel[-1]["friction_work"] / one_rank - 1)
    print(f"  two ranks differ by {difference:.2g} in the friction work")
    return all([closes(equal, 1e-12), closes(unequal, 1e-12), closes(parallel, 1e-9),
                difference <= 1e-5])


def backward_euler():
    """Loses energy, in proportion to the step, and says so: the balance closes with what it lists.
    The works are trapezoidal sums, which alone lets the loss be of either sign; in the loading
    before the first event it is, by very little."""
    lost, closed = [], True
    for level in range(3):
        rows = run(f"backward_euler_{level}", "Time Stepping/Scheme=Backward Euler",
                   f"Time Stepping/Prescribed/Levels={{{level}}}")
        losses = [row["numerical_dissipation"] for row in rows]
        closed = closes(rows, 1e-12) and min(losses) > -2e-3 * losses[-1] and closed
        lost.append(losses[-1] / rows[-1]["friction_work"])
    ratios = [coarse / fine for coarse, fine in zip(lost, lost[1:])]
    print(f"  lost, of the friction work: {lost}, ratios {ratios}")
    return closed and lost[0] > 0.01 and 1.6 < ratios[0] < ratios[1] < 2.1


if __name__ == "__main__":
    sys.exit(0 if all([newmark(), backward_euler()]) else 1)
