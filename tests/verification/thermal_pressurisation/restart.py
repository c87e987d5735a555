"""A run whose fault heats its fluid goes on from its checkpoint as if it had not stopped: bit for
bit on the same ranks, and on others as far as their sums allow."""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("sliding.xml")
FEW_STEPS = {f"Time Stepping/{size} Step": 0.1 for size in ("Largest", "Smallest")}
HALF = "Time Stepping/Final Time=2.5"
TOLERANCE = 1e-9  # of the largest value, on other ranks
FIELDS = ("traction", "fluid_pressure", "temperature", "temperature_mode_59")


def values(folder):
    series = asperity_run.series(folder / "receivers.h5")
    return [series[f"on_fault/fields/{name}"] for name in FIELDS]


def main():
    settings = asperity_run.settings(FEW_STEPS)
    whole = values(asperity_run.run_to_end("whole", DECK, *settings))
    assert whole[0].min() < 0.7 * whole[0].max(), "nothing has weakened"
    failures = 0
    for before, after in ((1, 1), (2, 2), (1, 2), (2, 1)):
        first = whole if before == 1 else values(
            asperity_run.run_to_end("whole_on_two", DECK, *settings, ranks=2))
        folder = asperity_run.run_to_end(
            f"half_{before}", DECK, *settings, *asperity_run.settings(HALF), ranks=before)
        asperity_run.go_on(folder, DECK, *settings, ranks=after)
        bound = 0 if before == after else TOLERANCE
        error = max(numpy.abs(found - expected).max() / numpy.abs(expected).max()
                    for found, expected in zip(values(folder), first))
        fine = error <= bound
        print(f"{before} ranks, then {after}: {error:.1e}{'' if fine else ' NO'}", flush=True)
        failures += not fine
    return failures


if __name__ == "__main__":
    sys.exit(main())
