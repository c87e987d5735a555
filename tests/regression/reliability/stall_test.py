"""A run that does not get ahead says so while it runs, and ends; a number that is lost is named."""

import itertools
import unittest

import asperity_run
import faults
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
        self.assertIn("WARNING: The last 100 steps", log)
        self.assertIn("The run has ended: At t = ", log)
        self.assertEqual(len(asperity_run.table(folder / "steps.csv")), 120)
        self.assertTrue((folder / "checkpoint.h5").exists())

    def test_lawless_friction_ends(self):
        folder = runs.fresh("lawless")
        result = asperity_run.run(*COARSE, *runs.settings(
            "Friction/L=1e-300", "Time Stepping/Most Forced Steps=150"), "--output", folder,
            timeout=100)
        runs.assert_one_message(self, result, runs.SOLVE, "did not meet the tolerance")

    def test_a_reference_slip_rate_beyond_all_rates(self):
        """The state adapts, in small steps; then the run gets ahead."""
        folder = asperity_run.run_to_end("reference", *COARSE, *runs.settings(
            "Friction/Reference Slip Rate=1e10", "Time Stepping/Final Time=1",
            "Time Stepping/Most Forced Steps=150"))
        self.assertNotIn("WARNING: The last", (folder / "run.log").read_text())
        sizes = [row["step_size"] for row in asperity_run.table(folder / "steps.csv")]
        self.assertGreater(max(sizes), 100 * sizes[0])

    def test_a_largest_step_beyond_all_numbers(self):
        result = asperity_run.run(*COARSE, *runs.settings("Time Stepping/Largest Step=1e308"),
                                  "--output", runs.fresh("largest"))
        runs.assert_one_message(self, result, runs.INPUT, "Smallest Step", "1e+308")


def on_ranks(cases):
    """Each case on 1 and on 2 ranks; in the short form, taken by turns on 1 and on 2."""
    for index, case in enumerate(cases):
        for ranks in (1, 2) if faults.is_long() else (1 + index % 2,):
            yield ranks, case


class LostNumbers(unittest.TestCase):
    """A field of the deck that is no number any more after a second, or far too large a one."""

    def run_with(self, ranks, *changes):
        folder = runs.fresh("lost")
        result = asperity_run.run(*COARSE, *runs.settings(
            "TNNMG/Linear Correction=Multigrid", *changes), "--output", folder, ranks=ranks)
        return folder, result

    def test_loads_that_are_no_numbers(self):
        """What the deck says is at fault, whenever that is found."""
        loads = (("Boundary Conditions/Backstop/Velocity", "5e-5"),
                 ("Friction/Normal Stress", "4200 * x"),
                 ("Friction/Shear Traction", "-(0.7 * 4200 * x + 10)"))
        values = (("(t - t) / (t - t)", "nan"), ("1 / (t - t)", "inf"))
        for ranks, ((name, before), (value, text)) in on_ranks(itertools.product(loads, values)):
            with self.subTest(name=name, value=text, ranks=ranks):
                folder, result = self.run_with(ranks, f"{name}=t < 1 ? {before} : {value}")
                runs.assert_one_message(self, result, runs.INPUT, name.replace("/", " / "),
                                        text, "at (x, y, z) = (", "t = ")
                if (folder / "steps.csv").exists():  # the first trial step may go as far
                    runs.assert_finite_checkpoint(self, folder)

    def test_sums_of_loads(self):
        """Each load is a number, what they do to the body, or the square of it, is none."""
        loads = "the sum of loads became "
        for ranks, (change, steps, piece) in on_ranks((
                ("Boundary Conditions/Backstop/Velocity=t < 1 ? 5e-5 : 1e308", 20, loads),
                ("Bulk/Gravitational Acceleration=1e308", 0, loads),
                ("Initial State/Velocity X=1e308", 0, "velocity became 1e+308 at node "))):
            with self.subTest(change=change, ranks=ranks):
                folder, result = self.run_with(ranks, change)
                runs.assert_one_message(self, result, runs.SOLVE, "Step ", "t = ", piece)
                self.assertRegex(result.stderr, r"became -?(inf|nan|\d.*e\+30\d) at node")
                self.assertGreaterEqual(len(asperity_run.table(folder / "steps.csv")), steps)
                if steps > 0:
                    runs.assert_finite_checkpoint(self, folder)

    def test_loads_too_large_to_compute_with(self):
        """Numbers whose squares are none."""
        for ranks, (change, value) in on_ranks((
                ("Boundary Conditions/Backstop/Velocity=t < 1 ? 5e-5 : 1e300 * t", "e+3"),
                ("Friction/Shear Traction=t < 1 ? -(0.7 * 4200 * x + 10) : 1e200", "e+1"))):
            with self.subTest(change=change, ranks=ranks):
                folder, result = self.run_with(ranks, change)
                runs.assert_one_message(self, result, runs.SOLVE, "Step ", "t = ",
                                        "a rate problem did not converge", " became ", value,
                                        " at node ", "correct it: --restart-from")
                runs.assert_finite_checkpoint(self, folder)

    def test_fields_that_do_not_change_in_time(self):
        """Time in them is refused."""
        for change, piece in (("Friction/a=t < 1 ? 0.01 : 0", "Friction / a depends on t"),
                              ("Bulk/Gravitational Acceleration=t < 1 ? 9.81 : 0",
                               "Gravitational Acceleration = 't < 1 ? 9.81 : 0' is a text")):
            _, result = self.run_with(1, change)
            runs.assert_one_message(self, result, runs.INPUT, piece)


if __name__ == "__main__":
    unittest.main()
