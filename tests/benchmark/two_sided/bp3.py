"""SEAS BP3-QD in thrust, bp3.py MESH_TOOL DIP: what happens at 7.5 km down dip, where an event
begins when the slip rate exceeds 1 mm/s, against the answers of other codes (element size 25 m)."""

import subprocess
import sys

import asperity_run
import numpy
from sequence import DAY, YEAR, check

THRESHOLD = 1e-3  # m/s
END = {60: 3.1e10, 30: 1.8e10}  # s, ten and six events
CELL = {60: 50, 30: 100}  # m


def at_threshold(rate, values, after):
    """The value when the rate passes the threshold, which it has at the index `after`."""
    rates = numpy.log(rate[after - 1:after + 1])
    return numpy.interp(numpy.log(THRESHOLD), rates, values[after - 1:after + 1])


def events(folder):
    """Of each event at 7.5 km: onset [yr], slip [m], normal stress, shear traction when it begins
    and when it ends [MPa]."""
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    here = names.index("dp075")
    rate, slip, traction, pressure = (
        abs(history[f"on_fault/fields/{field}"][:, here].reshape(len(history["time"])))
        for field in ("slip_rate", "slip", "traction", "normal_stress"))
    fast = rate > THRESHOLD
    starts = numpy.flatnonzero(fast[1:] & ~fast[:-1]) + 1
    found = []
    for start in starts:
        time, before = (at_threshold(rate, values, start)
                        for values in (history["time"], traction))
        if found and time < found[-1]["onset"] * YEAR + DAY:
            continue
        end = start + numpy.argmin(fast[start:])
        late = numpy.searchsorted(history["time"][:-1], time + DAY)
        found.append({"onset": time / YEAR, "slip": slip[late] - slip[start],
                      "sigma": pressure[start] / 1e6, "before": before / 1e6,
                      "after": traction[end] / 1e6})
        print({name: round(float(value), 4) for name, value in found[-1].items()})
    return found


def of_60_degrees(found):
    onsets = numpy.array([event["onset"] for event in found])
    fine = check("onset 1 [yr]", onsets[0], 177.1, 0.02)
    intervals = numpy.diff(onsets)
    for number, (interval, expected) in enumerate(zip(intervals, (100.2, 57.0, 87.0, 92.4, 97.4))):
        fine = check(f"interval {number + 1} [yr]", interval, expected, 0.05) and fine
    fine = check("mean of four [yr]", intervals[5:9].mean(), 84.7, 0.03) and fine
    # 44.0 MPa is that of the first event: the check of the later ones was dropped when runs were
    # known to have 43.1 to 43.6 MPa there, as the code of the published answers has.
    fine = check("shear traction before [MPa]", found[0]["before"], 44.0, 0.01) and fine
    for event in found[:5]:
        fine = check("normal stress [MPa]", event["sigma"], 50.5, 0.01) and fine
        fine = check("shear traction after [MPa]", event["after"], 27.8, 0.01) and fine
    return fine and len(intervals) >= 9


def of_30_degrees(found):
    onsets = numpy.array([event["onset"] for event in found])
    fine = check("onset 1 [yr]", onsets[0], 176.2, 0.02)
    for number, (interval, expected) in enumerate(
            zip(numpy.diff(onsets), (86.6, 64.7, 86.6, 64.7))):
        fine = check(f"interval {number + 1} [yr]", interval, expected, 0.04) and fine
    for event, expected in zip(found, (2.21, 2.55, 2.21, 2.55)):
        fine = check("slip [m]", event["slip"], expected, 0.04) and fine
    return fine and len(found) >= 5


def main(mesh_tool, dip):
    subprocess.run([mesh_tool, "convert", asperity_run.SOURCE / "xml/meshes/bp3.geo", "bp3.h5",
                    "--set", f"dip={dip}", "--set", f"h={CELL[dip]}", "--overwrite"], check=True,
                   timeout=300)
    folder = asperity_run.run_to_end("out", asperity_run.SOURCE / "xml/bp3_qd.xml", "--set",
                                     f"Time Stepping/Final Time={END[dip]}", timeout=28000)
    return 0 if {60: of_60_degrees, 30: of_30_degrees}[dip](events(folder)) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], int(sys.argv[2])))
