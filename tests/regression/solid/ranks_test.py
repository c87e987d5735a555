"""A wedge between glass panes that slips along both tangents: the same on any number of ranks."""

import unittest

import numpy

import asperity_run
import wedge_runs
from comparisons import assert_same_effort, largest_errors


class PrescribedSteps(unittest.TestCase):
    """Steps are prescribed: fields must agree to the solver's tolerance, and so must the effort."""

    @classmethod
    def setUpClass(cls):
        cls.reference = cls.run_rupture(1)

    @staticmethod
    def run_rupture(ranks):
        return wedge_runs.run_deck(
            f"rupture_{ranks}", *wedge_runs.RUPTURE, *wedge_runs.GLASS,
            *wedge_runs.settings("Time Stepping/Final Time=0.016",
                                 "TNNMG/Linear Correction=Multigrid"), ranks=ranks)

    def test_slips_along_both_tangents(self):
        fault = asperity_run.series(self.reference / "fault.h5")
        slip = fault["fields/slip"]
        largest = numpy.abs(slip).max(axis=(0, 1))
        self.assertGreater(fault["fields/slip_rate"].max(), 1e-3)
        self.assertGreater(largest[2], 0.2 * largest[0])
        z = fault["geometry/coordinates"][:, 2]
        at_glass = (z == 0) | (z == 0.1)
        self.assertGreater(at_glass.sum(), 10)
        self.assertEqual(numpy.abs(slip[:, at_glass, 2]).max(), 0)

    def test_two_ranks(self):
        self.check(2)

    def test_three_ranks(self):
        self.check(3)

    def test_four_ranks(self):
        self.check(4)

    def check(self, ranks):
        folder = self.run_rupture(ranks)
        for field, error in largest_errors(self.reference, folder).items():
            self.assertLess(error, 1e-8, field)
        assert_same_effort(self, self.reference, folder)


class AdaptiveSteps(unittest.TestCase):
    """Steps follow the error of alpha; a decision may flip, but the event stays."""

    def test_event_on_two_ranks(self):
        changes = wedge_runs.settings(
            "Mesh/Deep Wedge/Cell Size=0.05", "Friction/Slip Direction={1, 0, 0}",
            "Time Stepping/Final Time=5", "Time Stepping/Step Doubling/Tolerance=1e-3",
            "Initial State/alpha=10 * z - (abs(x - 0.2625) < 0.1 ? 1 : 0)")
        serial, parallel = (
            asperity_run.table(wedge_runs.run_deck(
                f"event_{ranks}", *wedge_runs.GLASS, *changes, ranks=ranks) / "events.csv")
            for ranks in (1, 2))
        self.assertEqual([len(events) for events in (serial, parallel)], [1, 1])
        ours, theirs = serial[0], parallel[0]
        self.assertEqual(ours["complete"], 1)
        for name, tolerance in (("onset", 1e-3), ("area", 1e-2), ("peak_slip", 1e-2)):
            self.assertLess(abs(theirs[name] / ours[name] - 1), tolerance, name)
        for axis in "xyz":
            self.assertEqual(ours["hypocentre_" + axis], theirs["hypocentre_" + axis])


if __name__ == "__main__":
    unittest.main()
