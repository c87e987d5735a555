"""The driver on strip.xml with driven.xml: half an antisymmetric fault whose far side moves at half
the plate rate ends up slipping at the plate rate, against the friction of that rate."""

import math
import pathlib
import sys

import asperity_run
from radiation import A, B, MU_STAR, V_STAR

HERE = pathlib.Path(__file__).parent
PLATE_RATE, SIGMA = 1e-2, 1e4
TOLERANCE = 1e-4


def main():
    folder = asperity_run.run_to_end("out", HERE / "strip.xml", "--overlay", HERE / "driven.xml",
                                     timeout=100)
    history = asperity_run.series(folder / "fault.h5")
    V = history["fields/slip_rate"].mean(axis=1)
    traction = history["fields/traction"].reshape(len(V), -1).mean(axis=1)
    state = MU_STAR + B * math.log(V_STAR / PLATE_RATE)
    steady = SIGMA * A * math.asinh(PLATE_RATE / (2 * V_STAR) * math.exp(state / A))
    fine = abs(V[0] / PLATE_RATE - 0.1) < 1e-9
    for name, value, expected in (("slip rate", V[-1], PLATE_RATE),
                                  ("traction", traction[-1], steady)):
        error = value / expected - 1
        fine = fine and abs(error) <= TOLERANCE
        print(f"{name} {value:.8g}, expected {expected:.8g}: off by {error:.1e} of {TOLERANCE}")
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
