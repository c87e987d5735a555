"""Two faults that cross in the plane: ranks, restart, refinement, other solvers, inertia."""

import pathlib
import unittest

import asperity_run
import numpy
from asperity_run import settings

DECK = pathlib.Path(__file__).parent.parent / "orientation" / "two_faults.xml"
CROSSING = settings({"Mesh/Faults/level": "abs(y - 2000) < 1 && x > 999 && x < 3501",
                     "Boundary Conditions/Level/Boundary": "level",
                     "Boundary Conditions/Level/Type": "Two-Sided Fault",
                     "TNNMG/Relative Tolerance": 1e-11, "Coupling/Tolerance": 1e-9})


class Crossing(unittest.TestCase):
    def slip(self, name, *arguments, ranks=1):
        """Places, and slip at the end."""
        folder = asperity_run.run_to_end(name, DECK, *CROSSING, *arguments, ranks=ranks)
        return self.slip_in(folder)

    @staticmethod
    def field_in(folder, name):
        """Places, and a field at the end."""
        history = asperity_run.series(folder / "fault.h5")
        return history["geometry/coordinates"], history[f"fields/{name}"][-1].ravel()

    def slip_in(self, folder):
        return self.field_in(folder, "slip")

    def assert_same(self, expected, found):
        numpy.testing.assert_array_equal(found[0], expected[0])
        self.assertGreater(expected[1].max(), 0.01)
        numpy.testing.assert_allclose(found[1], expected[1], rtol=0,
                                      atol=1e-7 * expected[1].max())

    def test_both_slip_through_the_crossing(self):
        """Both have a node there, and slip in it is no less than half of the largest one."""
        places, slip = self.slip("whole")
        there = (places == [2000., 2000.]).all(axis=1)
        self.assertEqual(there.sum(), 2)
        self.assertGreater(slip[there].min(), 0.5 * slip.max())
        self.assertGreater(slip.min(), -1e-12)

    def test_values_by_the_names_of_faults(self):
        """Also at the crossing, where a formula has one value for both faults."""
        history = {"Output/Fault History/Fields": "{normal_stress}",
                   "Time Stepping/Final Time": 1e-3, "Time Stepping/Largest Step": 1e-3,
                   "Time Stepping/Smallest Step": 1e-3}
        for ranks in (1, 2):
            folder = asperity_run.run_to_end("by_name", DECK, *CROSSING, *settings(
                {"Friction/Normal Stress/upright": 1e5, "Friction/Normal Stress/level": "2e5 + x",
                 **history}), ranks=ranks)
            places, stress = self.field_in(folder, "normal_stress")
            there = (places == [2000., 2000.]).all(axis=1)
            self.assertEqual(sorted(stress[there]), [1e5, 2.02e5])
            on_upright = places[:, 0] == 2000.
            numpy.testing.assert_array_equal(stress[on_upright & ~there], 1e5)
            numpy.testing.assert_allclose(stress[~on_upright], 2e5 + places[~on_upright, 0])

    def test_a_list_of_names_that_is_wrong(self):
        for name, message in (("levle", "'levle' is neither a region of the mesh nor a fault. Did "
                                        "you mean 'level'?"),
                              ("upright", "has no value for the fault 'level'")):
            result = asperity_run.run(DECK, *CROSSING, *settings(
                {f"Friction/a/{name}": 0.01}), "--validate")
            self.assertEqual(result.returncode, 2)
            self.assertIn("Asperity / Friction / a", result.stderr)
            self.assertIn(message, result.stderr)

    def test_ranks(self):
        for more in ((), ("--set", "Mesh/Refinements=2")):
            expected = self.slip("one_rank", *more)
            for ranks in (2, 3):
                self.assert_same(expected, self.slip("ranks", *more, ranks=ranks))

    def test_solvers(self):
        expected = self.slip("one_rank")
        for correction in ("Direct", "Multigrid"):
            self.assert_same(expected, self.slip("other", *settings(
                {"TNNMG/Linear Correction": correction})))

    def test_restart(self):
        """On the same ranks to the last digit, on others up to the tolerance of the solver."""
        whole = self.slip("whole")
        for before, after in ((1, 1), (2, 2), (1, 2)):
            folder = asperity_run.run_to_end("parts", DECK, *CROSSING, *settings(
                {"Time Stepping/Final Time": 500}), ranks=before)
            asperity_run.go_on(folder, DECK, *CROSSING, ranks=after)
            found = self.slip_in(folder)
            self.assert_same(whole, found)
            if (before, after) == (1, 1):
                numpy.testing.assert_array_equal(found[1], whole[1])

    def test_with_inertia(self):
        """J falls in every step (asperity_run sees to it), and both faults slip."""
        places, slip = self.slip("inertia", *settings(
            {"Bulk/Dynamics": "Inertial", "Time Stepping/Final Time": 2,
             "Time Stepping/Largest Step": 0.25, "Time Stepping/Smallest Step": 0.25}))
        there = (places == [2000., 2000.]).all(axis=1)
        self.assertGreater(slip[there].min(), 0.01)


if __name__ == "__main__":
    unittest.main()
