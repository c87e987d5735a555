"""The wedge between glass walls against the wedge in the plane with the same cross-section: when
events begin, how much they slip, and how little the fault's motion varies along the depth."""

import sys

import asperity_run
import numpy
from sequence import catalogue, check

# Size of the cells [m], layers along the depth; the last one is held to the limits.
MESHES = ((0.0056, 4), (0.004, 6))
# Ten times the plate rate. The first event peaks at 1.12 mm/s: what it slips above the threshold of
# the decks, 1.05 mm/s, is a quarter more where its peak is 3 % higher, and says little.
SAME = ("--set", "Time Stepping/Final Time=1100",
        "--set", "Output/Event Catalogue/Threshold=5e-4")
ONSET, RECURRENCE, SLIP = 0.005, 0.02, 0.03


def in_space(size, layers):
    return asperity_run.run_to_end(
        f"space_{size}", asperity_run.SOURCE / "xml" / "wedge_3d.xml", *SAME,
        "--set", "Mesh/Deep Wedge/Cells=Layers", "--set", f"Mesh/Deep Wedge/Cell Size={size}",
        "--set", f"Mesh/Deep Wedge/Layers={layers}", timeout=14000)


def in_the_plane(size):
    """With the scheme and the control of wedge_3d.xml."""
    return asperity_run.run_to_end(
        f"plane_{size}", asperity_run.SOURCE / "xml" / "wedge_2d.xml", *SAME,
        "--set", f"Mesh/Wedge/Cell Size={size}",
        "--set", "Time Stepping/Scheme=Generalised Alpha",
        "--set", "Time Stepping/Control=Richardson",
        "--set", "Time Stepping/Richardson/Tolerance=1e-4",
        "--set", "Time Stepping/Richardson/First Step=1e-3", timeout=3600)


def variation(folder):
    """Of the slip rate along the depth where it peaks in each event: the largest range over a line
    of equal x, and the root mean square of the deviation from the line's mean, both relative to the
    peak."""
    history = asperity_run.series(folder / "fault.h5")
    time, rate = history["time"], history["fields/slip_rate"]
    x = numpy.round(history["geometry/coordinates"][:, 0], 6)
    lines = [numpy.flatnonzero(x == place) for place in numpy.unique(x)]
    result = []
    for row in catalogue(folder):
        first, end = numpy.searchsorted(time, (row["onset"], row["end"]))
        at_peak = rate[first + numpy.argmax(rate[first:end].max(axis=1))]
        deviation = numpy.concatenate([at_peak[line] - at_peak[line].mean() for line in lines])
        result.append((max(numpy.ptp(at_peak[line]) for line in lines) / at_peak.max(),
                       numpy.sqrt(numpy.mean(deviation**2)) / at_peak.max()))
    return result


def compare(space, plane):
    """True if the events agree within the limits."""
    ours, theirs = catalogue(space), catalogue(plane)
    print(f"{len(ours)} events, in the plane {len(theirs)}")
    fine = len(ours) == len(theirs) >= 3
    onsets, expected = ([row["onset"] for row in rows] for rows in (ours, theirs))
    fine = check("first onset [s]", onsets[0], expected[0], ONSET) and fine
    for found, right in zip(numpy.diff(onsets), numpy.diff(expected)):
        fine = check("recurrence [s]", found, right, RECURRENCE) and fine
    for found, right in zip(ours, theirs):
        fine = check("peak slip [m]", found["peak_slip"], right["peak_slip"], SLIP) and fine
    return fine


def main():
    fine, before = True, None
    for size, layers in MESHES:
        print(f"cells of {size} m, {layers} layers")
        space = in_space(size, layers)
        fine = compare(space, in_the_plane(size))
        now = variation(space)
        for spread, mean_square in now:
            print(f"varies along the depth by {spread:.2%}, root mean square {mean_square:.3%}")
        shrinks = before is None or numpy.max(now, axis=0)[1] < numpy.max(before, axis=0)[1]
        before = now
    return 0 if fine and shrinks else 1


if __name__ == "__main__":
    sys.exit(main())
