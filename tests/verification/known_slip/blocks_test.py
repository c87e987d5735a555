"""Faults whose slip is known, without friction anywhere: two blocks that it moves as rigid bodies,
pulses of slip, waves that slip sends; and what outputs, restarts, ranks and tools make of them."""

import math
import pathlib
import unittest

import asperity_run
import numpy
import runs
from asperity_run import go_on, settings
from comparisons import assert_same_results

DECK = pathlib.Path(__file__).with_name("blocks.xml")
FAULT = "Boundary Conditions/Fault/"
G, HEIGHT, END = 3e10, 1000.0, 1e9
ROUNDING = 1e-10

# Law and parameters of a deck that had friction before.
FRICTION = {"Friction/Law": "Regularised", "Friction/State Evolution": "Ageing",
            "Friction/a": 0.01, "Friction/b": 0.015, "Friction/L": 0.01,
            "Friction/Reference Slip Rate": 1e-6, "Friction/Normal Stress": 5e7,
            "Friction/Reference Friction Coefficient": 0.6}

# Slip of 1 m within a minute, by a smooth rate, on a fault in blocks whose far sides are free.
PEAK, MIDDLE, WIDTH = 0.05, 200.0, 10.0
SLIP = PEAK * WIDTH * math.sqrt(math.pi)
PULSE = {FAULT + "Slip Rate": f"{PEAK} * exp(-((t - {MIDDLE}) / {WIDTH})^2)",
         "Boundary Conditions/Left/Velocity": 0, "Boundary Conditions/Right/Velocity": 0,
         "Time Stepping/Final Time": 400, "Time Stepping/Largest Step": 100,
         "Output/Fault History/Every n Steps": 1, "Output/Checkpoint Every n Steps": 20,
         "Output/Receivers/On Fault/middle": "{500, 500}",
         "Output/Receivers/Off Fault/inside": "{250, 500}"}


def run(name, *changes, **options):
    return asperity_run.run_to_end(name, DECK, *settings(*changes), **options)


def last(folder):
    return asperity_run.table(folder / "steps.csv")[-1]


class RigidBlocks(unittest.TestCase):
    def check(self, folder):
        volume = asperity_run.series(folder / "volume.h5")
        moved, stress = (volume[f"fields/{name}"][-1] for name in ("displacement", "stress"))
        self.assertLess(numpy.abs(numpy.abs(moved[:, 1]) - 5e-10 * END).max(), ROUNDING)
        left = volume["geometry/coordinates"][:, 0] < 499
        self.assertTrue((moved[left, 1] > 0).all())
        self.assertLess(numpy.abs(moved[:, 0]).max(), ROUNDING)
        self.assertLess(numpy.abs(stress).max(), ROUNDING * G / HEIGHT)
        slip = asperity_run.series(folder / "fault.h5")["fields/slip"][-1]
        self.assertLess(numpy.abs(slip + 1e-9 * END).max(), ROUNDING)
        moment = asperity_run.table(folder / "global.csv")[-1]
        self.assertAlmostEqual(moment["moment_per_length"] / (G * HEIGHT * 1.0), 1, delta=1e-9)
        self.assertAlmostEqual(moment["moment_rate_per_length"] / (G * HEIGHT * 1e-9), 1,
                               delta=1e-9)

    def test_without_a_word_on_friction(self):
        for ranks in (1, 2, 4):
            with self.subTest(ranks=ranks):
                folder = run(f"rigid_{ranks}", ranks=ranks)
                self.check(folder)
                fields = asperity_run.series(folder / "fault.h5")
                self.assertIn("fields/traction", fields)
                for of_friction in ("alpha", "theta", "normal_stress"):
                    self.assertNotIn(f"fields/{of_friction}", fields)
        log = (folder / "run.log").read_text()
        self.assertIn("No friction", log)
        self.assertNotIn("WARNING", log)

    def test_with_friction_that_decides_nowhere(self):
        folder = run("rigid_with_friction", FRICTION)
        self.check(folder)
        self.assertIn("fields/alpha", asperity_run.series(folder / "fault.h5"))
        log = (folder / "run.log").read_text()
        self.assertIn("friction acts nowhere", log)
        self.assertNotIn("cohesive zone", log)

    def test_as_a_type_of_fault(self):
        """The same in one half: below an antisymmetric fault, whose slip is twice its motion."""
        half = {"Mesh/Rectangle/Width": 1000, FAULT + "Boundary": "bottom",
                FAULT + "Type": "Antisymmetric Fault", FAULT + "Slip Rate": 1e-9,
                "Boundary Conditions/Left/Boundary": "top",
                "Boundary Conditions/Left/Direction": "{1, 0}",
                "Boundary Conditions/Lid/Boundary": "top",
                "Boundary Conditions/Lid/Type": "Sliding Wall"}
        removed = ["Mesh/Faults", *(f"Boundary Conditions/{name}" for name in
                                    ("Right", "Wall", "Other Wall", "Top"))]
        folder = asperity_run.run_to_end("rigid_half", DECK, *(
            word for path in removed for word in ("--remove", path)), *settings(half))
        moved = asperity_run.series(folder / "volume.h5")["fields/displacement"][-1]
        self.assertLess(numpy.abs(moved[:, 0] - 5e-10 * END).max(), ROUNDING)
        slip = asperity_run.series(folder / "fault.h5")["fields/slip"][-1]
        self.assertLess(numpy.abs(slip - 1e-9 * END).max(), ROUNDING)

    def test_on_the_outer_boundary(self):
        result = asperity_run.run(DECK, "--validate", "--remove", "Mesh/Faults",
                                  *settings(FAULT + "Boundary=bottom"))
        self.assertEqual(result.returncode, 2)
        self.assertIn("is no fault inside the body", result.stderr)
        self.assertIn("'Antisymmetric Fault'", result.stderr)


class Pulse(unittest.TestCase):
    """Slip that comes and goes in time, and strains the blocks."""

    @classmethod
    def setUpClass(cls):
        cls.whole = run("pulse", PULSE)

    def test_slip_is_the_integral_of_its_rate(self):
        fault = asperity_run.series(self.whole / "fault.h5")
        self.assertLess(numpy.abs(fault["fields/slip"][-1] - SLIP).max(), 1e-3 * SLIP)
        steps = asperity_run.table(self.whole / "steps.csv")
        before, during = ([row["step_size"] for row in steps if low < row["time"] < high]
                          for low, high in ((350, 400), (MIDDLE - WIDTH, MIDDLE + WIDTH)))
        self.assertGreater(max(before), 4 * max(during))
        self.assertLess(len(steps), 400)

    def test_it_is_an_event(self):
        events = asperity_run.table(self.whole / "events.csv")
        self.assertEqual(len(events), 1)
        threshold = 1e-3
        half = WIDTH * math.sqrt(math.log(PEAK / threshold))
        self.assertAlmostEqual(events[0]["onset"], MIDDLE - half, delta=0.5)
        self.assertAlmostEqual(events[0]["duration"], 2 * half, delta=1)
        moment = events[0]["moment_per_length"]
        self.assertAlmostEqual(moment / (G * HEIGHT * SLIP * math.erf(half / WIDTH)), 1,
                               delta=5e-3)

    def test_energy(self):
        """What the fault's prescribed motion does against the stress is elastic energy and what
        radiation takes."""
        end = last(self.whole)
        self.assertGreater(end["elastic_energy"], 0)
        work = end["boundary_work"]
        self.assertAlmostEqual((end["elastic_energy"] + end["viscous_work"]) / work, 1, delta=1e-3)
        self.assertEqual(end["friction_work"], 0)

    def test_condensed_and_whole(self):
        log = (self.whole / "run.log").read_text()
        self.assertIn("It is condensed to its fault", log)
        folder = run("pulse_whole", PULSE, "TNNMG/Static Condensation=Off")
        for name in ("surface.h5", "receivers.h5"):
            a, b = (asperity_run.series(each / name) for each in (self.whole, folder))
            for key in a:
                if key.startswith("fields/") or "/fields/displacement" in key:
                    self.assertLess(numpy.abs(a[key] - b[key]).max(),
                                    1e-7 * max(numpy.abs(b[key]).max(), 1e-30), key)

    def test_stopped_and_restarted(self):
        deck = [DECK, *settings(PULSE, "Time Stepping/Richardson/Tolerance=1e-7",
                                "TNNMG/Static Condensation=Off")]
        whole = asperity_run.run_to_end("pulse_fine", *deck)
        folder = runs.fresh("pulse_stopped")
        runs.stop(self, runs.begin(folder, *deck))
        self.assertLess(len(asperity_run.table(folder / "steps.csv")),
                        len(asperity_run.table(whole / "steps.csv")))
        go_on(folder, *deck)
        assert_same_results(whole, folder)

    def test_other_ranks(self):
        for ranks in (2, 4):
            folder = run(f"pulse_{ranks}", PULSE, ranks=ranks)
            for name in ("fault.h5", "surface.h5"):
                a, b = (asperity_run.series(each / name) for each in (self.whole, folder))
                self.assertEqual(len(a["time"]), len(b["time"]))
                for key in ("fields/slip", "fields/displacement"):
                    if key in a:
                        self.assertLess(numpy.abs(a[key][-1] - b[key][-1]).max(),
                                        1e-6 * numpy.abs(a[key]).max())


class Waves(unittest.TestCase):
    """Slip at the rate V on an endless fault sends a shear wave to both sides: v = V / 2, and the
    traction falls by G V / (2 c_s)."""

    def test_on_both_sides(self):
        V, rise, cs = 1.0, 0.1, math.sqrt(G / 2670)
        deck = {"Bulk/Dynamics": "Inertial", "Bulk/Model": "Antiplane",
                "Mesh/Rectangle/Cells X": 128, "Mesh/Rectangle/Cells Y": 2,
                "Mesh/Rectangle/Height": 20,
                FAULT + "Slip Rate": f"t < {rise} ? {V} * (1 - cos(_pi * t / {rise})) / 2 : {V}",
                "Boundary Conditions/Left/Type": "Absorbing",
                "Boundary Conditions/Right/Type": "Absorbing",
                "Time Stepping/Final Time": 0.6, "Time Stepping/Largest Step": 0.1,
                "Output/Receivers/Off Fault/left": "{100, 10}",
                "Output/Receivers/Off Fault/right": "{900, 10}",
                "Output/Fault History/Every n Steps": 1}
        removed = [f"Boundary Conditions/{name}/{entry}" for name in ("Left", "Right")
                   for entry in ("Direction", "Velocity")]
        removed += ["Boundary Conditions/Wall", "Boundary Conditions/Other Wall"]
        folder = asperity_run.run_to_end("waves", DECK, *(
            word for path in removed for word in ("--remove", path)), *settings(
                deck, "Time Stepping/Richardson/Tolerance=1e-3"))
        fault = asperity_run.series(folder / "fault.h5")
        rate, traction = fault["fields/slip_rate"][-1], fault["fields/traction"][-1]
        self.assertLess(numpy.abs(rate - V).max(), 1e-9)
        self.assertLess(numpy.abs(traction / (-G * V / (2 * cs)) - 1).max(), 1e-2)
        receivers = asperity_run.series(folder / "receivers.h5")
        velocity = receivers["off_fault/fields/velocity"][-1].ravel()
        self.assertLess(numpy.abs(numpy.abs(velocity) - V / 2).max(), 1e-2 * V)
        self.assertLess(velocity.prod(), 0)
        self.assertLess(abs(last(folder)["energy_defect"]), 1e-6 * last(folder)["boundary_work"])




if __name__ == "__main__":
    unittest.main()
