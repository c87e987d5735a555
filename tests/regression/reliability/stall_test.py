"""A run that does not get ahead says so while it runs, and ends; a number that is lost is named."""

import unittest

import asperity_run
import runs

COARSE = [runs.DECK, *runs.settings("Mesh/Wedge/Cell Size=0.02", "Time Stepping/Final Time=600",
                                    "Output/Checkpoint Every n Steps=20")]


class Stalls(unittest.TestCase):
    def test_forced_steps_end_the_run(self):
        """No step meets such a tolerance."""
        folder = runs.fresh("forced")
        result = asperity_run.run(*COARSE, *runs.settings(
            "Time Stepping/Step Doubling/Tolerance=1e-14", "Time Stepping/Smallest Step=1e-3",
            "Time Stepping/Most Forced Steps=120"), "--output", folder)
        runs.assert_one_message(self, result, runs.SOLVE, "the last 120 steps",
                                "did not meet the tolerance", "Most Forced Steps")
        log = (folder / "run.log").read_text()
        self.assertIn("Warning: the last 100 steps", log)
        self.assertIn("The run has ended: At t = ", log)
        self.assertEqual(len(asperity_run.table(folder / "steps.csv")), 120)
        self.assertTrue((folder / "checkpoint.h5").exists())

    def test_lawless_friction_ends(self):
        folder = runs.fresh("lawless")
        result = asperity_run.run(*COARSE, *runs.settings(
            "Friction/L=1e-300", "Time Stepping/Most Forced Steps=150"), "--output", folder,
            timeout=100)
        runs.assert_one_message(self, result, runs.SOLVE, "did not meet the tolerance")

    def test_a_largest_step_beyond_all_numbers(self):
        result = asperity_run.run(*COARSE, *runs.settings("Time Stepping/Largest Step=1e308"),
                                  "--output", runs.fresh("largest"))
        runs.assert_one_message(self, result, runs.INPUT, "Smallest Step", "1e+308")


class LostNumbers(unittest.TestCase):
    def test_is_named(self):
        """A load without bound: what it does to the body is not a number any more."""
        folder = runs.fresh("lost")
        result = asperity_run.run(*COARSE, *runs.settings(
            "Boundary Conditions/Backstop/Velocity=t < 1 ? 5e-5 : 1e300 * t"),
            "--output", folder)
        self.assertEqual(result.returncode, runs.SOLVE, result.stderr)
        runs.assert_one_message(self, result, runs.SOLVE, "t = ")
        self.assertRegex(result.stderr, "is (-?inf|-?nan)|became (-?inf|-?nan)|did not converge")
        self.assertTrue((folder / "checkpoint.h5").exists())


if __name__ == "__main__":
    unittest.main()
