"""Writes results of runs whose fields are linear in place and time, for asperity-platform.

On the fault, at x or in space at (y, z): slip x t, slip rate x, traction x - t [MPa], normal stress
50 + x [MPa], theta 1e8 s; in the body displacement (c + 1) (x + 2 y) + t and velocity (c + 1) y of
the component c. Steps of 0.4 s end at 0.4, 0.8, 1.2 and 1.6 s.
"""

import json
from pathlib import Path
from typing import Dict, Sequence

import h5py
import numpy as np

STEP = 0.4
TIMES = STEP * np.arange(5)
BEGIN = 1717113600.0  # 2024/05/31, 0:00 UTC
LEVEL = {"level": 1, "thrust_sign": 1}
SECTION = {"level": 0, "thrust_sign": 1}
THRUST = {"level": 0, "thrust_sign": -1}
# A vertical fault x = 0 below y = 0, the body in x > 0: strike is z.
SPACE = {"strike": [0, 0, 1], "dip": [0, -1, 0], "down": [0, -1, 0], "inward": [1, 0, 0], "top": 0}


def write_run(folder: Path, fault: Dict, model: str = "Plane Strain",
              rows: Sequence[int] = range(5), enabled: Sequence[str] = (),
              element_size: float = 50.0, **more) -> None:
    """`rows`: the steps with rows in receivers.h5; `more` of what run.jsonl says of the fault."""
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "run.log").write_text("Asperity 1.2 on Serial, 1 rank.\n")
    entries = [{"event": "begin", "clock": BEGIN},
               {"event": "fault", "element_size": element_size, **fault, **more}]
    (folder / "run.jsonl").write_text("".join(json.dumps({"step": 0, "time": 0, **entry}) + "\n"
                                              for entry in entries))
    processes = "".join(f'<ParameterList name="{name}"><Parameter name="Enabled" type="bool" '
                        'value="true"/></ParameterList>' for name in enabled)
    (folder / "parameters.xml").write_text(
        '<ParameterList name="Asperity"><ParameterList name="Bulk">'
        f'<Parameter name="Model" type="string" value="{model}"/></ParameterList>'
        f'<ParameterList name="Friction">{processes}</ParameterList></ParameterList>\n')
    (folder / "steps.csv").write_text("step,time [s],step_size [s]\n" + "".join(
        f"{i},{time:.17g},0.4\n" for i, time in enumerate(TIMES) if i))
    write_receivers(folder / "receivers.h5", 1 if model == "Antiplane" else 2, list(rows))


def write_receivers(path: Path, components: int, rows: Sequence[int]) -> None:
    """dp003 at x = 0.3 and dp000 at 0, and in the body `inside` at (0.5, 0.75)."""
    time, x = TIMES[rows], np.array([0.3, 0.0])
    body, shares = np.array([0.5, 0.75]), np.arange(1, components + 1)
    with h5py.File(path, "w") as file:
        file["time"] = time
        write_group(file, "on_fault", ["dp003", "dp000"], np.stack((x, 0 * x), axis=1), {
            "slip": time[:, None] * x, "slip_rate": 0 * time[:, None] + x,
            "traction": 1e6 * (x - time[:, None]), "normal_stress": 5e7 + 1e6 * x
            + 0 * time[:, None], "theta": np.full((time.size, 2), 1e8)})
        file["on_fault/positions"] = x
        moved = shares * (body[0] + 2 * body[1]) + time[:, None]
        speed = shares * body[1] + 0 * time[:, None]
        shape = (time.size, 1) + ((components,) if components > 1 else ())
        write_group(file, "off_fault", ["inside"], body[None], {
            "displacement": moved.reshape(shape), "velocity": speed.reshape(shape)})


def write_group(file: h5py.File, group: str, names: Sequence[str], coordinates: np.ndarray,
                fields: Dict[str, np.ndarray]) -> None:
    file[f"{group}/names"] = list(names)
    file[f"{group}/coordinates"] = coordinates
    for name, values in fields.items():
        file[f"{group}/fields/{name}"] = values


def add_fields(folder: Path, **values: Sequence[float]) -> None:
    """Of receivers on the fault, the same at all of them and at all times."""
    with h5py.File(folder / "receivers.h5", "a") as file:
        rows, number = file["on_fault/fields/slip"].shape[:2]
        for name, value in values.items():
            file[f"on_fault/fields/{name}"] = np.broadcast_to(
                value, (rows, number) + np.shape(value))


def write_space(folder: Path, enabled: Sequence[str] = ()) -> None:
    """A receiver at (0, -0.7, 1.2) and one at (0.3, -2.1, 0.4) of SPACE; slip c (z - y), slip rate
    0.3 c, traction c + z [MPa], displacement x_c, velocity c + 1 of the component c."""
    write_run(folder, SPACE, enabled=enabled)
    place, c = np.array([0.0, -0.7, 1.2]), np.arange(3)
    body, two = np.array([0.3, -2.1, 0.4]), np.ones((2, 1, 1))
    with h5py.File(folder / "receivers.h5", "w") as file:
        file["time"] = [0.0, 1.0]
        write_group(file, "on_fault", ["st12dp07"], place[None], {
            "slip": two * c * (place[2] - place[1]), "slip_velocity": two * 0.3 * c,
            "traction": two * 1e6 * (c + place[2]) * (c > 0),
            "normal_stress": np.full((2, 1), 2.5e7), "theta": np.full((2, 1), 1e8)})
        write_group(file, "off_fault", ["inside"], body[None],
                    {"displacement": two * body, "velocity": two * (c + 1)})
