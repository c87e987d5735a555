"""What a run says of its deck before its first step: which way the fault slips, how fast waves
are, and whether the forces balance."""

import json
import subprocess
import unittest

import asperity_run
from asperity_run import settings

SQUARE = asperity_run.SOURCE / "tests" / "regression" / "bad_input" / "square.xml"
STATUS = asperity_run.PROGRAM.with_name("asperity-status")
FAULT = "Boundary Conditions/Fault"
QUASI_DYNAMIC = "Bulk/Dynamics=Quasi-dynamic"
# Without a free surface gravity, or the axis y, says where up is.
WITHOUT_SURFACE = ["--remove", "Boundary Conditions/Side"]
ANTIPLANE = [*settings("Bulk/Model=Antiplane"), "--remove", "Bulk/Poisson's Ratio",
             "--remove", "Boundary Conditions/Drive/Direction"]


def lines_of(*arguments):
    """What --validate prints."""
    result = asperity_run.run(*arguments, "--validate")
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout.splitlines()


def two_sided(place):
    """The square with a fault inside, at this place."""
    return settings(f"Mesh/Faults/main={place}", f"{FAULT}/Boundary=main",
                    f"{FAULT}/Type=Two-Sided Fault")


class SenseOfSlip(unittest.TestCase):
    """Of a slip rate of the plates, and of the same with the other sign."""

    def assert_senses(self, arguments, plus, forwards, backwards):
        for rate, sense in (("1e-09", forwards), ("-1e-09", backwards)):
            with self.subTest(rate):
                lines = lines_of(SQUARE, *arguments, *settings(f"{FAULT}/Plate Rate={rate}"))
                self.assertIn(f"Fault 'main': its plus side lies towards {plus}: {forwards}.",
                              lines)
                self.assertIn(f"The plates slip along it at {rate} m/s on the average: {sense}.",
                              lines)

    def test_of_a_level_fault(self):
        """The upper side is plus; who looks up at it from below has +x at the right."""
        self.assert_senses(two_sided("abs(y - 0.5) < 1e-6"),
                           "(0, 1); positive slip moves it along (1, 0)",
                           "right lateral in a map", "left lateral in a map")

    def test_of_faults_that_dip(self):
        """The hanging wall is plus: where it moves down, the fault is normal."""
        inside = "x > 0.2 && x < 0.8"
        self.assert_senses(two_sided(f"abs(x + y - 1) < 1e-6 && {inside}"),
                           "(0.71, 0.71); positive slip moves it along (0.71, -0.71)",
                           "a normal fault in a section, right lateral in a map",
                           "a thrust in a section, left lateral in a map")
        self.assert_senses(two_sided(f"abs(x - y) < 1e-6 && {inside}"),
                           "(-0.71, 0.71); positive slip moves it along (0.71, 0.71)",
                           "a thrust in a section, right lateral in a map",
                           "a normal fault in a section, left lateral in a map")

    def test_under_gravity_nothing_is_lateral(self):
        """The plane is a section then, and the direction of gravity says where up is."""
        gravity = settings("Bulk/Gravitational Acceleration=9.81",
                           "Boundary Conditions/Hold/Boundary=bottom",
                           "Boundary Conditions/Hold/Type=Fixed")
        inside = "x > 0.2 && x < 0.8"
        self.assert_senses([*two_sided(f"abs(x + y - 1) < 1e-6 && {inside}"), *gravity,
                            *WITHOUT_SURFACE],
                           "(0.71, 0.71); positive slip moves it along (0.71, -0.71)",
                           "a normal fault", "a thrust")
        inclined = settings("Bulk/Gravity Direction={0.27, -1}")
        self.assert_senses([*two_sided("abs(y - 0.5) < 1e-6"), *gravity, *inclined,
                            *WITHOUT_SURFACE],
                           "(0, 1); positive slip moves it along (1, 0)",
                           "a normal fault", "a thrust")

    def test_across_the_plane(self):
        """Seen from above, who looks along +x has +z at the right."""
        upright = two_sided("abs(x - 0.5) < 1e-6 && y > 0.2 && y < 0.8")
        self.assert_senses([*upright, *ANTIPLANE, *WITHOUT_SURFACE],
                           "(1, 0); positive slip moves it along +z, out of the plane",
                           "right lateral seen from above", "left lateral seen from above")

    def test_of_the_first_model(self):
        """Its one body is plus; it has no plates to slip."""
        lines = lines_of(asperity_run.SOURCE / "examples" / "first_model" / "plane.xml")
        self.assertIn("Fault 'fault': its plus side, the body, lies towards (1, 0); positive slip "
                      "moves it along +z, out of the plane: right lateral seen from above.", lines)
        self.assertNotIn("The plates slip", "\n".join(lines))


class Speeds(unittest.TestCase):
    """G = 22.5 GPa and 2500 kg/m^3: c_s = 3 km/s, and G / c_s = 7.5 MPa s/m. With Poisson's ratio
    0.3 lambda = 1.5 G, and c_p = sqrt(3.5) c_s."""

    STONE = settings("Bulk/Density=2500", "Bulk/Shear Modulus=2.25e10")
    OF_STRESS = ". Normal stress at the start: 10000 Pa."

    def assert_said(self, arguments, text):
        line, = [each for each in lines_of(SQUARE, *self.STONE, *arguments) if "c_s" in each]
        self.assertTrue(line.endswith(f" c_s = {text}{self.OF_STRESS}"), line)

    def test_in_plane(self):
        ratio = settings("Bulk/Poisson's Ratio=0.3")
        speeds = "3000 m/s, pressure waves at c_p = 5612.49 m/s"
        self.assert_said(ratio, speeds)
        self.assert_said([*ratio, *settings(QUASI_DYNAMIC)],
                         f"{speeds}; radiation damping eta = 7.5e+06 Pa s/m")

    def test_with_two_sides_that_move(self):
        """Half as much. Between two bodies it is Z1 Z2 / (Z1 + Z2), here of 7.5 and 5 MPa s/m."""
        of_each = "3000 m/s; radiation damping eta = 3.75e+06 Pa s/m"
        mirrored = settings(QUASI_DYNAMIC, f"{FAULT}/Type=Antisymmetric Fault")
        self.assert_said([*ANTIPLANE, *mirrored], of_each)
        fault = [*ANTIPLANE, *two_sided("abs(y - 0.5) < 1e-6"), *settings(QUASI_DYNAMIC)]
        self.assert_said(fault, of_each)
        unlike = settings("Bulk/Shear Modulus=y > 0.5 ? 2.25e10 : 1e10")
        said = "\n".join(lines_of(SQUARE, *self.STONE, *fault, *unlike))
        self.assertIn(f"; radiation damping eta = 3e+06 Pa s/m{self.OF_STRESS}\n", said)

    def test_that_vary_along_the_fault(self):
        """Four times the density: half the speed, and twice the damping."""
        self.assert_said([*ANTIPLANE, *settings(
            QUASI_DYNAMIC, "Bulk/Density=x < 0.5 ? 2500 : 10000")],
                         "1500 to 3000 m/s; radiation damping eta = 7.5e+06 to 1.5e+07 Pa s/m")


class OutOfBalance(unittest.TestCase):
    """BP1 on cells of 5 km, all of it with the largest a, so that the traction of the deck is that
    of steady sliding."""

    DECK = [asperity_run.SOURCE / "xml" / "bp1_qd.xml", *settings(
        "Mesh/Rectangle/Width=200e3", "Mesh/Rectangle/Height=200e3",
        "Mesh/Rectangle/Lower Left={0, -200e3}", "Mesh/Rectangle/Cells X=8",
        "Mesh/Rectangle/Cells Y=5", "Mesh/Rectangle/Cell Size=5e3 + 0.5 * max(x, -y)",
        "Friction/a=0.025", "Output/Receivers/Enabled=false",
        "Time Stepping/Final Time=1")]
    STEADY, IN_MPA = "Initial State/State=Steady", "Friction/Shear Traction=26.54612"

    def warnings_of(self, *changes):
        """Those of the log, and the topics that asperity-status tells, but for cells that are large
        for a front of slip."""
        folder = asperity_run.run_to_end("balance", *self.DECK, *settings(*changes))
        log = (folder / "run.log").read_text().splitlines()
        told = subprocess.run([STATUS, folder, "--json"], text=True, capture_output=True,
                              check=True).stdout
        return ([line for line in log
                 if line.startswith("WARNING: ") and "The zone over which friction" not in line],
                [warning["topic"] for warning in json.loads(told)["warnings"]
                 if warning["topic"] != "front of slip"])

    def test_a_traction_in_other_units(self):
        warnings, topics = self.warnings_of(self.STEADY, self.IN_MPA)
        self.assertEqual(topics, ["start out of balance"])
        warning, = warnings
        self.assertRegex(warning, r"^WARNING: The run starts out of balance: 0\.99999\d of the "
                                  r"forces are not balanced \(at most 0\.01 is usual\)\.")
        for advice in ("Check Friction / Shear Traction, whose unit is Pa",
                       "choose Initial State / State = Stress Balance."):
            self.assertIn(advice, warning)

    def test_a_start_that_balances(self):
        """In Pa, or with the state of friction that balances whatever traction there is."""
        self.assertEqual(self.warnings_of(self.STEADY), ([], []))
        self.assertEqual(self.warnings_of("Initial State/State=Stress Balance", self.IN_MPA),
                         ([], []))


if __name__ == "__main__":
    unittest.main()
