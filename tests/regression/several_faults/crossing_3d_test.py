"""Two faults that cross along a line in space: ranks, restart, other solvers, inertia, energy, and
one of them alone where the other one is locked (two_faults_3d.py).

The line goes from the surface to the lower edge of the second fault, inside the first one."""

import re
import unittest

import asperity_run
import numpy
import two_faults_3d
from asperity_run import settings
from mesh_files import mesh_tool


class Crossing(two_faults_3d.TwoFaults):
    def test_both_slip_through_the_crossing(self):
        """At each vertex of the line both faults have a node, which slips about as much as those
        beside it; at tips nothing slips."""
        printed = mesh_tool("info", "whole.h5")
        of_line = int(re.search("left_lateral and right_lateral at ([0-9]+) ", printed)[1])
        self.assertGreater(of_line, 3)
        slip = two_faults_3d.Slip(self.run_deck("both", *two_faults_3d.BOTH))
        for fault, depth, ends, across in (
                ("right_lateral", 15e3, 20e3, (-0.5, 3**0.5 / 2)),
                ("left_lateral", 12e3, 15e3, (0.5, 3**0.5 / 2))):
            places, vector = slip.on(fault)
            numpy.testing.assert_allclose(places[:, :2] @ across, 0, atol=1e-6)
            numpy.testing.assert_allclose(vector[:, :2] @ across, 0, atol=1e-12)
            self.assertGreater(vector[:, 1].min(), -1e-12)  # the senses of conjugate faults
            size, from_line = numpy.linalg.norm(vector, axis=1), numpy.hypot(*places[:, :2].T)
            on_line = (from_line < 1) & (places[:, 2] > -12e3 + 1)
            self.assertEqual(on_line.sum(), of_line)
            beside = (from_line > 1) & (from_line < 5e3)
            for place, value in zip(places[on_line], size[on_line]):
                near = size[beside & (abs(places[:, 2] - place[2]) < 2e3)]
                self.assertGreater(value, 0.5 * near.min())
                self.assertLess(value, 2 * near.max())
            at_tip = (places[:, 2] < 1 - depth) | (from_line > ends - 1)
            self.assertGreater(at_tip.sum(), 15)
            self.assertEqual(size[at_tip].max(), 0)


class SameDepth(unittest.TestCase):
    def test_a_direction_between_two_faults(self):
        """Where faults at right angles end at the same depth, they have a tip in common, whose
        normal lies between theirs: there a direction that both have a part of may have none."""
        result = asperity_run.run(
            asperity_run.SOURCE / "xml" / "step_over_3d.xml", "--validate", *settings({
                "Mesh/Box/Cell Size": 5e3,
                "Mesh/Faults/near": "abs(z) < 1 && abs(x) < 20.001e3 && y > -20.001e3",
                "Mesh/Faults/far": "abs(x) < 1 && abs(z) < 20.001e3 && y > -20.001e3",
                "Names/sense": 1, "Friction/Slip Direction": "{1, 0, 1}"}))
        self.assertEqual((result.returncode, result.stderr), (0, ""))


if __name__ == "__main__":
    unittest.main()
