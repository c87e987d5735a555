"""asperity-bench steps: what the first steps of a deck cost."""

import json
import pathlib
import subprocess
import unittest

import asperity_run
import time_limits

PROGRAM = asperity_run.PROGRAM.parent / "asperity-bench"
DECKS = asperity_run.SOURCE / "xml"


def bench(*arguments):
    return subprocess.run([str(PROGRAM), *map(str, arguments)], capture_output=True, text=True,
                          timeout=time_limits.seconds(100), check=False)


class Steps(unittest.TestCase):
    def check(self, deck, *settings):
        output = pathlib.Path("steps.json")
        output.unlink(missing_ok=True)
        result = bench("steps", DECKS / deck, "--steps", "3", *settings, "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        numbers = json.loads(output.read_text())
        self.assertEqual((numbers["ranks"], numbers["accepted"], numbers["energy_increases"]),
                         (1, 3, 0))
        self.assertGreaterEqual(numbers["coupled_steps"], 3)
        self.assertGreater(numbers["product_seconds"], 0)
        self.assertIn(f"{numbers['unknowns']} unknowns", result.stdout)
        self.assertIn("| 3 | ", result.stdout)
        self.assertRegex(result.stdout, r"\nline searches  ")  # the table of work
        return numbers

    def test_in_space(self):
        numbers = self.check("bp5_qd.xml", "--set", "Mesh/Box/Cell Size Factor=8", "--set",
                             "TNNMG/Linear Correction=Multigrid")
        self.assertGreater(numbers["v_cycles"], 0)

    def test_in_the_plane(self):
        self.check("wedge_2d.xml", "--set", "Mesh/Wedge/Height=0.3")


class Kernels(unittest.TestCase):
    def test_all_are_measured(self):
        output = pathlib.Path("kernels.json")
        output.unlink(missing_ok=True)
        result = bench("kernels", DECKS / "bp5_qd.xml", "--set",
                       "Mesh/Box/Cell Size Factor=8", "--output", output)
        self.assertEqual(result.returncode, 0, result.stderr)
        kernels = json.loads(output.read_text())
        names = [kernel["kernel"] for kernel in kernels]
        self.assertEqual(len(set(names)), len(names))
        for name in ("STREAM triad", "product with K, rows in double", "V-cycle", "restriction",
                     "friction, block problems", "friction, state update"):
            self.assertIn(name, names)
            self.assertIn(f"| {name} | ", result.stdout)
        for kernel in kernels:
            self.assertGreater(kernel["bytes"], 0, kernel)
            self.assertGreater(kernel["share_of_triad"], 0, kernel)
        in_bytes = {kernel["kernel"]: kernel["bytes"] for kernel in kernels}
        # In single precision, with an index for each of 9 numbers.
        self.assertLess(in_bytes["product with Z, blocks in single"],
                        0.45 * in_bytes["product with K, rows in double"])


class BadInput(unittest.TestCase):
    def test_is_refused(self):
        deck = DECKS / "bp5_qd.xml"
        for words, part in ((["steps", deck], "--steps"),
                            (["steps", deck, "--steps", "1.5"], "--steps 1.5"),
                            (["steps", deck, "--stebs", "1"], "'--steps'"),
                            (["stebs", deck, "--steps", "1"], "--help"),
                            (["steps", "--steps", "1"], "DECK.xml")):
            result = bench(*words)
            self.assertEqual(result.returncode, 2, words)
            self.assertIn(part, result.stderr)
            self.assertEqual(len(result.stderr.strip().splitlines()), 1, result.stderr)


if __name__ == "__main__":
    unittest.main()
