"""Tests can only set entries that the manual has."""

import unittest

import asperity_run


class Settings(unittest.TestCase):
    def test_of_the_manual_are_arguments(self):
        self.assertEqual(asperity_run.settings("Mesh/Refinements=1", {"Bulk/Density": 2700}),
                         ["--set", "Mesh/Refinements=1", "--set", "Bulk/Density=2700"])

    def test_may_have_names_that_a_deck_chooses(self):
        for entry in ("Names/width", "Bulk/Density/upper", "Bulk/Regions/crust/Viscosity",
                      "Boundary Conditions/Any Name/Type", "Output/Receivers/On Fault/a place",
                      "TNNMG/Multigrid/MueLu/coarse: type", "Friction/Pore Pressure/Wells/w/Rate"):
            asperity_run.settings({entry: 1})

    def test_of_another_name_are_refused(self):
        for entry in ("Friction/Lenght", "Frictoin/L", "Mesh/Refinements/upper", "Refinements",
                      "Boundary Conditions/Type", "Bulk/Density/upper/x", "Bulk/Elastic Range"):
            with self.subTest(entry), self.assertRaisesRegex(ValueError, entry):
                asperity_run.settings({entry: 1})

    def test_of_a_plugin_are_named(self):
        entry = "Bulk/Elastic Range"
        self.assertEqual(asperity_run.settings({entry: 1}, of_plugin=(entry,)),
                         ["--set", f"{entry}=1"])
        with self.assertRaisesRegex(ValueError, "Hardening"):
            asperity_run.settings("Bulk/Hardening Modulus=1", of_plugin=(entry,))

    def test_have_a_value(self):
        with self.assertRaisesRegex(ValueError, "'Friction/L' has no value"):
            asperity_run.settings("Friction/L")


if __name__ == "__main__":
    unittest.main()
