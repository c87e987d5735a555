"""The pressure and the flow that line.xml gives along a fault, against those of a line source; what
ranks and restarts change; fixed pressure; the volume in a surface; what is refused or asked."""

import math
import pathlib
import sys

import asperity_run
import h5py
import numpy

DECK = pathlib.Path(__file__).with_name("line.xml")
DAY = 86400.0
SHUT_IN = 100 * DAY
DIFFUSIVITY, STORAGE, RATE = 0.1, 1e-9, 1.25e-6  # m^2/s, 1/Pa, m/s
LINE_SOURCE = 0.005  # of 6.555 MPa, and of half the rate, with cells of 100 m
ON_RANKS = 1e-9      # of the largest pressure
VOLUME = 1e-6        # of what is pumped in; pressures are written with 7 digits
PORE = "Friction/Pore Pressure"


def pressure_since(t, z):
    """Of a source that began t ago."""
    if t <= 0:
        return 0.0
    x = abs(z) / math.sqrt(4 * DIFFUSIVITY * t)
    growth = math.exp(-x**2) / math.sqrt(math.pi) - x * math.erfc(x)
    return RATE / STORAGE * math.sqrt(t / DIFFUSIVITY) * growth


def flow_since(t, z):
    """Half the rate of the source goes to each side."""
    return RATE / 2 * math.erfc(z / math.sqrt(4 * DIFFUSIVITY * t)) if t > 0 else 0.0


def exact(t, z):
    return pressure_since(t, z) - pressure_since(t - SHUT_IN, z)


def pressures(folder):
    """Times, and (times, receivers)."""
    history = asperity_run.series(folder / "receivers.h5")
    return history["time"], history["on_fault/fields/pore_pressure"]


def run(name, changes=None, ranks=1):
    return pressures(asperity_run.run_to_end(name, DECK, *asperity_run.settings(changes or {}),
                                             ranks=ranks))


def verdict(what, error, limit):
    fine = error <= limit
    print(f"{what}: {error:.1e}{'' if fine else f' NOT within {limit:g}'}", flush=True)
    return fine


def line_source():
    assert abs(exact(SHUT_IN, 0) - 6.555e6) < 1e3 and abs(exact(SHUT_IN, 500) - 3.899e6) < 1e3
    times, found = run("whole")
    late = times > 20 * DAY
    expected = numpy.array([[exact(t, 0), exact(t, 500)] for t in times[late]])
    error = numpy.abs(found[late, :2] - expected).max() / 6.555e6
    return found, [verdict("line source", error, LINE_SOURCE), flow(late)]


def flow(late):
    """At 500 m, where it goes along x."""
    history = asperity_run.series(pathlib.Path("whole") / "receivers.h5")
    found = history["on_fault/fields/darcy_velocity"][late, 1]
    expected = [flow_since(t, 500) - flow_since(t - SHUT_IN, 500) for t in history["time"][late]]
    return verdict("flow from a line source", numpy.abs(found[:, 0] - expected).max() / (RATE / 2)
                   + numpy.abs(found[:, 1]).max(), LINE_SOURCE)


def ranks_and_restarts(whole):
    largest = whole.max()
    fine = [verdict(f"{ranks} ranks", numpy.abs(run("ranks", ranks=ranks)[1] - whole).max()
                    / largest, ON_RANKS) for ranks in (2, 3)]
    for before, after, limit in ((1, 1, 0), (2, 3, ON_RANKS)):
        folder = asperity_run.run_to_end(
            "half", DECK, *asperity_run.settings({"Time Stepping/Final Time": 50 * DAY}),
            ranks=before)
        asperity_run.go_on(folder, DECK, ranks=after)
        fine.append(verdict(f"{before} ranks, then {after}",
                            numpy.abs(pressures(folder)[1] - whole).max() / largest, limit))
    return fine


def fixed():
    """From a uniform source a fault that is drained at its left end gets a parabola."""
    _, found = run("fixed", {f"{PORE}/Fixed Where": "x < -9.99e3", f"{PORE}/Injection": 1e-7,
                             f"{PORE}/Wells/W1/Rate": 0, f"{PORE}/Permeability": 1e-8,
                             f"{PORE}/Initial Pressure": 3e5})
    mobility = 2 * 1e-8 / 1e-3
    rate = asperity_run.series(pathlib.Path("fixed") / "receivers.h5")[
        "on_fault/fields/darcy_velocity"][-1, :2, 0]
    expected = [3e5 + 1e-7 / mobility * (2e4 * x - x**2 / 2) for x in (1e4, 1.05e4, 0)]
    flow_to_left = [1e-7 / 2 * (1e4 - x) for x in (0, 500)]  # of what flows in beyond, 2 m wide
    return [verdict("drained at one end",
                    numpy.abs(found[-1] - expected).max() / max(expected), 1e-9),
            verdict("flow to it", numpy.abs(rate / flow_to_left + 1).max(), 1e-6)]


def volume_on_a_surface():
    """A fault in space that slips in an earthquake holds what a well pumps into it."""
    rate, storage, width = 3e3, 1e-10, 10
    well = {"Enabled": "true", "Permeability": "1e-6 * (1 + x / 25e3)", "Storage": storage,
            "Width": width, "Wells/A/Place": "{900, -7700, 0}", "Wells/A/Rate": rate}
    folder = asperity_run.run_to_end(
        "surface", asperity_run.SOURCE / "xml" / "tpv101_3d.xml", *asperity_run.settings(
            {f"{PORE}/{name}": value for name, value in well.items()},
            {"Mesh/Box/Cell Size Factor": 4, "Time Stepping/Final Time": 0.5,
             "Output/Fault History/Fields": "{pore_pressure}",
             "Output/Fault History/Every n Steps": 1}), ranks=2)
    history = asperity_run.series(folder / "fault.h5")
    with h5py.File(folder / "segments" / "fault_geometry.h5") as file:
        corners = file["geometry/coordinates"][()][file["geometry/connectivity"][()]]
        connectivity = file["geometry/connectivity"][()]
    edges = corners[:, 1:] - corners[:, :1]
    areas = numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1) / 2
    mean = history["fields/pore_pressure"].astype(float)[:, connectivity].mean(axis=2)
    volume = storage * width * mean @ areas
    pumped = rate * history["time"]
    return [verdict("volume on a surface", numpy.abs(volume - pumped).max() / pumped[-1], VOLUME)]


def asked_and_refused():
    result = asperity_run.run(DECK, *asperity_run.settings({"Friction/Normal Stress": 3e6}),
                              "--output", "asked", "--overwrite")
    asks = ("a pressure on the fault has reached the normal stress, first at (0, 0"
            in result.stdout and result.stdout.count("has reached the normal stress") == 1)
    print(f"asked {'' if asks else 'NO ' + result.stdout + result.stderr}")
    return [asks, *(asperity_run.refuses(DECK, changes, message) for changes, message in (
        ({f"{PORE}/Permeability": -1e-13}, "Permeability"),
        ({f"{PORE}/Storage": 0}, "Storage"),
        ({f"{PORE}/Width": 0}, "Width"),
        ({f"{PORE}/Fluid Viscosity": -1}, "Fluid Viscosity"),
        ({f"{PORE}/Wells/W1/Place": "{0, 150}"}, "Wells / W1 is at (0, 150), 150 m"),
        ({f"{PORE}/Wells/W1/Place": "{0, 5}"}, "Wells / W1 is at (0, 5), 5 m"),
        ({f"{PORE}/Fixed Where": "y < -2e4"}, "Fixed Where = 'y < -2e4' is above zero at no node"),
        ({f"{PORE}/Wells/W1/Place": "{0, 0, 0}"}, "has 3 numbers")))]


def main():
    whole, passed = line_source()
    passed += (ranks_and_restarts(whole) + fixed() + volume_on_a_surface()
               + asked_and_refused())
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
