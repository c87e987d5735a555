"""A number that a law loses at one node of a run, after some steps, ends it with status 3, and the
message says which, where and when. The last good state is on the disk."""

import os
import pathlib
import unittest

import asperity_run
import numpy
import runs

LIMIT, PLACE = 0.9, 0.2625  # state and place at which the law has no state


def write_deck():
    text = runs.DECK.read_text()
    for old, new in (
            ('name="State Evolution" type="string" value="Ageing"',
             'name="State Evolution" type="string" value="Fragile"'),
            ('<Parameter name="L" type="double" value="25e-6"/>',
             '<Parameter name="Limit" type="string" '
             f'value="abs(x - {PLACE}) &lt; 0.011 ? {LIMIT} : 1e9"/>'),
            ('value="0.1 * sin(20 * x)"', 'value="0"')):
        if old not in text:
            raise AssertionError(f"{runs.DECK} has no {old}")
        text = text.replace(old, new)
    path = pathlib.Path("fragile.xml")
    path.write_text(text)
    return path


class LostNumber(unittest.TestCase):
    def check(self, ranks):
        folder = runs.fresh(f"lost_{ranks}")
        result = asperity_run.run(
            write_deck(), "--plugin", os.environ["ASPERITY_FRAGILE_LAW"], *runs.settings(
                "Mesh/Wedge/Cell Size=0.02", "Time Stepping/Final Time=4",
                "Time Stepping/Smallest Step=1e-3", "TNNMG/Linear Correction=Multigrid",
                "Output/Checkpoint Every n Steps=1000"), "--output", folder, ranks=ranks)
        message = runs.assert_one_message(self, result, runs.SOLVE, "alpha ", "nan", "t = ",
                                          "Step ")
        self.assertRegex(message, r"at node \d+, \(")
        self.assertIn(message.removeprefix("asperity: "), (folder / "run.log").read_text())
        x, y = (float(word) for word in
                message.rpartition("node ")[2].partition("(")[2].partition(")")[0].split(","))
        # The fault is the base, along which the deck's x counts.
        self.assertLess(abs(numpy.hypot(x, y) - PLACE), 0.03, message)
        rows = asperity_run.table(folder / "steps.csv")
        self.assertGreater(len(rows), 5)
        self.assertLess(rows[-1]["time"], LIMIT)
        self.assertGreater(rows[-1]["time"], LIMIT / 2)
        values = asperity_run.series(folder / "checkpoint.h5")
        runs.assert_finite_checkpoint(self, folder)
        self.assertLess(values["values/state/alpha"].max(), LIMIT)
        history = asperity_run.series(folder / "fault.h5")
        self.assertTrue(numpy.isfinite(history["fields/alpha"]).all())

    def test_is_named(self):
        self.check(1)

    def test_is_named_on_two_ranks(self):
        self.check(2)


if __name__ == "__main__":
    unittest.main()
