"""A step control resolves the waves in the layer of layer.xml, whatever the largest step is.

Onsets have to be within 0.2 % of the exact solution with the default tolerance. Where the control
leaves waves out, the second onset is late by more than 1 %.
"""

import sys

import asperity_run
import exact_layer
from layer import HERE, events
from sequence import agree

TOLERANCE = {"onset": 2e-3, "peak": 3e-2, "slip": 3e-2}
LEAST_WITHOUT_WAVES = 1e-2


def catalogue(name, *settings):
    folder = asperity_run.run_to_end(
        name, HERE / "layer.xml", "--overlay", HERE / "controlled.xml", "--remove",
        "Time Stepping/Smallest Step", "--remove", "Output/Fault History", *settings, timeout=200)
    return [(row["onset"], row["peak_slip_rate"], row["peak_slip"])
            for row in asperity_run.table(folder / "events.csv")]


def main():
    exact = events(*exact_layer.solve(5.3, 400))
    print("with waves, characteristics:")
    fine = agree(catalogue("waves"), exact, TOLERANCE)

    without = catalogue("none", "--set", "Time Stepping/Richardson/Weight of Waves=0")
    late = without[1][0] / exact[1][0] - 1
    print(f"without waves the second onset is late by {late:.2%}")
    return 0 if fine and late > LEAST_WITHOUT_WAVES else 1


if __name__ == "__main__":
    sys.exit(main())
