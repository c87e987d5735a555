"""A body without a fault under tractions, whose stress is uniform: linear displacements that cells
have exactly, at the start and while the tractions change."""

import math
import pathlib
import unittest

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("block.xml")
G, POISSON = 1e6, 0.3
CONDITIONS = "Boundary Conditions/"
ROUNDING = 1e-10  # of the largest value


def on(name, boundary, **entries):
    """A condition with a traction."""
    return {f"{CONDITIONS}{name}/{entry.replace('_', ' ')}": value for entry, value in
            {"Boundary": boundary, "Type": "Prescribed Traction", **entries}.items()}


def run(name, *changes, ranks=1, remove=()):
    removals = [word for path in remove for word in ("--remove", path)]
    folder = asperity_run.run_to_end(name, DECK, *removals, *asperity_run.settings(*changes),
                                     ranks=ranks)
    return folder, asperity_run.series(folder / "volume.h5")


def plane_strain(sxx, syy):
    """The strains along x and y."""
    return (((1 - POISSON) * sxx - POISSON * syy) / (2 * G),
            ((1 - POISSON) * syy - POISSON * sxx) / (2 * G))


class UniformStress(unittest.TestCase):
    def agree(self, found, expected):
        self.assertLess(numpy.abs(found - expected).max(), ROUNDING * numpy.abs(expected).max())

    def test_plane_strain(self):
        for ranks in (1, 2, 4):
            folder, volume = run(f"plane_{ranks}", on("Push", "top", Pressure="400 * (1 + t)"),
                                 on("Pull", "right", Traction_X="1e3 + 500 * t"), ranks=ranks)
            x, work = volume["geometry/coordinates"], 0
            for row, t in enumerate(volume["time"]):
                pull, push = 1e3 + 500 * t, 400 * (1 + t)
                exx, eyy = plane_strain(pull, -push)
                with self.subTest(ranks=ranks, t=t):
                    self.agree(volume["fields/displacement"][row],
                               numpy.stack((exx * x[:, 0], eyy * x[:, 1]), axis=1))
                    stress = volume["fields/stress"][row]
                    scale = 1e-9 * pull
                    self.assertLess(numpy.abs(stress[:, 0] - pull).max(), scale)
                    self.assertLess(numpy.abs(stress.min(axis=1) + push).max(), scale)
            # all that loads do is elastic: the energy grows from that of the start
            first, last = (0.5 * 2 * (pull * e[0] - push * e[1]) for pull, push, e in
                           ((1e3, 400, plane_strain(1e3, -400)),
                            (1.5e3, 800, plane_strain(1.5e3, -800))))
            steps = asperity_run.table(folder / "steps.csv")
            self.assertAlmostEqual(steps[-1]["elastic_energy"] / last, 1, delta=1e-9)
            self.assertAlmostEqual(steps[-1]["load_work"] / (last - first), 1, delta=1e-9)
            self.assertLess(abs(steps[-1]["energy_defect"]), 1e-9 * last)

    def test_antiplane(self):
        sides = {f"{CONDITIONS}Wall/Type": "Fixed", "Bulk/Model": "Antiplane"}
        _, volume = run("antiplane", sides, on("Pull", "right", Traction_Z=200),
                        remove=(f"{CONDITIONS}Pull/Traction X",))
        x = volume["geometry/coordinates"]
        self.agree(volume["fields/displacement"][-1].ravel(), 200 / G * x[:, 0])

    def test_space(self):
        box = {"Mesh/Type": "Box", "Mesh/Box/Size": "{2, 1, 1}", "Mesh/Box/Cells X": 3,
               "Mesh/Box/Cells Y": 2, "Mesh/Box/Cells Z": 2, "Bulk/Model": "Solid",
               f"{CONDITIONS}Side/Boundary": "back", f"{CONDITIONS}Side/Type": "Sliding Wall"}
        # the same stress from components and from pressures
        for name, tractions in (("components", (on("Push", "top", Traction_Y=-400),
                                                on("Front", "front", Traction_Z=100))),
                                ("pressures", (on("Push", "top", Pressure=400),
                                               on("Front", "front", Pressure=100)))):
            _, volume = run(f"space_{name}", box, *tractions)
            x, stress = volume["geometry/coordinates"], numpy.array([1e3, -400, -100])
            strain = (stress - POISSON * (stress.sum() - stress)) / (2 * G * (1 + POISSON))
            with self.subTest(name):
                origin = numpy.array([0, 0, x[:, 2].max()])  # the wall
                self.agree(volume["fields/displacement"][-1], strain * (x - origin))


class Strip(unittest.TestCase):
    def test_a_lake_on_a_half_plane(self):
        """The middle of a strip of pressure sinks more than a place at a distance x by
        (1 - nu) p / (pi G) [(x + a) ln(x + a) - (x - a) ln(x - a) - 2 a ln(a)]."""
        folder = asperity_run.run_to_end("lake", asperity_run.SOURCE / "xml" / "lake_2d.xml",
                                         *asperity_run.settings(
            {"Output/Surface History/Precision": "Double",  # and sides four times as far away
             "Mesh/Rectangle/Lower Left": "{-1280e3, -1280e3}", "Mesh/Rectangle/Width": 2560e3,
             "Mesh/Rectangle/Height": 1280e3}))
        surface = asperity_run.series(folder / "surface.h5")
        x, up = surface["geometry/coordinates"][:, 0], surface["fields/displacement"][-1][:, 1]
        a, pressure = 30e3, 1000 * 9.81 * 50
        for far in (60e3, 100e3):
            sinks = 0.75 * pressure / (math.pi * 40e9) * (
                (far + a) * math.log(far + a) - (far - a) * math.log(far - a)
                - 2 * a * math.log(a))
            found = up[numpy.abs(x - far).argmin()] - up[numpy.abs(x).argmin()]
            print(f"a lake: the middle sinks by {found:.4f} m more than at {far:g} m, in a half "
                  f"plane by {sinks:.4f} m", flush=True)
            self.assertAlmostEqual(found / sinks, 1, delta=0.02)


class Refused(unittest.TestCase):
    def refuse(self, changes, *pieces, remove=()):
        removals = [word for path in remove for word in ("--remove", path)]
        result = asperity_run.run(DECK, *asperity_run.settings(changes), *removals, "--validate")
        self.assertEqual(result.returncode, 2, result.stdout)
        for piece in pieces:
            self.assertIn(piece, result.stderr)

    def test_a_static_solution_without_support(self):
        removed = (f"{CONDITIONS}Wall",)
        self.refuse({}, "nothing stops or resists the body", remove=removed)
        self.refuse({"Bulk/Dynamics": "Inertial"}, "nothing stops or resists the body",
                    "static displacement", "Displacement = Zero", remove=removed)

    def test_components_that_the_model_does_not_have(self):
        self.refuse({f"{CONDITIONS}Pull/Traction Z": 1}, "Pull / Traction Z has no effect",
                    "plane strain")
        self.refuse({"Bulk/Model": "Antiplane"}, "Pull / Traction X has no effect",
                    "antiplane")

    def test_no_traction(self):
        self.refuse({}, "Pull (Prescribed Traction) says nothing",
                    remove=(f"{CONDITIONS}Pull/Traction X",))

    def test_two_conditions_on_a_traction(self):
        self.refuse({f"{CONDITIONS}Free/Boundary": "right",
                     f"{CONDITIONS}Free/Type": "Free Surface"}, "contradicts")

    def test_friction_without_a_fault(self):
        self.refuse({"Friction/Normal Stress": 1e6}, "Asperity / Friction has no effect",
                    "has no condition of Type")

    def test_a_restart_without_a_fault(self):
        folder = asperity_run.run_to_end("to_go_on", DECK)
        result = asperity_run.run("--restart", folder)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Restarted from", result.stdout)

    def test_a_run_from_another_one_without_a_fault(self):
        """Under a constant traction the block goes on in equilibrium."""
        first = asperity_run.run_to_end("first", DECK)
        second = asperity_run.run_to_end(
            "second", DECK, "--restart-from", first,
            *asperity_run.settings({"Time Stepping/Final Time": 2}))
        before, after = (asperity_run.series(folder / "volume.h5") for folder in (first, second))
        self.assertEqual((before["time"][-1], after["time"][-1]), (1, 2))
        last = before["fields/displacement"][-1]
        self.assertLess(numpy.abs(after["fields/displacement"][-1] - last).max(),
                        ROUNDING * numpy.abs(last).max())


if __name__ == "__main__":
    unittest.main()
