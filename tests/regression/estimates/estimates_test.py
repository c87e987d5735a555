"""What a run says of its resolution and steps before the first step, and what it finds later."""

import pathlib
import re
import sys
import unittest

import asperity_run
from asperity_run import settings

sys.path.insert(0, str(asperity_run.SOURCE / "python"))
from asperity_status.facts import facts  # noqa: E402

XML = asperity_run.SOURCE / "xml"
HERE = pathlib.Path(__file__).resolve().parent
DEFAULT_STEP = ("Time Stepping/Smallest Step",)  # what to remove for it
FINAL = "Time Stepping/Final Time"
STEP = "Smallest Step = ([^ ]+) s by default"


def validated(deck, *changes, remove=()):
    """What --validate prints of a deck that must be valid."""
    removals = [word for entry in remove for word in ("--remove", entry)]
    result = asperity_run.run(deck, *settings(*changes), *removals, "--validate")
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout


def number(pattern, text):
    found = re.search(pattern, text)
    if not found:
        raise AssertionError(f"no '{pattern}' in {text}")
    return float(found[1])


class Estimates(unittest.TestCase):
    def test_a_barrier_is_left_out(self):
        """SCEC's mu_s = 10,000, and tandem's cohesion, where a rupture stops."""
        deck = XML / "tpv5_2d.xml"
        whole = validated(deck, remove=DEFAULT_STEP)
        barriers = ({"Friction/Static Friction Coefficient": "abs(x)<15e3 ? 0.677 : 10000",
                     "Friction/Dynamic Friction Coefficient": 0.525, "Friction/Cohesion": 0},
                    {"Friction/Dynamic Friction Coefficient": 0.525,
                     "Friction/Cohesion": "abs(x)<15e3 ? 0 : 1e9"})
        for barrier in barriers:
            text = validated(deck, barrier, remove=DEFAULT_STEP)
            self.assertNotIn("WARNING", text)
            self.assertEqual(number(STEP, text), number(STEP, whole))
            self.assertIn("which cannot slip", text)
            for words in (">= ([0-9.]+) m, at least", "Nucleation length >= ([0-9.]+) m"):
                self.assertEqual(number(words, text), number(words, whole))

    def test_the_laws_own_steady_state_decides(self):
        text = validated(HERE / "strong_weakening.xml")
        # L / (100 V_s), V_s = 20 b sigma_n / Z, Z = sqrt(rho G)
        rate = 20 * 0.014 * 120e6 / (2700 * 32e9) ** 0.5
        self.assertAlmostEqual(number("by L in ([^ ]+) s or more", text), 0.4 / rate, 4)
        with self.assertRaisesRegex(AssertionError, "only if friction weakens somewhere"):
            validated(HERE / "strong_weakening.xml", {"Friction/State Evolution": "Slip"},
                      remove=("Friction/Weakened Friction Coefficient",
                              "Friction/Weakening Slip Rate"))

    def test_a_final_time_that_is_too_long_is_refused_by_its_name(self):
        slider = XML / "spring_slider.xml"
        step = number(STEP, validated(slider, remove=DEFAULT_STEP))
        for final in (1e13, 1e15, 1e18, 1e300):
            result = asperity_run.run(slider, *settings({FINAL: final}), "--remove",
                                      *DEFAULT_STEP, "--validate")
            self.assertEqual(result.returncode, 2)
            self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
            self.assertIn("Time Stepping / Final Time", result.stderr)
            self.assertNotIn("'Smallest Step'", result.stderr)
        longest = number("Choose at most ([^ ]+) s", result.stderr)
        # Between half of the default and all of it, of which there are 4.5e18.
        self.assertTrue(0.49 * step < longest / 4.5e18 < step, (longest, step))
        text = validated(slider, {FINAL: longest}, remove=DEFAULT_STEP)
        self.assertEqual(number(STEP, text), step)


class Fronts(unittest.TestCase):
    """BP6, whose fault strengthens: with the slip law the zone behind the front has 0.8 cells of
    50 m, and slip rates are 3.5 times too high; with the ageing law it has ten."""

    def warnings(self, law, *changes):
        folder = asperity_run.run_to_end(
            law.lower(), XML / "bp6.xml", *settings(
                f"Friction/State Evolution={law}", *changes),
            timeout=200)
        of_run = facts(folder, 1800.0)
        log = (folder / "run.log").read_text()
        topics = [each["topic"] for each in of_run.warnings]
        self.assertEqual("front of slip" in topics,
                         "WARNING: The zone over which friction falls" in log)
        return topics, number("Friction fell fastest .* m, ([0-9.e-]+) cells", log)

    def test_cells_that_do_not_resolve_a_front_are_told(self):
        at_start = validated(XML / "bp6.xml", "Friction/State Evolution=Slip")
        self.assertIn("WARNING: The zone over which friction falls", at_start)
        topics, cells = self.warnings("Slip")
        self.assertEqual(topics, ["front of slip"])
        self.assertLess(cells, 1)

    def test_the_ageing_law_needs_no_more_than_the_cohesive_zone(self):
        self.assertNotIn("WARNING", validated(XML / "bp6.xml"))
        topics, cells = self.warnings("Ageing")
        self.assertEqual(topics, [])
        # G' L / (b sigma_n) = 512.6 m, wider where water relieves the normal stress
        self.assertGreater(cells, 0.99 * 512.6 / 50)


if __name__ == "__main__":
    unittest.main()
