"""Writes the result of a vertical fault over centuries, as that of the SEAS benchmark BP1 looks.

Slip is a formula: the fault is locked above 15 km, slides at the plate rate below 18 km, and
catches up in ruptures that run upwards from 12 km and downwards to 18 km at 2 km/s, each place
slipping at a constant rate for RISE seconds. All is linear in time between the rows written.
"""

from pathlib import Path
from typing import Dict

import h5py
import numpy as np

from synthetic_run import write_history

YEAR = 3.15576e7
PLATE_RATE, DEEP, CONTINUED = 1e-9, 40e3, 48e3  # [m/s], [m]; below DEEP the rate is prescribed
NUCLEATION, SPEED, RISE = 12e3, 2e3, 4.0        # [m], [m/s], [s]
ONSETS = np.array([196.4, 272.0, 349.8, 428.1]) * YEAR
FINAL = 450.0 * YEAR
SHEAR_MODULUS = 32e9                            # [Pa]
RECEIVERS = {"dp000": 0.0, "dp025": 2.5e3, "dp050": 5e3, "dp075": 7.5e3, "dp100": 10e3,
             "dp150": 15e3, "dp200": 20e3}
STATIONS = {"near": 1.0, "far": 0.25}           # in the body, with their shares of the slip


def depths(nodes: int) -> np.ndarray:
    """(nodes) [m] from the upper end, where positions begin."""
    return np.linspace(0.0, CONTINUED, nodes)


def row_times() -> np.ndarray:
    """Half a year apart, and every quarter of a second in an event."""
    rows = [np.arange(0.0, FINAL, 0.5 * YEAR), [FINAL]]
    rows += [onset + np.arange(0.0, duration() + 0.1, 0.25) for onset in ONSETS]
    return np.unique(np.concatenate(rows))


def duration() -> float:
    return NUCLEATION / SPEED + RISE


def locked(depth: np.ndarray) -> np.ndarray:
    """1 above 15 km, 0 below 18 km."""
    return np.clip((18e3 - depth) / 3e3, 0.0, 1.0)


def arrivals(depth: np.ndarray) -> np.ndarray:
    """(nodes) [s] since the onset, nan where ruptures do not go."""
    delay = np.abs(depth - NUCLEATION) / SPEED
    return np.where(locked(depth) > 0.0, delay, np.nan)


def offsets() -> np.ndarray:
    """(events) [m] slip of each on the locked part: what the plate has moved since the last."""
    return PLATE_RATE * np.diff(ONSETS, prepend=0.0)


def slip(times: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """(times, nodes) [m]."""
    delay = np.abs(depth - NUCLEATION) / SPEED
    result = PLATE_RATE * times[:, None] * (1.0 - locked(depth))
    for onset, offset in zip(ONSETS, offsets()):
        share = np.clip((times[:, None] - onset - delay) / RISE, 0.0, 1.0)
        result += offset * share * locked(depth)
    return result


def slip_rate(times: np.ndarray, depth: np.ndarray) -> np.ndarray:
    """(times, nodes) [m/s], from the right; 1e-14 where the fault is locked."""
    delay = np.abs(depth - NUCLEATION) / SPEED
    result = 1e-14 + PLATE_RATE * (1.0 - locked(depth)) * np.ones((times.size, 1))
    for onset, offset in zip(ONSETS, offsets()):
        since = times[:, None] - onset - delay
        result += np.where((since >= 0.0) & (since < RISE), offset / RISE, 0.0) * locked(depth)
    return result


def fields(times: np.ndarray, depth: np.ndarray) -> Dict[str, np.ndarray]:
    rate = slip_rate(times, depth)
    return {"slip_rate": rate, "slip": slip(times, depth), "theta": 8e-3 / rate,
            "traction": 3e7 + 1e6 * np.log10(rate / 1e-6)}


def write_run(folder: Path, nodes: int = 97) -> None:
    """A result as packages/io/README.md has it."""
    folder.mkdir(parents=True, exist_ok=True)
    times, depth = row_times(), depths(nodes)
    coordinates = np.stack((0.0 * depth, -depth), axis=1)
    prescribed = (depth > DEEP) * np.ones((times.size, 1))
    write_history(folder / "fault.h5", times, coordinates,
                  {**fields(times, depth), "prescribed": prescribed}, 3)
    write_receivers(folder / "receivers.h5", times)
    write_ruptures(folder / "rupture.h5", depth)
    write_totals(folder / "global.csv", times)
    write_events(folder / "events.csv")
    write_steps(folder / "steps.csv", times)
    write_parameters(folder / "parameters.xml")


def write_parameters(path: Path) -> None:
    """The threshold of the events, which every run says there."""
    path.write_text('<ParameterList name="Asperity"><ParameterList name="Output">'
                    '<ParameterList name="Event Catalogue">'
                    '<Parameter name="Threshold" type="double" value="1e-3"/>'
                    '</ParameterList></ParameterList></ParameterList>\n')


def write_receivers(path: Path, times: np.ndarray) -> None:
    with h5py.File(path, "w") as file:
        file["time"] = times
        file["on_fault/names"] = list(RECEIVERS)
        for name, values in fields(times, np.array(list(RECEIVERS.values()))).items():
            file[f"on_fault/fields/{name}"] = values
        file["off_fault/names"] = list(STATIONS)
        for name, values in motion(times).items():
            file[f"off_fault/fields/{name}"] = values


def motion(times: np.ndarray) -> Dict[str, np.ndarray]:
    """(times, STATIONS, 3): displacement and velocity that follow the slip at 5 km depth, of which
    a station has its share; the displacement at the start is not zero."""
    depth = np.array([5e3])
    shares = np.array(list(STATIONS.values()))
    follow = np.array([0.5, 0.1, -0.05])
    return {"displacement": 2.0 + slip(times, depth)[:, :, None] * shares[None, :, None] * follow,
            "velocity": slip_rate(times, depth)[:, :, None] * shares[None, :, None] * follow}


def write_ruptures(path: Path, depth: np.ndarray) -> None:
    with h5py.File(path, "w") as file:
        file["threshold"] = [1e-3]
        file["number"] = np.arange(ONSETS.size) + 1
        file["onset"] = ONSETS
        file["rupture_time"] = ONSETS[:, None] + arrivals(depth)
        file["geometry/coordinates"] = np.stack((0.0 * depth, -depth), axis=1)
        file["geometry/positions"] = depth


def write_totals(path: Path, times: np.ndarray) -> None:
    """Moments of the locked part alone, on a fault of nodes 100 m apart."""
    depth = np.arange(50.0, 18e3, 100.0)
    rate = SHEAR_MODULUS * 100.0 * slip_rate(times, depth).sum(axis=1)
    moment = SHEAR_MODULUS * 100.0 * slip(times, depth).sum(axis=1)
    rows = ["time [s],peak_slip_rate [m/s],moment_rate_per_length [N/s],moment_per_length [N]"]
    rows += [f"{time},{1.0},{now},{total}" for time, now, total in zip(times, rate, moment)]
    path.write_text("\n".join(rows) + "\n")


def write_events(path: Path) -> None:
    rows = ["number,onset [s],end [s],duration [s],width [m],peak_slip [m],peak_slip_rate [m/s],"
            "moment_per_length [N],nucleation [m],complete,kinetic_energy [J/m],"
            "friction_work [J/m],numerical_dissipation [J/m],energy_defect [J/m]"]
    for number, (onset, offset) in enumerate(zip(ONSETS, offsets()), start=1):
        rows.append(f"{number},{onset},{onset + duration()},{duration()},18000,{offset},"
                    f"{offset / RISE},{SHEAR_MODULUS * 16.5e3 * offset},12000,1,"
                    f"{1e3 * number},{1e9 * number},{2e5 * number},{-3e4 * number}")
    path.write_text("\n".join(rows) + "\n")


def write_steps(path: Path, times: np.ndarray) -> None:
    """Two coupled steps for each accepted one, three rate problems, five iterations."""
    rows = ["step,time [s],step_size [s],peak_slip_rate [m/s],fixed_point_iterations,"
            "coupled_steps,rate_problems,tnnmg_iterations,v_cycles,failed_steps"]
    rows += [f"{step},{times[step]},{times[step] - times[step - 1]},1e-9,2,2,3,5,0,0"
             for step in range(1, times.size)]
    path.write_text("\n".join(rows) + "\n")
