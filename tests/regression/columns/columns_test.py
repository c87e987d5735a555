"""The tables of a run in the plane have the columns that the manual lists; several_faults_test.py
has those of a run in space."""

import unittest

import asperity_run
from asperity_run import settings
from documented_columns import assert_documented

SQUARE = asperity_run.SOURCE / "tests" / "regression" / "bad_input" / "square.xml"
# Columns that only some models have, and what makes a model have them.
OF_OPENING = ("share_open", "contact_work")
OF_SOME_MODELS = ("share_on_floor", "inelastic_work", *OF_OPENING)
ALL = settings("Friction/Normal Stress Floor=1", "Bulk/Law=Von Mises", "Bulk/Shear Strength=1e9")
MAY_OPEN = settings({"Mesh/Faults/middle": "abs(y - 0.5) < 1e-6",
                     "Boundary Conditions/Fault/Boundary": "middle",
                     "Boundary Conditions/Fault/Type": "Two-Sided Fault",
                     "Boundary Conditions/Fault/Contact": "Unilateral",
                     "Boundary Conditions/Below/Boundary": "bottom",
                     "Boundary Conditions/Below/Type": "Fixed",
                     "Friction/Normal Stress Change": "Coupled",
                     "Output/Receivers/On Fault/middle": "{0.5, 0.5}"})


class Columns(unittest.TestCase):
    def test_of_elastic_rock(self):
        folder = asperity_run.run_to_end("elastic", SQUARE)
        assert_documented(self, folder, 2, without=OF_SOME_MODELS)

    def test_of_rock_that_yields_beside_a_floor_of_the_normal_stress(self):
        assert_documented(self, asperity_run.run_to_end("all", SQUARE, *ALL), 2,
                          without=OF_OPENING)

    def test_of_a_fault_that_may_open(self):
        folder = asperity_run.run_to_end("may_open", SQUARE, *MAY_OPEN)
        assert_documented(self, folder, 2, without=("inelastic_work",))
        self.assertIn("on_fault/fields/opening", asperity_run.series(folder / "receivers.h5"))


if __name__ == "__main__":
    unittest.main()
