"""asperity-bench: rate problems with known solutions in three dimensions, solved and counted."""

import json
import pathlib
import subprocess
import unittest

import asperity_run

PROGRAM = asperity_run.PROGRAM.parent / "asperity-bench"
DECK = asperity_run.SOURCE / "xml" / "bp5_qd.xml"
FACTOR = "Mesh/Box/Cell Size Factor"


def bench(*arguments, ranks=1, timeout=300):
    words = [str(PROGRAM), *map(str, arguments)]
    if ranks > 1:
        words = [*asperity_run.MPIEXEC, str(ranks), *words]
    return subprocess.run(words, capture_output=True, text=True, timeout=timeout, check=False)


def scaling(ranks, *arguments):
    """The numbers of a run: meshes of 16 and 8 km cells on the fault, where Z does not couple the
    fault's tangents and a hierarchy has to be rebuilt for friction all the same."""
    output = pathlib.Path(f"scaling_{ranks}.json")
    output.unlink(missing_ok=True)
    result = bench("scaling", DECK, "--size-parameter", FACTOR, "--sizes", "8,4",
                   "--steps", "1e5,1", "--rupture-rate", "1", "--set",
                   "TNNMG/Linear Correction=MueLu", "--set",
                   "TNNMG/MueLu Correction/Hierarchy=Rebuild", "--output", output, *arguments,
                   ranks=ranks)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return result.stdout, json.loads(output.read_text())


class Scaling(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.table, cls.numbers = scaling(1)

    def solves(self, numbers):
        return [solve for mesh in numbers["meshes"] for solve in mesh["solves"]]

    def test_finds_the_known_solutions(self):
        solves = self.solves(self.numbers)
        self.assertEqual(len(solves), 2 * 2 * 3)
        for solve in solves:
            self.assertTrue(solve["converged"], solve)
            self.assertLess(solve["error"], 1e-4, solve)
            self.assertGreater(solve["v_cycles"], 0, solve)

    def test_finer_meshes_have_more_unknowns(self):
        coarse, fine = (mesh["unknowns"] for mesh in self.numbers["meshes"])
        self.assertGreater(fine, 2 * coarse)
        self.assertIn(f"{fine} unknowns", self.table)

    def test_two_ranks_need_as_many_iterations(self):
        # Gauss-Seidel is local to a rank, so what a loose correction leaves depends on the ranks,
        # and from rest a rupture is then reached on other ways: compared with tight ones.
        tight = ["--set", "TNNMG/Correction Tolerance=1e-4"]
        _, alone = scaling(1, *tight)
        _, numbers = scaling(2, *tight)
        self.assertEqual(numbers["ranks"], 2)
        for ours, theirs in zip(self.solves(alone), self.solves(numbers)):
            self.assertLessEqual(abs(ours["tnnmg_iterations"] - theirs["tnnmg_iterations"]), 1,
                                 (ours, theirs))
            self.assertLess(theirs["error"], 1e-4)


class Stretch(unittest.TestCase):
    def test_counts_the_steps_of_a_run(self):
        output = pathlib.Path("stretch.json")
        output.unlink(missing_ok=True)
        result = bench("steps", DECK, "--steps", "3", "--set", f"{FACTOR}=8", "--set",
                       "TNNMG/Linear Correction=MueLu", "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        numbers = json.loads(output.read_text())
        self.assertEqual(numbers["inertial"]["accepted"], 0)  # quasi-dynamic: no mass
        steps = numbers["quasi_static"]
        self.assertEqual(steps["accepted"], 3)
        self.assertGreaterEqual(steps["coupled_steps"], 3)
        self.assertGreater(steps["v_cycles"], 0)
        self.assertEqual(steps["rises"], 0)
        self.assertGreater(numbers["product_seconds"], 0)
        self.assertIn(f"{numbers['unknowns']} unknowns", result.stdout)


def stretch(ranks, steps=8):
    """The numbers of the first steps of BP5 with cells of 4 km, 7,299 unknowns."""
    output = pathlib.Path(f"stretch_{ranks}.json")
    output.unlink(missing_ok=True)
    result = bench("steps", DECK, "--steps", steps, "--set", f"{FACTOR}=2", "--set",
                   "TNNMG/Linear Correction=MueLu", "--output", output, ranks=ranks)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    return json.loads(output.read_text())


class Counts(unittest.TestCase):
    """What ranks send. The limits are a tenth above what was counted."""

    @classmethod
    def setUpClass(cls):
        cls.numbers = {ranks: stretch(ranks) for ranks in (1, 2, 4)}

    def each(self, ranks, work, what, number):
        numbers = self.numbers[ranks]
        return numbers["messages"][work][what] / numbers["quasi_static"][number]

    def all(self, ranks, what):
        return sum(count[what] for work, count in self.numbers[ranks]["messages"].items()
                   if work != "set-up of step sizes") / self.numbers[ranks]["quasi_static"][
                       "coupled_steps"]

    def test_ranks_hardly_change_the_iterations(self):
        alone = self.numbers[1]["quasi_static"]
        for ranks in (2, 4):
            steps = self.numbers[ranks]["quasi_static"]
            self.assertEqual(steps["coupled_steps"], alone["coupled_steps"])
            for count in ("tnnmg_iterations", "v_cycles"):
                self.assertLess(abs(steps[count] - alone[count]), 0.1 * alone[count], count)
            self.assertEqual(steps["rises"], 0)

    def test_a_coupled_step_takes_few_v_cycles(self):
        steps = self.numbers[1]["quasi_static"]
        self.assertLess(steps["v_cycles"], 1.1 * 13.3 * steps["coupled_steps"])
        self.assertLess(steps["tnnmg_iterations"], 1.1 * 4.33 * steps["coupled_steps"])

    def test_a_coupled_step_takes_few_products(self):
        # One for each iteration, and those of right sides and energies.
        steps = self.numbers[1]["quasi_static"]
        self.assertGreaterEqual(steps["products"], steps["tnnmg_iterations"])
        self.assertLess(steps["products"], 1.1 * 10 * steps["coupled_steps"])

    def test_one_rank_sends_nothing(self):
        self.assertEqual(self.all(1, "messages") + self.all(1, "bytes") +
                         self.all(1, "reductions"), 0)

    def test_a_v_cycle(self):
        self.assertLess(self.each(2, "V-cycles", "messages", "v_cycles"), 1.1 * 4.19)
        self.assertLess(self.each(2, "V-cycles", "bytes", "v_cycles"), 1.1 * 6960)
        # The coarsest level is on one rank.
        self.assertEqual(self.each(2, "V-cycles", "reductions", "v_cycles"), 0)

    def test_a_sweep_sends_the_columns_of_the_fault_alone(self):
        self.assertLess(self.each(2, "Gauss-Seidel sweeps", "messages", "tnnmg_iterations"),
                        1.1 * 6)
        self.assertLess(self.each(2, "Gauss-Seidel sweeps", "bytes", "tnnmg_iterations"),
                        1.1 * 784)
        self.assertLess(self.each(2, "Gauss-Seidel sweeps", "reductions", "tnnmg_iterations"), 1.1)

    def test_a_line_search_takes_one_reduction(self):
        self.assertLess(self.each(2, "line searches", "reductions", "tnnmg_iterations"), 1.1)

    def test_a_coupled_step(self):
        self.assertLess(self.all(2, "messages"), 1.1 * 95.8)
        self.assertLess(self.all(2, "bytes"), 1.1 * 133e3)
        self.assertLess(self.all(2, "reductions"), 1.1 * 41.2)


class Inertial(unittest.TestCase):
    """The first steps of TPV101 with cells of 800 m, from 1 to 31 ms. The limits are a tenth above
    what was counted."""

    def test_a_coupled_step(self):
        output = pathlib.Path("inertial.json")
        output.unlink(missing_ok=True)
        result = bench("steps", asperity_run.SOURCE / "xml" / "tpv101_3d.xml", "--steps", "12",
                       "--set", f"{FACTOR}=2", "--set", "TNNMG/Linear Correction=MueLu",
                       "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        numbers = json.loads(output.read_text())
        self.assertEqual(numbers["quasi_static"]["accepted"], 0)
        self.assertLessEqual(numbers["setups"], 7)  # one for each step size
        steps = numbers["inertial"]
        self.assertEqual((steps["accepted"], steps["rises"], steps["failures"]), (12, 0, 0))
        for count, expected in (("tnnmg_iterations", 2.44), ("v_cycles", 6.5), ("products", 8)):
            self.assertGreater(steps[count], 0)
            self.assertLess(steps[count], 1.1 * expected * steps["coupled_steps"], count)


class Comparison(unittest.TestCase):
    def test_a_rate_problem_takes_hardly_more_cycles_than_a_linear_one(self):
        output = pathlib.Path("comparison.json")
        output.unlink(missing_ok=True)
        result = bench("compare", DECK, "--steps", "4", "--set", f"{FACTOR}=2", "--set",
                       "TNNMG/Linear Correction=MueLu", "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        numbers = json.loads(output.read_text())["quasi_static"]
        self.assertEqual(numbers["count"], 4)
        self.assertLess(numbers["worst_error"], 1e-5)  # of the deck's relative tolerance
        self.assertGreater(numbers["linear_cycles"], 0)
        self.assertLess(numbers["rate_cycles"], 2 * numbers["linear_cycles"])
        self.assertLess(numbers["coupled_cycles"], 1.7 * numbers["rate_cycles"])

    def test_runs_on_one_rank_alone(self):
        result = bench("compare", DECK, "--steps", "1", ranks=2)
        self.assertEqual(result.returncode, 2)
        self.assertIn("one rank", result.stderr)


class BadInput(unittest.TestCase):
    def test_is_refused(self):
        cases = [(["scaling", DECK, "--sizes", "1"], "--steps"),
                 (["scaling", DECK, "--sizes", "1,x", "--steps", "1"], "--sizes x"),
                 (["scaling", DECK, "--sises", "1"], "'--sizes'"),
                 (["steps", DECK], "--steps"),
                 (["steps", DECK, "--steps", "1.5"], "--steps 1.5"),
                 (["compare", DECK], "--steps"),
                 (["scalding", DECK, "--sizes", "1", "--steps", "1"], "--help")]
        for words, part in cases:
            result = bench(*words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(part, result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
