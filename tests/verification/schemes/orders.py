"""The order in time of each scheme on smooth.xml, with equal steps and with steps that change."""

import math
import pathlib
import sys

import asperity_run
import numpy
import time_orders

DECK = pathlib.Path(__file__).with_name("smooth.xml")
LEVELS = (1, 2, 3)  # of the steps, halved each time
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
    rounds = len(time_orders.TIMES) * 2**level
    return [level, level, level + 1, level + 1] * rounds


def solve(settings, levels):
    settings = {**settings, "Time Stepping/Prescribed/Levels": "{%s}" % ",".join(map(str, levels))}
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(settings))
    return time_orders.at_times(folder, FIELDS)


def check(name, settings, sequence, order, reference):
    """Of errors relative to the largest value."""
    solutions = [solve(settings, sequence(level)) for level in LEVELS]
    return time_orders.check(name, solutions, reference, lambda values: numpy.abs(values).max(),
                             order - TOLERANCE, order + TOLERANCE)


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
