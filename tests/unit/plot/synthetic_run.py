"""Writes result folders that look like those of a run: a fault that sticks and slips.

The fields are formulas, not solutions: slip rates rise like a power of the time to failure, run
outwards from a nucleation point, and decay into afterslip; steps adapt to them as in a run.
"""

import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Dict, List

import h5py
import numpy as np

PLATE_RATE = 5e-5   # [m/s]
THRESHOLD = 1.05e-3  # [m/s]
RECURRENCE = 17.0   # [s]
FIRST = 12.0        # [s], onset of the first event
PEAK_RATE = 0.11    # [m/s]
CENTRE, HALF_WIDTH, FRONT = 0.26, 0.11, 6.0  # [m], [m], [m/s] of the ruptures
DIP = np.arctan(0.27)

PARAMETERS = """<ParameterList name="Asperity">
  <ParameterList name="Mesh">
    <Parameter name="Type" type="string" value="Wedge"/>
    <ParameterList name="Wedge">
      <Parameter name="Length" type="double" value="1.0"/>
      <Parameter name="Height" type="double" value="0.27"/>
      <Parameter name="Seismogenic Zone Width" type="double" value="0.2"/>
      <Parameter name="Seismogenic Zone End" type="double" value="0.35"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Output">
    <ParameterList name="Event Catalogue">
      <Parameter name="Threshold" type="double" value="1e-3"/>
    </ParameterList>
  </ParameterList>
  <ParameterList name="Bulk">
    <Parameter name="Gravitational Acceleration" type="double" value="9.81"/>
    <Parameter name="Gravity Direction" type="Array(double)" value="{0.27, -1.0}"/>
  </ParameterList>
</ParameterList>
"""


def event_times(count: int) -> np.ndarray:
    """Onsets that vary a little, so that box plots have something to show."""
    number = np.arange(count)
    return FIRST + RECURRENCE * number + 0.4 * np.sin(2.4 * number)


def adaptive_times(events: np.ndarray, final: float) -> np.ndarray:
    """Times with steps 2^-k that shrink towards each event and grow again after it."""
    times = [0.0]
    while times[-1] < final:
        distance = np.min(np.abs(events - times[-1]), initial=20.0)
        step = np.clip(0.04 * distance, 2.0**-11, 0.5)
        times.append(times[-1] + 2.0**np.floor(np.log2(step)))
    return np.array(times)


def slip_rate(times: np.ndarray, positions: np.ndarray, events: np.ndarray) -> np.ndarray:
    """(times, nodes) [m/s]."""
    inside = 1.0 / (1.0 + np.exp((np.abs(positions - CENTRE) - HALF_WIDTH) / 0.008))
    delay = np.abs(positions - CENTRE) / FRONT
    rate = 1e-9 * inside + PLATE_RATE * (1.0 - inside) * np.ones((times.size, 1))
    for number, onset in enumerate(events):
        since = times[:, None] - onset - delay
        before = 1.0 / (1.0 + np.maximum(-since, 0.0) / 0.002)**1.6
        after = np.exp(-np.maximum(since, 0.0) / 0.02)
        size = PEAK_RATE * (1.0 + 0.1 * np.sin(1.7 * number))
        rate += size * inside * np.where(since < 0.0, before, after)
        distance = np.maximum(np.abs(positions - CENTRE) - HALF_WIDTH, 0.0)
        afterslip = 4e-3 * np.exp(-distance / 0.05) / (1.0 + np.maximum(since, 0.0) / 0.05)
        rate += np.where(since > 0.0, (1.0 - inside) * afterslip, 0.0)
    return rate


def accumulate(times: np.ndarray, rate: np.ndarray) -> np.ndarray:
    """Integral over time by the trapezoidal rule, 0 at the start."""
    increments = 0.5 * np.diff(times)[:, None] * (rate[1:] + rate[:-1])
    return np.concatenate((np.zeros((1, rate.shape[1])), np.cumsum(increments, axis=0)))


def uplift(times: np.ndarray, positions: np.ndarray, events: np.ndarray) -> np.ndarray:
    """(times, nodes) [m]: what builds up between events and is undone by them."""
    count = np.sum(times[:, None] >= events, axis=1) if events.size else np.zeros(times.size)
    deficit = PLATE_RATE * (times - RECURRENCE * count)
    shape = np.exp(-((positions - 0.42) / 0.12)**2) - 0.6 * np.exp(-((positions - 0.18) / 0.1)**2)
    return 0.2 * deficit[:, None] * shape


def write_history(path: Path, times: np.ndarray, coordinates: np.ndarray,
                  fields: Dict[str, np.ndarray], segments: int = 2) -> None:
    """A history as packages/io/README.md has it: virtual datasets over segments."""
    folder = path.parent / "segments"
    folder.mkdir(parents=True, exist_ok=True)
    data = {"time": times, **{f"fields/{name}": values for name, values in fields.items()}}
    limits = np.linspace(0, times.size, segments + 1).astype(int)
    names = [f"segments/{path.stem}_{number:06d}.h5" for number in range(segments)]
    for name, first, last in zip(names, limits, limits[1:]):
        with h5py.File(path.parent / name, "w") as file:
            for key, values in data.items():
                file[key] = values[first:last]
    positions = np.linalg.norm(coordinates - coordinates[0], axis=1)
    with h5py.File(path, "w") as file:
        for key, values in data.items():
            layout = h5py.VirtualLayout(values.shape, dtype=values.dtype)
            for name, first, last in zip(names, limits, limits[1:]):
                shape = (last - first,) + values.shape[1:]
                layout[first:last] = h5py.VirtualSource(name, key, shape=shape)
            file.create_virtual_dataset(key, layout)
        file["geometry/coordinates"] = coordinates
        file["geometry/positions"] = positions
        file["geometry/weights"] = np.gradient(positions)


def write_run(folder: Path, num_events: int = 8, nodes: int = 90, wedge: bool = True) -> None:
    """A complete result; without `wedge` it has neither parameters.xml nor a dipping surface."""
    folder.mkdir(parents=True, exist_ok=True)
    events = event_times(num_events)
    times = adaptive_times(events, FIRST + RECURRENCE * max(num_events, 2))
    base = np.linspace(0.0, 1.0 / np.cos(DIP), nodes)
    rate = slip_rate(times, base, events)
    slip = -accumulate(times, rate)
    write_history(folder / "fault.h5", times, np.stack((base, 0.0 * base), axis=1),
                  {"slip_rate": rate.astype(np.float32), "slip": slip})
    angle = DIP if wedge else 0.0
    along = np.linspace(0.0, 1.0, nodes // 2)
    up = np.array([-np.sin(angle), np.cos(angle)])
    displacement = uplift(times, along, events)[..., None] * up
    write_history(folder / "surface.h5", times,
                  along[:, None] * np.array([np.cos(angle), np.sin(angle)]),
                  {"displacement": displacement})
    write_events(folder / "events.csv", times, base, rate, events)
    write_steps(folder / "steps.csv", times, rate)
    if wedge:
        (folder / "parameters.xml").write_text(PARAMETERS)


def add_condition(folder: Path, kind: str) -> None:
    """A boundary condition of the Type `kind` in the parameters, which are written if there are
    none."""
    path = folder / "parameters.xml"
    root = ElementTree.fromstring(path.read_text() if path.exists() else
                                  '<ParameterList name="Asperity"/>')
    conditions = ElementTree.SubElement(root, "ParameterList", name="Boundary Conditions")
    condition = ElementTree.SubElement(conditions, "ParameterList", name="A condition")
    ElementTree.SubElement(condition, "Parameter", name="Type", type="string", value=kind)
    path.write_text(ElementTree.tostring(root, encoding="unicode"))


def write_events(path: Path, times, positions, rate, events) -> None:
    rows: List[str] = ["number,onset [s],end [s],duration [s],width [m],peak_slip [m],"
                       "peak_slip_rate [m/s],moment_per_length [N],nucleation [m],complete"]
    for number, centre in enumerate(events, start=1):
        near = np.abs(times - centre) < 0.5 * RECURRENCE
        seismic = near[:, None] & (rate >= THRESHOLD)
        active = times[seismic.any(axis=1)]
        ruptured = positions[seismic.any(axis=0)]
        steps = np.diff(times, prepend=0.0)[:, None]
        slip = np.sum(np.where(seismic, rate * steps, 0.0), axis=0).max()
        rows.append(f"{number},{active[0]},{active[-1]},{active[-1] - active[0]},"
                    f"{ruptured[-1] - ruptured[0]},{slip},{rate[near].max()},nan,{CENTRE},1")
    path.write_text("\n".join(rows) + "\n")


def write_steps(path: Path, times, rate) -> None:
    rows = ["step,time [s],step_size [s],peak_slip_rate [m/s],fixed_point_iterations,"
            "kinetic_energy [J/m],elastic_energy [J/m],boundary_work [J/m],friction_work [J/m],"
            "energy_defect [J/m]"]
    work = np.cumsum(0.05 * np.diff(times) * rate[1:].mean(axis=1)) * 1e3
    for step in range(1, times.size):
        iterations = 2 + (step % 7 == 0) + 2 * (step % 61 == 0)
        rows.append(f"{step},{times[step]},{times[step] - times[step - 1]},"
                    f"{rate[step].max()},{iterations},{0.5 * rate[step].mean()**2},"
                    f"{12.0 + PLATE_RATE * times[step] * 50 - work[step - 1]},"
                    f"{PLATE_RATE * times[step] * 50},{work[step - 1]},"
                    f"{1e-9 * work[step - 1] * np.sin(0.01 * step)}")
    path.write_text("\n".join(rows) + "\n")
