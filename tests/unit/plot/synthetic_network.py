"""Writes the result of four faults in the plane as a run has it: `through`, which `across` crosses,
`branch`, which ends on `through`, and `apart`, which touches none.

Three events: 1 breaks `through` and, with a moment of a thousandth of it, `across`; 2 breaks
`across` and, two seconds later, `through`; 3 breaks `apart`, 10 s after the end of event 2. The
fault `branch` is locked. Slip is an ellipse between the tips, and grows evenly in an event.
"""

from pathlib import Path
from typing import Dict, List, Tuple

import h5py
import numpy as np

from synthetic_run import write_history

ENDS = {"through": ((0.0, 0.0), (8e3, 0.0)), "across": ((4e3, 3e3), (4e3, -3e3)),
        "branch": ((3e3, 2e3), (1e3, 0.0)), "apart": ((5e3, -2e3), (9e3, -4e3))}  # [m]
STEP = 500.0  # [m] between nodes, about
# onset, duration [s], and of each fault that breaks: the delay [s], the moment [N], the slip [m]
EVENTS = ((1e8, 6.0, {"through": (0.0, 8e14, 2.0), "across": (3.0, 8e11, 0.001)}),
          (3e8, 8.0, {"across": (0.0, 3e14, 1.0), "through": (2.0, 1e14, 0.5)}),
          (3e8 + 18.0, 4.0, {"apart": (0.0, 2e14, 1.5)}))
FINAL = 4e8   # [s]


def curves(ends: Dict[str, Tuple] = ENDS) -> Dict[str, np.ndarray]:
    """(nodes, 2) [m] of each fault, from its upper end."""
    result = {}
    for name, (first, last) in ends.items():
        length = np.hypot(*np.subtract(last, first))
        share = np.linspace(0.0, 1.0, round(length / STEP) + 1)[:, None]
        result[name] = (1.0 - share) * np.array(first) + share * np.array(last)
    return result


def times() -> np.ndarray:
    rows = [np.linspace(0.0, FINAL, 41)]
    rows += [onset + np.arange(-1.0, duration + 1.1, 0.5) for onset, duration, _ in EVENTS]
    return np.unique(np.concatenate(rows))


def fields(at: np.ndarray, faults: Dict[str, np.ndarray]) -> Dict[str, np.ndarray]:
    """(times, nodes) of slip and slip rate."""
    slips, rates = [], []
    for name, nodes in faults.items():
        slip, rate = np.zeros((at.size, len(nodes))), np.full((at.size, len(nodes)), 1e-12)
        share = np.linspace(0.0, 1.0, len(nodes))
        shape = 2.0 * np.sqrt(share * (1.0 - share))
        for onset, duration, broken in EVENTS:
            if name in broken:
                delay, _, size = broken[name]
                since = (at[:, None] - onset - delay) / (duration - delay)
                slip += size * shape * np.clip(since, 0.0, 1.0)
                rate += size / (duration - delay) * shape * ((since >= 0.0) & (since <= 1.0))
        slips.append(slip)
        rates.append(rate)
    return {"slip": np.concatenate(slips, axis=1), "slip_rate": np.concatenate(rates, axis=1)}


def write_run(folder: Path, ends: Dict[str, Tuple] = ENDS) -> None:
    """fault.h5 and the tables of events."""
    folder.mkdir(parents=True, exist_ok=True)
    faults = curves(ends)
    write_history(folder / "fault.h5", times(), np.concatenate(list(faults.values())),
                  fields(times(), faults))
    first, positions, parts = 0.0, [], []
    for nodes in faults.values():
        along = np.linalg.norm(nodes - nodes[0], axis=1)
        positions.append(first + along)
        parts.append((first, first + along[-1]))
        first += along[-1]
    with h5py.File(folder / "fault.h5", "a") as file:
        file["geometry/positions"][:] = np.concatenate(positions)
        file["geometry/part_names"] = list(faults)
        file["geometry/part_ends"] = parts
    write_tables(folder, dict(zip(faults, parts)))
    (folder / "parameters.xml").write_text(
        '<ParameterList name="Asperity"><ParameterList name="Output"><ParameterList '
        'name="Event Catalogue"><Parameter name="Threshold" type="double" value="1e-3"/>'
        '</ParameterList></ParameterList></ParameterList>')


def write_tables(folder: Path, parts: Dict[str, Tuple[float, float]]) -> None:
    """events.csv and events_<fault>.csv."""
    header = ("number,onset [s],end [s],duration [s],width [m],peak_slip [m],peak_slip_rate [m/s],"
              "moment_per_length [N],nucleation_from_upper_end [m],complete")
    tables: Dict[str, List[str]] = {"events": [header],
                                    **{f"events_{name}": [header] for name in parts}}
    for number, (onset, duration, broken) in enumerate(EVENTS, start=1):
        middle = np.mean(parts[next(iter(broken))])
        moments, slips = zip(*(each[1:] for each in broken.values()))
        tables["events"].append(row(number, onset, duration, max(slips), sum(moments), middle))
        for name, (delay, moment, slip) in broken.items():
            tables[f"events_{name}"].append(row(number, onset + delay, duration - delay, slip,
                                                moment, np.mean(parts[name])))
    for name, lines in tables.items():
        (folder / f"{name}.csv").write_text("\n".join(lines) + "\n")


def row(number, onset, duration, slip, moment, nucleation) -> str:
    return ",".join(f"{float(value)!r}" for value in (
        number, onset, onset + duration, duration, 4e3, slip, slip / duration, moment, nucleation,
        1))
