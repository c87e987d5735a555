"""The driver on the layer of layer.xml against its exact solution: when it breaks, and how fast."""

import pathlib
import sys

import asperity_run
import exact_layer
import numpy
from sequence import agree

HERE = pathlib.Path(__file__).parent
THRESHOLD = 1e-3  # m/s

# onset in s, peak slip rate in m/s, slip in m while the rate is above the threshold
PUBLISHED = [(0.38744, 0.006326, 0.000344), (5.00036, 0.019786, 0.00105)]
PUBLISHED_TOLERANCE = {"onset": 5e-4, "peak": 2e-4, "slip": 2e-3}
TOLERANCE = {"onset": 5e-3, "peak": 3e-2, "slip": 3e-2}


def crossing(t, V, i):
    """When V meets the threshold between the samples i and i + 1."""
    return t[i] + (t[i + 1] - t[i]) * (THRESHOLD - V[i]) / (V[i + 1] - V[i])


def events(t, V):
    """(onset, peak, slip) of every time above the threshold."""
    above = numpy.concatenate(([0], V >= THRESHOLD, [0])).astype(int)
    change = numpy.diff(above)
    starts, ends = numpy.flatnonzero(change > 0), numpy.flatnonzero(change < 0)
    found = []
    for first, last in zip(starts, ends):
        onset, end = crossing(t, V, first - 1), crossing(t, V, last - 1)
        times = numpy.concatenate(([onset], t[first:last], [end]))
        rates = numpy.concatenate(([THRESHOLD], V[first:last], [THRESHOLD]))
        slip = numpy.sum(numpy.diff(times) * (rates[1:] + rates[:-1]) / 2)
        found.append((onset, V[first:last].max(), slip))
    return found


def main(overlays):
    exact = events(*exact_layer.solve(5.3, 400))
    print("characteristics, published:")
    fine = agree(exact, PUBLISHED, PUBLISHED_TOLERANCE)

    options = [word for overlay in overlays for word in ("--overlay", HERE / overlay)]
    folder = asperity_run.run_to_end("out", HERE / "layer.xml", *options, timeout=100)
    history = asperity_run.series(folder / "fault.h5")
    V = history["fields/slip_rate"]
    # The two sides of a column of triangles have different masses, and what that does is small.
    spread = numpy.abs(V[:, 0] - V[:, 1]).max() / V.max()
    print(f"the two ends of the fault differ by {spread:.2%} of the peak")
    ours = events(history["time"], V.mean(axis=1))
    print("asperity, characteristics:")
    fine = agree(ours, exact, TOLERANCE) and fine and spread < 5e-3

    catalogue = [(row["onset"], row["peak_slip_rate"], row["peak_slip"])
                 for row in asperity_run.table(folder / "events.csv")]
    print("its catalogue of events, characteristics:")
    fine = agree(catalogue, exact, TOLERANCE) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
