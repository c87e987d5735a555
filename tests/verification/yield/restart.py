"""A run with rock that yields or creeps goes on from its checkpoint as if it had not stopped: bit
for bit on one rank, and on other ranks as far as their sums allow."""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("plastic_wave.xml")
CELLS = {"Mesh/Rectangle/Cells Y": 24, "Names/step": 0.02, "Coupling/Tolerance": 1e-12,
         "TNNMG/Relative Tolerance": 1e-14}
# which flows by G A t^3 = 3e5 Pa/s where t is the strength of the other rock
CREEP = ["--remove", "Bulk/Shear Strength", "--remove", "Bulk/Hardening", *asperity_run.settings(
    {"Bulk/Law": "Power Law", "Bulk/Prefactor": 1e-17, "Bulk/Stress Exponent": 3})]
TOLERANCE = 1e-9  # of the largest value, on other ranks; with looser solvers it is 3e-8


def values(folder):
    history = asperity_run.series(folder / "receivers.h5")
    return [history[f"off_fault/fields/{name}"] for name in ("velocity", "inelastic_shear")]


def goes_on(law, pairs_of_ranks):
    """How often a run does not."""
    arguments = [DECK, *law, *asperity_run.settings(CELLS)]
    whole = values(asperity_run.run_to_end("whole", *arguments))
    assert whole[1].max() > 1e-5, "nothing has yielded"
    failures = 0
    for before, after in pairs_of_ranks:
        bound = 0 if before == after else TOLERANCE
        folder = asperity_run.run_to_end(
            f"half_{before}", *arguments, *asperity_run.settings("Time Stepping/Final Time=0.4"),
            ranks=before)
        asperity_run.go_on(folder, *arguments, ranks=after)
        error = max(numpy.abs(found - expected).max() / numpy.abs(expected).max()
                    for found, expected in zip(values(folder), whole))
        fine = error <= bound
        print(f"{before} ranks, then {after}: {error:.1e}{'' if fine else ' NO'}", flush=True)
        failures += not fine
    return failures


def main():
    failures = goes_on(CREEP, [(1, 1)]) + goes_on([], [(1, 1), (1, 2), (3, 1), (2, 3)])
    other = asperity_run.run(DECK, *asperity_run.settings(CELLS), "--restart-from", "half_1",
                             "--output", "other")
    if other.returncode != 2 or "goes to no other run" not in other.stderr:
        print(f"--restart-from: {other.returncode} {other.stderr} NO")
        failures += 1
    return failures


if __name__ == "__main__":
    sys.exit(main())
