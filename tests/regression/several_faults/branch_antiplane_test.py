"""A branch that ends at another fault in antiplane motion, and slips there: the slip rates of
blocks that move as a whole, values by the names of faults, ranks, restart, other solvers, inertia,
refinement, and the other fault alone where the branch is locked."""

import pathlib
import unittest

import asperity_run
import numpy
from asperity_run import settings
from comparisons import assert_same_results

DECK = pathlib.Path(__file__).with_name("branch_antiplane.xml")
UPPER_LEFT, UPPER_RIGHT, LOWER = 1e-3, 4e-3, -1e-3  # m/s, of the blocks
# Both upper blocks move alike, so that a mesh without the branch has one, too. Stress drives it.
ONE_BLOCK = settings({"Names/upper_left": UPPER_RIGHT, "Friction/Shear Traction": 8e6,
                      "Time Stepping/Final Time": 10})
INERTIA = settings({"Bulk/Dynamics": "Inertial", "Time Stepping/Final Time": 1,
                    "Time Stepping/Largest Step": 0.05, "Time Stepping/Smallest Step": 0.05})
ALONE = ("--remove", "Mesh/Faults/branch", "--remove", "Boundary Conditions/Branch")
LOCKED = settings({"Friction/Cohesion/main": 0, "Friction/Cohesion/branch": 1e9})


class Fault:
    """Nodes of one of the faults, in the order of their positions along it [m], and the last row
    of a field. At the joint each fault has a node."""

    def __init__(self, history, axis, field):
        places, elements = history["geometry/coordinates"], history["geometry/connectivity"]
        is_its = (abs(places[elements][:, :, 1 - axis]) < 1e-6).all(axis=1)
        nodes = numpy.unique(elements[is_its])
        nodes = nodes[numpy.argsort(places[nodes, axis])]
        self.position = places[nodes, axis]
        self.values = history[f"fields/{field}"][-1].ravel()[nodes]
        self.joint = numpy.flatnonzero(abs(self.position) < 1e-6)[0]

    def share_of_right(self):
        """Of the lengths on both sides of the joint."""
        left, right = numpy.diff(self.position)[[self.joint - 1, self.joint]]
        return right / (left + right)

    def sides_of_joint(self):
        """Values to the left and to the right of it, continued linearly."""
        def continued(near, far):
            """To the joint, of the nodes with these distances in the order of nodes."""
            nodes = [self.joint + near, self.joint + far]
            x, y = self.position[nodes], self.values[nodes]
            return y[0] - x[0] * (y[1] - y[0]) / (x[1] - x[0])

        return continued(-1, -2), continued(1, 2)


def faults(folder, field="slip", axes=(0, 1)):
    """[main, branch], which are along these axes."""
    history = asperity_run.series(folder / "fault.h5")
    return [Fault(history, axis, field) for axis in axes]


class AntiplaneBranch(unittest.TestCase):
    def run_deck(self, name, *arguments, ranks=1):
        """The folder; J falls in every step, and the energy balance closes in each of them."""
        folder = asperity_run.run_to_end(name, DECK, *arguments, ranks=ranks)
        rows = asperity_run.table(folder / "steps.csv")
        self.assertEqual([row["energy_increases"] for row in rows], [0] * len(rows))
        friction = rows[-1]["friction_work"]
        self.assertGreater(friction, 0)
        for row in rows:
            self.assertLess(abs(row["energy_defect"]), 1e-9 * friction)
        return folder

    def assert_same(self, expected, found, limit=1e-7):
        """Slip of two runs, on the main fault and on the branch."""
        for ours, theirs in zip(faults(expected), faults(found)):
            size = abs(ours.values).max()
            self.assertGreater(size, 1e-3)
            numpy.testing.assert_array_equal(theirs.position, ours.position)
            numpy.testing.assert_allclose(theirs.values, ours.values, rtol=0, atol=limit * size)

    def test_three_blocks(self):
        """In the end tractions are constant, so that each block moves as its outer edge does. The
        slip rates are the differences; that of the main fault at the joint is the mean of its two
        halves, weighted by the lengths beside it. Friction is that of steady sliding."""
        folder = self.run_deck("blocks")
        main, branch = faults(folder, "slip_rate")
        share = main.share_of_right()
        self.assertLess(share, 0.4)  # else the weights would not be seen
        expected = numpy.where(main.position < 0, UPPER_LEFT, UPPER_RIGHT) - LOWER
        expected[main.joint] = share * UPPER_RIGHT + (1 - share) * UPPER_LEFT - LOWER
        numpy.testing.assert_allclose(main.values, expected, rtol=1e-8)
        numpy.testing.assert_allclose(branch.values, UPPER_RIGHT - UPPER_LEFT, rtol=1e-8)
        for fault, traction in zip((main, branch), faults(folder, "traction")):
            inside = slice(0, -1 if fault is branch else None)  # slip is given at the upper edge
            steady = 10e6 * (0.6 + (0.02 - 0.01) * numpy.log(fault.values / 1e-3))
            numpy.testing.assert_allclose(traction.values[inside], steady[inside], rtol=1e-6)

    def test_the_branch_slips_where_it_ends(self):
        """About as much as beside the joint. The slip of the main fault jumps by this there, and
        its node has the mean of both sides, weighted by the lengths beside it."""
        for more in ((), INERTIA):
            main, branch = faults(self.run_deck("slip", *ONE_BLOCK, *more))
            at_joint = branch.values[0]
            self.assertGreater(at_joint, 0.1)
            self.assertAlmostEqual(at_joint / branch.values[1], 1, delta=0.05)
            left, right = main.sides_of_joint()
            self.assertAlmostEqual((right - left) / at_joint, 1, delta=0.05)
            share = main.share_of_right()
            mean = share * right + (1 - share) * left
            self.assertAlmostEqual(main.values[main.joint] / mean, 1, delta=0.02)

    def test_values_by_the_names_of_faults(self):
        """Also at the joint, where a formula has one value for both faults."""
        folder = self.run_deck("by_name", *settings({
            "Friction/Normal Stress/main": "10e6 + x", "Friction/Normal Stress/branch": 9e6,
            "Output/Fault History/Fields": "{normal_stress}", "Time Stepping/Final Time": 1}))
        main, branch = faults(folder, "normal_stress")
        numpy.testing.assert_allclose(main.values, 10e6 + main.position)
        numpy.testing.assert_array_equal(branch.values, 9e6)

    def test_ranks(self):
        for more in ((), INERTIA):
            expected = self.run_deck("one_rank", *ONE_BLOCK, *more)
            for ranks in (2, 3):
                self.assert_same(expected,
                                 self.run_deck("ranks", *ONE_BLOCK, *more, ranks=ranks))

    def test_solvers(self):
        expected = self.run_deck("auto", *ONE_BLOCK)
        for correction in ("Direct", "Multigrid"):
            self.assert_same(expected, self.run_deck("other", *ONE_BLOCK, *settings(
                {"TNNMG/Linear Correction": correction})))

    def test_restart(self):
        """On the same ranks to the last digit, on others up to the tolerance of the solver."""
        for more, half in ((ONE_BLOCK, 5), ([*ONE_BLOCK, *INERTIA], 0.5)):
            whole = {ranks: self.run_deck(f"whole_{ranks}", *more, ranks=ranks)
                     for ranks in (1, 2)}
            for before, after in ((1, 1), (2, 2), (1, 2)):
                folder = self.run_deck("parts", *more, *settings(
                    {"Time Stepping/Final Time": half}), ranks=before)
                asperity_run.go_on(folder, DECK, *more, ranks=after)
                if before == after:
                    assert_same_results(whole[after], folder, series=("fault.h5",))
                else:
                    self.assert_same(whole[after], folder)

    def test_refined(self):
        """Slip at the joint is that with larger cells but for a tenth of the largest."""
        for coarse, fine in zip(*(faults(self.run_deck(f"refined_{number}", *ONE_BLOCK, *settings(
                f"Mesh/Refinements={number}"), ranks=2)) for number in (0, 1))):
            self.assertEqual(len(fine.position), 2 * len(coarse.position) - 1)
            numpy.testing.assert_allclose(fine.values[::2], coarse.values, rtol=0,
                                          atol=0.1 * coarse.values.max())

    def test_the_branch_locked(self):
        """By strength that no stress reaches: the main fault alone."""
        for more in ((), INERTIA):
            alone, = faults(self.run_deck("alone", *ONE_BLOCK, *ALONE, *more), axes=(0,))
            free, _ = faults(self.run_deck("free", *ONE_BLOCK, *more))
            main, branch = faults(self.run_deck("locked", *ONE_BLOCK, *LOCKED, *more))
            size = abs(alone.values).max()
            self.assertGreater(abs(free.values - alone.values).max(), 0.01 * size)
            self.assertLess(abs(branch.values).max(), 1e-12)
            numpy.testing.assert_array_equal(main.position, alone.position)
            numpy.testing.assert_allclose(main.values, alone.values, rtol=0, atol=1e-8 * size)


if __name__ == "__main__":
    unittest.main()
