"""Multigrid on 1 to 16 ranks: neither its iterations nor its coarsest level grow with them."""

import json
import pathlib
import subprocess
import unittest

import asperity_run

PROGRAM = asperity_run.PROGRAM.parent / "asperity-bench"
DECK = asperity_run.SOURCE / "xml" / "bp5_qd.xml"


def stretch(ranks):
    """The numbers of the first steps of BP5 with cells of 4 km, 7,299 unknowns."""
    output = pathlib.Path(f"ranks_{ranks}.json")
    output.unlink(missing_ok=True)
    words = [*asperity_run.MPIEXEC, str(ranks), str(PROGRAM), "steps", str(DECK), "--steps", "6",
             "--set", "Mesh/Box/Cell Size Factor=2", "--set", "TNNMG/Linear Correction=MueLu",
             "--output", str(output)]
    result = subprocess.run(words, capture_output=True, text=True, timeout=1500, check=False)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return json.loads(output.read_text())


class ManyRanks(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.numbers = {ranks: stretch(ranks) for ranks in (1, 2, 4, 8, 16)}

    def test_ranks_hardly_change_the_iterations(self):
        alone = self.numbers[1]["quasi_static"]
        for ranks, numbers in self.numbers.items():
            steps = numbers["quasi_static"]
            self.assertEqual(steps["coupled_steps"], alone["coupled_steps"])
            self.assertEqual(steps["rises"], 0)
            for count in ("tnnmg_iterations", "v_cycles"):
                self.assertLess(abs(steps[count] - alone[count]), 0.1 * alone[count],
                                (ranks, count))

    def test_the_coarsest_solve_is_on_one_rank(self):
        for ranks in (2, 4, 8, 16):
            self.assertEqual(self.numbers[ranks]["messages"]["V-cycles"]["reductions"], 0, ranks)

    def test_messages_of_a_v_cycle(self):
        # The limits are a tenth above what was counted.
        for ranks, most in ((2, 4.2), (4, 12.7), (8, 19.9), (16, 50.3)):
            messages = self.numbers[ranks]["messages"]["V-cycles"]["messages"]
            v_cycles = self.numbers[ranks]["quasi_static"]["v_cycles"]
            self.assertLess(messages, 1.1 * most * v_cycles, ranks)


if __name__ == "__main__":
    unittest.main()
