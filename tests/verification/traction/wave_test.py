"""The wave that a traction T sends along a strip of rock: behind its front the velocity is
T / (rho c), and half of the work T^2 t / (rho c) that the traction does is kinetic.

Its steps follow from the error of displacements and velocities, since there is no fault.
"""

import math
import pathlib
import unittest

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("block.xml")
DENSITY, G, POISSON, T = 1000, 1e6, 0.25, 100.0
LENGTH, HEIGHT, CELLS = 100.0, 1.0, 200
SHEAR_SPEED = math.sqrt(G / DENSITY)
PRESSURE_SPEED = SHEAR_SPEED * math.sqrt(2 * (1 - POISSON) / (1 - 2 * POISSON))
CONDITIONS = "Boundary Conditions/"


def rise_at(speed):
    """[s] in which the traction rises, linearly, to its value."""
    return 0.06 * LENGTH / speed


def run(name, model, speed, *changes, ranks=1, entry):
    """Until the wave is at 0.7 of the strip; the traction acts on its right end."""
    rise = rise_at(speed)
    strip = {"Mesh/Rectangle/Width": LENGTH, "Mesh/Rectangle/Height": HEIGHT,
             "Mesh/Rectangle/Cells X": CELLS, "Mesh/Rectangle/Cells Y": 2, "Bulk/Model": model,
             "Bulk/Dynamics": "Inertial", "Bulk/Poisson's Ratio": POISSON,
             f"{CONDITIONS}Wall/Type": "Absorbing", f"{CONDITIONS}Lid/Boundary": "top",
             f"{CONDITIONS}Lid/Type": "Sliding Wall",
             f"{CONDITIONS}Pull/{entry}": f"{T} * min(t / {rise}, 1)",
             "Initial State/Displacement": "Zero", "Time Stepping/Control": "Richardson",
             "Time Stepping/Richardson/Tolerance": 1e-3, "Time Stepping/Largest Step": 1,
             "Time Stepping/Final Time": 0.7 * LENGTH / speed,
             "Output/Receivers/Off Fault/middle": "{50, 0.5}",
             "Output/Receivers/Off Fault/end": "{100, 0.5}"}
    removed = ["Time Stepping/Smallest Step"] + ["Boundary Conditions/Pull/Traction X"] * (
        entry != "Traction X")
    removals = [word for path in removed for word in ("--remove", path)]
    return asperity_run.run_to_end(name, DECK, *removals, *asperity_run.settings(strip, *changes),
                                   ranks=ranks)


class Wave(unittest.TestCase):
    def check(self, folder, speed):
        velocity, rise = T / (DENSITY * speed), rise_at(speed)
        receivers = asperity_run.series(folder / "receivers.h5")
        time = receivers["time"]
        found = receivers["off_fault/fields/velocity"].reshape(len(time), 2, -1)[:, :, 0]
        for where, arrival in ((0, 0.5 * LENGTH / speed), (1, 0)):
            expected = velocity * numpy.clip((time - arrival) / rise, 0, 1)
            error = numpy.abs(found[:, where] - expected).max() / velocity
            print(f"{folder.name}, {time.size} times: {error:.2%}", flush=True)
            self.assertLess(error, 0.05)  # cells disperse the kinks of the rise
            behind = time > arrival + 1.5 * rise
            self.assertGreater(behind.sum(), 5)
            self.assertAlmostEqual(found[behind, where].mean() / velocity, 1, delta=2e-3)
        steps = asperity_run.table(folder / "steps.csv")
        last = steps[-1]
        # the square of the traction, integrated over the time
        work = T * velocity * HEIGHT * (time[-1] - rise + rise / 3)
        self.assertAlmostEqual(last["load_work"] / work, 1, delta=5e-3)
        self.assertAlmostEqual(last["kinetic_energy"] / (work / 2), 1, delta=5e-3)
        self.assertAlmostEqual(last["elastic_energy"] / (work / 2), 1, delta=5e-3)
        self.assertLess(abs(last["energy_defect"]), 1e-6 * work)

    def test_shear(self):
        folder = run("shear", "Antiplane", SHEAR_SPEED, entry="Traction Z")
        self.check(folder, SHEAR_SPEED)

    def test_pressure(self):
        folder = run("pressure", "Plane Strain", PRESSURE_SPEED, entry="Traction X")
        self.check(folder, PRESSURE_SPEED)


if __name__ == "__main__":
    unittest.main()
