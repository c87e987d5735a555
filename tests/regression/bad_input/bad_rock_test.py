"""Rock that flows or yields, spoilt: one clear message and exit status 2, on 1 and 2 ranks."""

import pathlib
import unittest

import asperity_run
from bad_input_test import DECK, Case, settings


class Rock(Case):
    """The region 'mantle' is the upper half."""

    def assert_rock_refused(self, law, *pieces):
        rock = {f"Bulk/Regions/mantle/{name}": value for name, value in law.items()}
        for ranks in (1, 2):
            with self.subTest(law, ranks=ranks):
                self.assert_refused([DECK, *settings("Mesh/Regions/mantle=y > 0.5", rock)],
                                    *pieces, ranks=ranks)

    def test_a_viscosity_below_zero(self):
        self.assert_rock_refused({"Law": "Maxwell", "Viscosity": -1e6},
                                 "Asperity / Bulk / Regions / mantle / Viscosity = -1e+06",
                                 "outside (0, inf)")
        self.assert_rock_refused(
            {"Law": "Burgers", "Viscosity": 1e6, "Transient Viscosity": "0.6 - y",
             "Transient Shear Modulus": 1e6},
            "Asperity / Bulk / Regions / mantle / Transient Viscosity", "outside (0, inf)", "y")

    def test_a_relaxation_that_no_step_follows(self):
        """G is 1e6 Pa, the smallest step 1e-4 s."""
        for viscosity, is_refused in ((0.09, True), (0.11, False)):
            rock = settings("Bulk/Law=Maxwell", f"Bulk/Viscosity={viscosity}")
            if is_refused:
                self.assert_refused([DECK, *rock],
                                    "Asperity / Bulk: a relaxation time, 9e-08 s, is less than a "
                                    "thousandth of the smallest step, 0.0001 s", "Pa s")
            else:
                self.assert_done(DECK, *rock, "--validate")
        self.assert_rock_refused({"Law": "Maxwell", "Viscosity": 1e-3}, "1e-09 s")

    def test_a_stress_that_the_rock_does_not_bear(self):
        """It grows with y: the cell of the largest y is named, whose centroid is 1/12 below 1."""
        self.assert_refused(
            [DECK, *settings("Bulk/Law=Von Mises", "Bulk/Shear Strength=2e3",
                             "Bulk/Initial Stress/XY=3e3 * y")],
            "Asperity / Bulk: at the start the rock at (",
            ", 0.9166666667) bears a shear stress of 2750 Pa, but it yields at 2000 Pa")

    def test_a_stress_at_the_start_that_no_rock_takes(self):
        stress = settings("Bulk/Initial Stress/XY=3e3")
        for law in ([], settings("Bulk/Law=Maxwell", "Bulk/Viscosity=1e6")):
            for ranks in (1, 2):
                self.assert_refused(
                    [DECK, *stress, *law], "Asperity / Bulk / Initial Stress has no effect",
                    "'Drucker-Prager'", "Friction / Shear Traction", ranks=ranks)
        self.assert_done(DECK, *stress, *settings("Bulk/Law=Von Mises", "Bulk/Shear Strength=1e4"),
                         "--validate")

    def test_a_stress_that_does_not_fit_that_of_the_fault(self):
        """A warning where most of the fault bears another stress than the rock beside it."""
        def warning(fault, rock, ranks=1):
            deck = settings("Bulk/Law=Von Mises", "Bulk/Shear Strength=1e9",
                            f"Friction/Shear Traction={fault}",
                            {f"Bulk/Initial Stress/{name}": value for name, value in rock.items()})
            result = asperity_run.run(DECK, *deck, "--validate", ranks=ranks)
            self.assertEqual(result.returncode, 0, result.stderr)
            return "\n".join(line for line in result.stdout.splitlines()
                             if "does not fit the stress on the fault" in line)

        for ranks in (1, 2):
            self.assertIn("over 100 % of it", warning(3e3, {"XY": -3e3, "YY": -1e4}, ranks))
        self.assertIn("where the rock has a shear traction of -3000 Pa and a normal stress of "
                      "10000 Pa, and the fault a shear traction of 3000 Pa and a normal stress of "
                      "10000 Pa", warning(3e3, {"XY": -3e3, "YY": -1e4}))
        self.assertIn("WARNING", warning(3e3, {"XY": 3e3, "YY": -1e3}))
        self.assertIn("WARNING", warning(3e3, {"YY": -1e4}))
        patch = "3e3 * (abs(x - 0.5) < 0.2 ? 2 : 1)"
        for fault, rock in ((3e3, {"XY": 3e3, "YY": -1e4}), (3e3, {"XY": 3e3}),
                            ("3e3 * (1 + x^2)", {"XY": "3e3 * (1 + x^2)", "YY": "-1e4"}),
                            (patch, {"XY": 3e3, "YY": -1e4})):
            self.assertEqual(warning(fault, rock), "")

    def test_a_region_without_a_law(self):
        self.assert_rock_refused({"Viscosity": 1e6},
                                 "Asperity / Bulk / Regions / mantle / Viscosity is unknown here",
                                 "Law = Burgers or Law = Maxwell")
        overlay = pathlib.Path("empty.xml")
        overlay.write_text('<ParameterList name="Asperity"><ParameterList name="Bulk">'
                           '<ParameterList name="Regions"><ParameterList name="mantle"/>'
                           "</ParameterList></ParameterList></ParameterList>")
        self.assert_refused([DECK, *settings("Mesh/Regions/mantle=y > 0.5"), "--overlay", overlay],
                            "Asperity / Bulk / Regions / mantle / Law is missing")


if __name__ == "__main__":
    unittest.main()
