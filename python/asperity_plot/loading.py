"""The boundary that drives a run, from its deck. Relative to it cycles repeat."""

from dataclasses import dataclass
from typing import Optional

import numpy as np

from asperity.parameters import Parameters

CONDITIONS = "Boundary Conditions/"


@dataclass(frozen=True)
class Loading:
    """A boundary moved at a constant velocity [m/s] after a smooth ramp [s]."""

    velocity: np.ndarray  # along the axes
    ramp: float

    def displacement(self, time: np.ndarray) -> np.ndarray:
        """(n_times, 2) of the boundary in m; the ramp is (1 - cos(pi t / ramp)) / 2."""
        time = np.asarray(time, dtype=float)
        path = time - self.ramp / 2
        if self.ramp > 0:
            early = time < self.ramp
            phase = np.pi * time[early] / self.ramp
            path[early] = (time[early] - self.ramp / np.pi * np.sin(phase)) / 2
        return path[:, None] * self.velocity


def read(parameters: Parameters) -> Optional[Loading]:
    """The only boundary with a prescribed velocity that is a number; None if there is none."""
    found = []
    for path in parameters.paths():
        if path.startswith(CONDITIONS) and path.endswith("/Type"):
            name = path[:-len("Type")]
            velocity = parameters.number(name + "Velocity")
            direction = np.array(parameters.numbers(name + "Direction") or [1.0, 0.0])
            if parameters.text(path) == "Prescribed Velocity" and velocity and direction.size == 2:
                unit = direction / np.linalg.norm(direction)
                found.append(Loading(velocity * unit,
                                     parameters.number(name + "Ramp Duration") or 0.0))
    return found[0] if len(found) == 1 else None
