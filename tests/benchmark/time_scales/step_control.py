"""The thesis deck with the second step control: as accurate as asked for, at half the effort.

Events agree with those of a run at a tenth of the tolerance in recurrence, slip and width (medians)
within 0.5 %, their number within one, with at most 2.1 coupled steps for each accepted one. The
step doubling of the thesis needs about four.
"""

import sys

import asperity_run
import numpy
from sequence import catalogue, check

DECK = asperity_run.SOURCE / "xml" / "wedge_2d_thesis.xml"


def run(tolerance):
    folder = asperity_run.run_to_end(
        f"tolerance_{tolerance}", DECK, "--set", "Time Stepping/Control=Richardson", "--set",
        f"Time Stepping/Richardson/Tolerance={tolerance}", timeout=7000)
    events = catalogue(folder)
    steps = asperity_run.table(folder / "steps.csv")
    column = lambda name: numpy.array([row[name] for row in events])
    return {"recurrence": numpy.median(numpy.diff(column("onset"))),
            "peak slip": numpy.median(column("peak_slip")),
            "width": numpy.median(column("width")),
            "effort": sum(row["coupled_steps"] for row in steps) / len(steps),
            "events": len(events)}


def main():
    found, fine = run(1e-5), run(1e-6)
    print(found, fine)
    agree = [check(name, found[name], fine[name], 0.005)
             for name in ("recurrence", "peak slip", "width")]
    agree.append(abs(found["events"] - fine["events"]) <= 1)
    return 0 if all(agree) and found["effort"] <= 2.1 else 1


if __name__ == "__main__":
    sys.exit(main())
