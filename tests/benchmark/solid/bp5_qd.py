"""SEAS BP5-QD on cells of 2 km: the first event, in the weakening core, against EQquasi on cells of
the same size, which is good to about 20 percent."""

import sys

import asperity_run
import numpy
from sequence import check

# Receiver: when it slips at 1 cm/s [s], its peak rate [m/s], its slip after 60 s [m].
CORE = {"strk+00dp10": (17.03, 1.052, 5.900), "strk+16dp10": (22.83, 1.145, 5.386)}
ARRIVED = 0.01  # m/s


def main():
    folder = asperity_run.run_to_end(
        "out", asperity_run.SOURCE / "xml" / "bp5_qd.xml",
        "--set", "Time Stepping/Final Time=200", timeout=7000)
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    fine = True
    for receiver, (arrival, peak, slip) in CORE.items():
        number = names.index(receiver)
        rate = history["on_fault/fields/slip_rate"][:, number]
        moved = numpy.linalg.norm(history["on_fault/fields/slip"][:, number], axis=1)
        found = history["time"][numpy.flatnonzero(rate > ARRIVED)[0]]
        at_end = numpy.interp(60, history["time"], moved)
        fine = check(f"{receiver}: arrival [s]", found, arrival, 0.2) and fine
        fine = check(f"{receiver}: peak slip rate [m/s]", rate.max(), peak, 0.2) and fine
        fine = check(f"{receiver}: slip after 60 s [m]", at_end, slip, 0.2) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
