"""Writes the result of a run on a dipping fault in three dimensions: one event, by formulas."""

from pathlib import Path

import h5py
import numpy as np

import synthetic_cycle

NX, NZ, STEP = 21, 11, 500.0       # nodes along strike and down dip, [m] between them
DIP = np.radians(30.0)
HYPOCENTRE = (2500.0, 2000.0)      # [m] along strike, down dip
SPEED, RADIUS, RATE = 2000.0, 3500.0, 1.0  # [m/s], [m], [m/s] of the rupture
ONSET, RISE, END = 100.0, 1.0, 103.0       # [s]


def grid():
    """Along strike and down dip [m] of the nodes, and the triangles."""
    strike, dip = np.meshgrid(STEP * np.arange(NX), STEP * np.arange(NZ), indexing="ij")
    first = (np.arange(NX - 1)[:, None] * NZ + np.arange(NZ - 1)).ravel()
    triangles = np.concatenate((np.stack((first, first + NZ, first + NZ + 1), axis=1),
                                np.stack((first, first + NZ + 1, first + 1), axis=1)))
    return strike.ravel(), dip.ravel(), triangles


def coordinates(strike, dip):
    """x is down dip and y up, z along strike."""
    return np.stack((np.cos(DIP) * dip, -np.sin(DIP) * dip, strike), axis=1)


def arrivals(strike, dip):
    """[s] since the onset, nan outside of the rupture."""
    distance = np.hypot(strike - HYPOCENTRE[0], dip - HYPOCENTRE[1])
    return np.where(distance <= RADIUS, distance / SPEED, np.nan)


def slip_of(time, strike, dip):
    """(times, nodes) [m]: RATE for RISE after the arrival."""
    since = np.nan_to_num(time[:, None] - ONSET - arrivals(strike, dip), nan=-1.0)
    return RATE * np.clip(since, 0.0, RISE)


def write_run(folder: Path) -> None:
    strike, dip, triangles = grid()
    nodes = coordinates(strike, dip)
    time = np.concatenate((np.linspace(0.0, 99.0, 12), np.linspace(100.0, 103.0, 61),
                           [104.0, 200.0]))
    slip = slip_of(time, strike, dip)
    rate = np.gradient(slip, time, axis=0) + 1e-9
    direction = np.array([0.6 * np.cos(DIP), -0.6 * np.sin(DIP), 0.8])
    with h5py.File(folder / "fault.h5", "w") as file:
        file["time"], file["fields/slip_rate"] = time, rate
        file["fields/slip"] = slip[..., None] * direction
        write_geometry(file, nodes, triangles)
    with h5py.File(folder / "rupture.h5", "w") as file:
        file["number"], file["onset"], file["threshold"] = [1], [ONSET], [1e-3]
        file["rupture_time"] = ONSET + arrivals(strike, dip)[None]
        write_geometry(file, nodes, triangles)
    synthetic_cycle.write_parameters(folder / "parameters.xml")
    first = coordinates(np.array([HYPOCENTRE[0]]), np.array([HYPOCENTRE[1]]))[0]
    (folder / "events.csv").write_text(
        "number,onset [s],end [s],duration [s],area [m^2],length [m],width [m],peak_slip [m],"
        "peak_slip_rate [m/s],moment [N m],magnitude,hypocentre_x [m],hypocentre_y [m],"
        "hypocentre_z [m],complete\n"
        f"1,{ONSET},{END},{END - ONSET},3e7,6e3,5e3,1.0,1.0,9e17,5.9,"
        f"{first[0]},{first[1]},{first[2]},1\n")
    moment = 3e10 * STEP**2 * slip.sum(axis=1)
    rows = np.stack((time, rate.max(axis=1), np.gradient(moment, time), moment), axis=1)
    (folder / "global.csv").write_text(
        "time [s],peak_slip_rate [m/s],moment_rate [N m/s],moment [N m]\n"
        + "".join(",".join(repr(float(value)) for value in row) + "\n" for row in rows))


def write_geometry(file, nodes, triangles) -> None:
    file["geometry/coordinates"], file["geometry/connectivity"] = nodes, triangles
