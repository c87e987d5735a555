"""Pore fluid that flows from fault to fault where they cross or join."""

import math
import pathlib
import unittest

import asperity_run
import numpy
from asperity_run import settings

DECK = pathlib.Path(__file__).with_name("flow.xml")
DAY = 86400.0
DIFFUSIVITY, STORAGE, WIDTH, RATE = 0.1, 1e-9, 2.0, 5e-6  # m^2/s, 1/Pa, m, m^2/s
PORE = "Friction/Pore Pressure"
LEVEL_ALONE = ("--remove", "Mesh/Faults/upright", "--remove", "Boundary Conditions/Upright")
ROUNDING = 1e-9  # of the largest pressure; the equations of a step are solved to 1e-12


def quarter_on_half_line(t, x):
    """The pressure where a quarter of the rate flows into the end of a half line."""
    z = x / math.sqrt(4 * DIFFUSIVITY * t)
    growth = math.exp(-z**2) / math.sqrt(math.pi) - z * math.erfc(z)
    return RATE / 4 / WIDTH * 2 * math.sqrt(t / DIFFUSIVITY) / STORAGE * growth


class Flow(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.cross = cls.run_deck("cross")

    @classmethod
    def run_deck(cls, name, *arguments, ranks=1):
        return cls.history(asperity_run.run_to_end(name, DECK, *arguments, ranks=ranks))

    @staticmethod
    def history(folder):
        history = asperity_run.series(folder / "fault.h5")
        return (history["geometry/coordinates"], history["time"],
                history["fields/pore_pressure"].reshape(len(history["time"]), -1))

    @staticmethod
    def along(run, axis, row=-1):
        """{position: pressure} along the level (0) or the upright fault (1)."""
        places, _, pressure = run
        return {float(place[axis]): float(p) for place, p in zip(places, pressure[row])
                if abs(place[1 - axis]) < 1e-6}

    def assert_same(self, expected, found, limit=ROUNDING):
        """At the places of `expected`."""
        self.assertLessEqual(set(expected), set(found))
        largest = max(expected.values())
        self.assertGreater(largest, 1e6)
        for position, pressure in expected.items():
            self.assertAlmostEqual(found[position] / largest, pressure / largest, delta=limit)

    def volume(self, run, row):
        """Of the fluid on both faults."""
        total = 0.0
        for axis in (0, 1):
            line = sorted(self.along(run, axis, row).items())
            total += sum((b[0] - a[0]) * (a[1] + b[1]) / 2 for a, b in zip(line, line[1:]))
        return STORAGE * WIDTH * total

    def test_each_arm_takes_a_quarter(self):
        places, times, pressure = self.cross
        there = (numpy.abs(places) < 1e-6).all(axis=1)
        self.assertEqual(there.sum(), 2)  # each fault has a node at the crossing
        self.assertEqual(numpy.ptp(pressure[:, there], axis=1).max(), 0)
        level, upright = self.along(self.cross, 0), self.along(self.cross, 1)
        self.assert_same(level, upright)
        self.assert_same(level, {-x: p for x, p in level.items()})
        exact = {x: quarter_on_half_line(40 * DAY, abs(x)) for x in level if abs(x) < 1001}
        self.assertAlmostEqual(exact[0], 4.146e6, delta=1e3)
        self.assert_same(exact, level, 0.0025)
        for row, time in enumerate(times):
            self.assertAlmostEqual(self.volume(self.cross, row) / (RATE * times[-1]),
                                   time / times[-1], delta=1e-10)

    def test_a_quarter_is_that_of_a_line(self):
        """A line into which half of the water flows has the pressure of the level fault, and so
        does one that takes two thirds, where the upright fault ends at the level one."""
        half = self.run_deck("half", *LEVEL_ALONE, *settings({f"{PORE}/Wells/W1/Rate": RATE / 2}))
        self.assert_same(self.along(half, 0), self.along(self.cross, 0))
        thirds = self.run_deck("thirds", *LEVEL_ALONE,
                               *settings({f"{PORE}/Wells/W1/Rate": RATE * 2 / 3}))
        branch = self.run_deck("branch", *settings(
            {"Mesh/Faults/upright": "abs(x) < 1 && y > -1 && y < 3001"}))
        self.assert_same(self.along(thirds, 0), self.along(branch, 0))
        self.assert_same({x: p for x, p in self.along(thirds, 0).items() if x >= 0},
                         self.along(branch, 1))

    def test_names_do_not_matter(self):
        """A fault cut in two names is one fault, also where another one crosses it."""
        two_names = settings({
            "Mesh/Faults/level": "abs(y) < 1 && x > -3001 && x < 1",
            "Mesh/Faults/more": "abs(y) < 1 && x > -1 && x < 3001",
            "Boundary Conditions/More/Boundary": "more",
            "Boundary Conditions/More/Type": "Two-Sided Fault"})
        for others in ((), LEVEL_ALONE):
            one, two = (self.run_deck(name, *words, *others)
                        for name, words in (("one", ()), ("two", two_names)))
            self.assert_same(self.along(one, 0), self.along(two, 0))

    def test_ranks_and_refinements(self):
        level = self.along(self.cross, 0)
        halves = settings({"Mesh/Rectangle/Cells X": 40, "Mesh/Rectangle/Cells Y": 40,
                           "Mesh/Refinements": 1})
        for ranks, more in ((2, ()), (3, ()), (1, halves), (3, halves)):
            run = self.run_deck("other", *more, ranks=ranks)
            self.assert_same(level, self.along(run, 0))
            self.assert_same(level, self.along(run, 1))

    def test_restart(self):
        """On the same ranks to the last digit, on others to rounding."""
        for before, after in ((1, 1), (1, 2)):
            folder = asperity_run.run_to_end("parts", DECK, *settings(
                {"Time Stepping/Final Time": 20 * DAY}), ranks=before)
            asperity_run.go_on(folder, DECK, ranks=after)
            found = self.history(folder)
            self.assert_same(self.along(self.cross, 0), self.along(found, 0))
            if after == 1:
                numpy.testing.assert_array_equal(found[2], self.cross[2])

    def test_each_fault_has_its_own_permeability(self):
        """The steady flow to the drained ends of both faults, of which the upright one is twice as
        wide: the four arms are resistors in parallel."""
        wide = settings({f"{PORE}/Width": "abs(x) < 50 ? 4 : 2",
                         f"{PORE}/Fixed Where": "max(abs(x), abs(y)) > 2999",
                         f"{PORE}/Storage": 1e-14})
        folder = asperity_run.run_to_end("wide", DECK, *wide)
        history = asperity_run.series(folder / "fault.h5")
        places, flow = history["geometry/coordinates"], history["fields/darcy_velocity"][-1]
        for axis, width in ((0, 2.0), (1, 4.0)):
            at_end = numpy.abs(places[:, axis] - 3000) < 1e-6
            self.assertEqual(at_end.sum(), 1)
            found = float(flow[at_end, axis][0]) * width
            # The node of the level fault at the crossing is as wide as the upright fault.
            level, upright = 3000 / 2 - 100 / 2 + 100 / 3, 3000 / 4
            share = (upright if axis == 0 else level) / (level + upright) / 2
            self.assertAlmostEqual(found / (RATE * share), 1, delta=1e-6)

    def test_unequal_pressures_mix(self):
        """The water of a full fault at its crossing with an empty one, at once and in time."""
        run = self.run_deck("mixed", *settings({
            f"{PORE}/Initial Pressure": "1e6 * mean(abs(y) > 1)", f"{PORE}/Wells/W1/Rate": 0}))
        for axis, beside in ((0, 0), (1, 1e6)):
            for position, pressure in self.along(run, axis, 0).items():
                self.assertAlmostEqual(pressure, 0.5e6 if abs(position) < 1 else beside, delta=1e-3)
        volume = STORAGE * WIDTH * 1e6 * 6000
        for row in range(len(run[1])):
            self.assertAlmostEqual(self.volume(run, row) / volume, 1, delta=1e-9)
        self.assertGreater(self.along(run, 0)[1000], 1e4)

    def test_is_announced(self):
        for words, is_said in (((), True), (LEVEL_ALONE, False)):
            result = asperity_run.run(DECK, *words, "--validate")
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
            said = " ".join(result.stdout.split())
            self.assertEqual("Pore fluid flows from one fault into another at one place where they "
                             "cross or join." in said, is_said)


if __name__ == "__main__":
    unittest.main()
