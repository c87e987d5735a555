"""What a step of a simulation takes: rate problem and state in turns, on multigrid."""

import unittest

import asperity_run

DECK = asperity_run.SOURCE / "xml" / "bp5_qd.xml"


class Steps(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = asperity_run.run_to_end(
            "steps", DECK, "--set", "Mesh/Box/Cell Size Factor=2",
            "--set", "TNNMG/Linear Correction=Multigrid", "--set", "Time Stepping/Final Time=60")
        cls.rows = asperity_run.table(folder / "steps.csv")

    def total(self, name):
        return sum(row[name] for row in self.rows)

    def test_a_rate_problem_takes_fewer_than_two_iterations(self):
        # Solved one by one they take three.
        self.assertLess(self.total("tnnmg_iterations"), 2 * self.total("rate_problems"))
        self.assertEqual(self.total("energy_increases"), 0)

    def test_a_correction_takes_few_v_cycles(self):
        # To a tenth of the residual; they take 3.1. The limit was chosen after that.
        self.assertLess(self.total("v_cycles"), 4 * self.total("tnnmg_iterations"))
        self.assertGreater(self.total("v_cycles"), 0)

    def test_steps_are_compared_in_pairs(self):
        self.assertLess(self.total("coupled_steps"), 2 * len(self.rows))


if __name__ == "__main__":
    unittest.main()
