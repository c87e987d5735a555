"""The order in time of each scheme on smooth.xml, with equal steps and with steps that change."""

import math
import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("smooth.xml")
LARGEST_STEP, FINAL_TIME = 0.01, 0.48
TIMES = 3 * LARGEST_STEP * numpy.arange(1, 17)  # where all runs can be compared
LEVELS = (1, 2, 3)                              # of the steps, halved each time
REFERENCE_LEVEL = 6
FIELDS = ("slip", "slip_rate", "alpha")
TOLERANCE = 0.1

V, DAMPING = 1e-4, 5e5  # m/s, Pa s/m
STEADY_FRICTION = 1e4 * 0.010 * math.asinh(
    V / 2e-6 * math.exp((0.6 + 0.015 * math.log(1e-6 / V)) / 0.010))


def equal(level):
    return [level]


def changing(level):
    """Two steps and two of half the size, over and over."""
    rounds = round(FINAL_TIME / (3 * LARGEST_STEP)) * 2**level
    return [level, level, level + 1, level + 1] * rounds


def solve(settings, levels):
    """{field: values on the fault at TIMES}, every field in units of its largest value."""
    settings = {**settings, "Time Stepping/Prescribed/Levels": "{%s}" % ",".join(map(str, levels))}
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(settings))
    history = asperity_run.series(folder / "fault.h5")
    steps = numpy.searchsorted(history["time"], TIMES - 1e-9)
    assert numpy.allclose(history["time"][steps], TIMES, rtol=1e-12)
    return {name: history[f"fields/{name}"][steps] for name in FIELDS}


def errors(solution, reference):
    """Root mean square over the fault and TIMES, relative to the largest value."""
    return [numpy.sqrt(numpy.mean((solution[name] - reference[name])**2))
            / numpy.abs(reference[name]).max() for name in FIELDS]


def check(name, settings, sequence, order, reference):
    """True if halving the steps divides each error by 2^order."""
    found = numpy.array([errors(solve(settings, sequence(level)), reference) for level in LEVELS])
    orders = numpy.log2(found[:-1] / found[1:])
    fine = numpy.abs(orders - order).max() <= TOLERANCE
    columns = (f"{field} {error:.1e} {' '.join(f'{x:.2f}' for x in of_field)}"
               for field, error, of_field in zip(FIELDS, found[-1], orders.T))
    print(f"{name:48s} {'; '.join(columns)}{'' if fine else ' NOT ' + str(order)}", flush=True)
    return fine


def generalised_alpha(spectral_radius):
    return {"Time Stepping/Scheme": "Generalised Alpha",
            "Time Stepping/Generalised Alpha/Spectral Radius": spectral_radius}


NEWMARK = {"Time Stepping/Scheme": "Newmark"}
BACKWARD_EULER = {"Time Stepping/Scheme": "Backward Euler"}
QUASI_DYNAMIC = {
    "Bulk/Dynamics": "Quasi-dynamic",
    "Bulk/Quasi-dynamic/Radiation Damping": DAMPING,
    "Friction/Shear Traction": STEADY_FRICTION + DAMPING * V,
}
DAMPED = {"Backward Euler": (BACKWARD_EULER, 1),
          "Generalised Alpha, 0": (generalised_alpha(0), 2),
          "Generalised Alpha, 0.5": (generalised_alpha(0.5), 2)}
UNDAMPED = {"Newmark": (NEWMARK, 2), "Generalised Alpha, 0.9": (generalised_alpha(0.9), 2)}


def check_all(dynamics, settings, schemes, of_reference):
    """The reference is of one scheme: that the others converge to it says that all solve the same
    equations."""
    reference = solve({**settings, **of_reference}, equal(REFERENCE_LEVEL))
    return [check(f"{dynamics}, {name}, {sequence.__name__}", {**settings, **scheme}, sequence,
                  order, reference)
            for name, (scheme, order) in schemes.items() for sequence in (equal, changing)]


def main():
    print("relative errors with the smallest steps, and orders")
    passed = check_all("inertial", {}, {**UNDAMPED, **DAMPED}, NEWMARK)
    passed += check_all("quasi-dynamic", QUASI_DYNAMIC, DAMPED, generalised_alpha(0.5))
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
