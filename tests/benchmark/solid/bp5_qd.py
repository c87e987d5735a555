"""SEAS BP5-QD on cells of 1 km: the first event against the converged answer of an independent
program of boundary elements (independent_cycles/square_core.py with cells of 500 m)."""

import sys

import asperity_run
import numpy
from sequence import check

# Receiver: when it slips at 1 cm/s [s], its peak rate [m/s], its slip after 60 s [m].
PLACES = {"strk+00dp+10": (26.28, 0.874, 6.96), "strk+16dp+10": (33.77, 0.985, 6.19),
          "strk+00dp+00": (40.17, 0.663, 4.58), "strk+16dp+00": (45.72, 0.511, 3.52)}
ARRIVED = 0.01  # m/s


def main():
    folder = asperity_run.run_to_end(
        "out", asperity_run.SOURCE / "xml" / "bp5_qd.xml",
        "--set", "Time Stepping/Final Time=128", "--set", "Mesh/Box/Cell Size Factor=0.5",
        timeout=7000)
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    fine = True
    for receiver, (arrival, peak, slip) in PLACES.items():
        number = names.index(receiver)
        rate = history["on_fault/fields/slip_rate"][:, number]
        moved = numpy.linalg.norm(history["on_fault/fields/slip"][:, number], axis=1)
        found = history["time"][numpy.flatnonzero(rate > ARRIVED)[0]]
        at_end = numpy.interp(60, history["time"], moved)
        fine = check(f"{receiver}: arrival [s]", found, arrival, 0.05) and fine
        fine = check(f"{receiver}: peak slip rate [m/s]", rate.max(), peak, 0.1) and fine
        fine = check(f"{receiver}: slip after 60 s [m]", at_end, slip, 0.02) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
