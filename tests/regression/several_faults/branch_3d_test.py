"""A branch that ends along a line at another fault in space, and slips along it: ranks, restart,
other solvers, inertia, energy, refinement, and the other fault alone where the branch is locked
(two_faults_3d.py).

The line goes from the surface to the lower edge of the branch, inside the other fault. The stress
along both faults has a horizontal and a vertical part."""

import re
import unittest

import numpy
import two_faults_3d
from asperity_run import settings
from mesh_files import mesh_tool
from two_faults_3d import BOTH, INERTIA, LEFT_DEPTH, RIGHT_DEPTH, Slip


class Side:
    """Nodes of one fault at the line or beside it, the tip at its lower end apart: places along z
    and along the trace, positive to the east, slip along the line and along the trace."""

    def __init__(self, places, slip, strike):
        self.trace, self.z = places[:, :2] @ strike, places[:, 2]
        self.slip, self.along, self.across = slip, slip[:, 2], slip[:, :2] @ strike
        above = self.z > 1 - LEFT_DEPTH
        self.is_on = (abs(self.trace) < 1) & above

    def near(self, z, side):
        """Whether nodes lie to the west (-1) or to the east (1) of the line, at about this z."""
        distance = side * self.trace
        return (distance > 1) & (distance < 3e3) & (abs(self.z - z) < 1.6e3)


def sides(folder):
    """(main, branch)"""
    slip = Slip(folder)
    return (Side(*slip.on("right_lateral"), (3**0.5 / 2, 0.5)),
            Side(*slip.on("left_lateral"), (3**0.5 / 2, -0.5)))


class Branch(two_faults_3d.TwoFaults):
    SIZES = {"left_east": 0}
    CHANGES = settings({"Friction/Slip Direction": "{0, 1, 1}"})

    def test_info(self):
        """The line is that of the vertices of the branch, without the tip at its lower end."""
        found = re.search(r"joint            left_lateral ends on right_lateral at (\d+) vertices "
                          r"from \(\S+, \S+, (\S+)\) to \(\S+, \S+, (\S+)\) m, (\S+) m long",
                          mesh_tool("info", "whole.h5"))
        _, branch = sides(self.run_deck("info", *BOTH))
        z = branch.z[branch.is_on]
        self.assertGreater(len(z), 3)
        self.assertEqual(int(found[1]), len(z))
        numpy.testing.assert_allclose(sorted([float(found[2]), float(found[3])]), [z.min(), 0],
                                      rtol=1e-5)
        self.assertAlmostEqual(float(found[4]), -z.min(), delta=0.1)

    def test_slip_on_the_line(self):
        """The branch slips along it, and not across it; tips have no slip."""
        for more in ((), INERTIA):
            main, branch = sides(self.run_deck("slip", *BOTH, *more))
            self.assertGreater(branch.along[branch.is_on].min(), 0.1 * branch.along.max())
            self.assertLess(abs(branch.slip[branch.is_on, :2]).max(), 1e-12)
            self.assertGreater(abs(branch.across).max(), 0.01)
            for fault, depth in ((main, RIGHT_DEPTH), (branch, LEFT_DEPTH)):
                at_tip = fault.z < 1 - depth
                self.assertGreater(at_tip.sum(), 4)
                self.assertEqual(abs(fault.slip[at_tip]).max(), 0)

    def test_refined(self):
        """Each edge of the line has two. With smaller cells slip of the branch on it is about that
        beside it, away from the tip at its lower end; so much does the slip of the main fault jump
        there. One refinement and 15 % were chosen after the result: slip on the line converges
        with first order, and on the coarse mesh it is a third to a half of that beside it."""
        _, coarse = sides(self.run_deck("coarse", *BOTH))
        main, branch = sides(self.run_deck("fine", *BOTH, *settings("Mesh/Refinements=1"), ranks=2))
        self.assertEqual(branch.is_on.sum(), 2 * coarse.is_on.sum())
        self.assertLess(abs(branch.slip[branch.is_on, :2]).max(), 1e-12)
        upper = branch.is_on & (branch.z > -0.7 * LEFT_DEPTH)
        self.assertGreater(upper.sum(), 5)
        for z, value in zip(branch.z[upper], branch.along[upper]):
            beside = branch.along[branch.near(z, -1)]
            self.assertGreater(value, 0.5 * beside.min())
            self.assertLess(value, 2 * beside.max())
            jump = main.along[main.near(z, 1)].mean() - main.along[main.near(z, -1)].mean()
            self.assertAlmostEqual(jump / value, 1, delta=0.15)


if __name__ == "__main__":
    unittest.main()
