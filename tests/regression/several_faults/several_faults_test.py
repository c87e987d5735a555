"""A table of earthquakes for each of several faults: `Event Catalogue / Each Fault`."""

import pathlib
import unittest

import asperity_run
from asperity_run import settings
from documented_columns import assert_documented

DECK = pathlib.Path(__file__).parent.parent / "refinement" / "buried_fault.xml"
CATALOGUE = "Output/Event Catalogue"
# The fault of the deck in two parts, which slip faster than the threshold for a while.
TWO = settings({
    "Mesh/Faults/main": "abs(y) < 1e-6 && abs(x - 1.5) < 0.51 && abs(z - 2.5) < 0.51",
    "Mesh/Faults/other": "abs(y) < 1e-6 && abs(x - 2.5) < 0.51 && abs(z - 2.5) < 0.51",
    "Boundary Conditions/Other/Boundary": "other",
    "Boundary Conditions/Other/Type": "Two-Sided Fault"})
EACH = settings(f"{CATALOGUE}/Each Fault=true", f"{CATALOGUE}/Threshold=0.02", "Mesh/Refinements=1")
TABLES = ("events.csv", "events_main.csv", "events_other.csv")


class EachFault(unittest.TestCase):
    def run_deck(self, name, *arguments, ranks=1):
        return asperity_run.run_to_end(name, DECK, *TWO, *EACH, *arguments, ranks=ranks)

    def test_moments_add_up(self):
        whole, main, other = ([row["moment"] for row in asperity_run.table(folder / name)]
                              for folder in [self.run_deck("whole")] for name in TABLES)
        self.assertTrue(whole and main and other)
        self.assertAlmostEqual((sum(main) + sum(other)) / sum(whole), 1, delta=1e-7)  # 8 digits

    def test_columns_are_those_of_the_manual(self):
        folder = self.run_deck("columns", *settings("Time Stepping/Final Time=0.2"))
        assert_documented(self, folder, 3, without=(
            "share_on_floor", "share_open", "inelastic_work", "contact_work"))

    def stopped(self, name):
        """A run that ends within an event of each fault."""
        folder = self.run_deck(name, *settings("Time Stepping/Final Time=0.2"))
        for table in TABLES:
            self.assertEqual(asperity_run.table(folder / table)[-1]["complete"], 0)
        return folder

    def test_restart(self):
        whole, parts = self.run_deck("whole"), self.stopped("parts")
        asperity_run.go_on(parts, DECK, *TWO, *EACH)
        for name in TABLES:
            self.assertEqual(asperity_run.content(parts / name), asperity_run.content(whole / name))

    def test_two_ranks(self):
        """All the time, and after a restart."""
        whole, parallel = self.run_deck("whole"), self.run_deck("parallel", ranks=2)
        moved = self.stopped("moved")
        asperity_run.go_on(moved, DECK, *TWO, *EACH, ranks=2)
        for folder in (parallel, moved):
            for name in TABLES:
                ours, theirs = asperity_run.table(whole / name), asperity_run.table(folder / name)
                self.assertEqual(len(ours), len(theirs))
                for row, other in zip(ours, theirs):
                    for column in ("onset", "area", "moment", "peak_slip", "number"):
                        self.assertAlmostEqual(row[column] / other[column], 1, delta=1e-6)

    def test_a_single_fault(self):
        self.assertTrue(asperity_run.refuses(
            DECK, f"{CATALOGUE}/Each Fault=true",
            "Asperity / Output / Event Catalogue / Each Fault is true, but"))


if __name__ == "__main__":
    unittest.main()
