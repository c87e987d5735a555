"""The answer does not depend on the number of ranks, nor on how the linear correction is found."""

import pathlib
import unittest

import numpy

import asperity_run
from asperity_run import settings
from comparisons import assert_same_effort, largest_errors

HERE = pathlib.Path(__file__).parent
DECK = HERE / "coarse_wedge.xml"


class PrescribedSteps(unittest.TestCase):
    """Steps are prescribed, so that everything must agree to the solver's tolerance."""

    @classmethod
    def setUpClass(cls):
        cls.reference = cls.run_rupture("Direct", 1)
        cls.multigrid = cls.run_rupture("Multigrid", 1)

    @staticmethod
    def run_rupture(correction, ranks):
        return asperity_run.run_to_end(
            f"rupture_{correction}_{ranks}", DECK, "--overlay", HERE / "rupture.xml",
            *settings(f"TNNMG/Linear Correction={correction}"), ranks=ranks, timeout=120)

    def test_reference_is_a_rupture(self):
        rate = asperity_run.series(self.reference / "fault.h5")["fields/slip_rate"]
        self.assertEqual(len(rate), 24)
        self.assertGreater(rate.max(), 2e-3)
        self.assertEqual(rate.min(axis=1).max(), 5e-5)
        events = asperity_run.table(self.reference / "events.csv")
        self.assertEqual([event["complete"] for event in events], [1])

    def test_multigrid_agrees_with_direct(self):
        self.assert_same_fields(self.multigrid)

    def test_two_ranks(self):
        self.check(2)

    def test_three_ranks(self):
        self.check(3)

    def check(self, ranks):
        folder = self.run_rupture("Multigrid", ranks)
        self.assert_same_fields(folder)
        assert_same_effort(self, self.multigrid, folder)

    def assert_same_fields(self, folder):
        for field, error in largest_errors(self.reference, folder).items():
            self.assertLess(error, 1e-9, field)


class AdaptiveSteps(unittest.TestCase):
    """Steps follow the error of alpha; a decision may flip, but the events stay."""

    def test_events_on_two_ranks(self):
        changes = settings("Mesh/Wedge/Cell Size=0.02", "Time Stepping/Final Time=10",
                           "Time Stepping/Step Doubling/Tolerance=1e-3")
        serial, parallel = (
            asperity_run.table(asperity_run.run_to_end(
                f"events_{ranks}", DECK, *changes, ranks=ranks, timeout=400) / "events.csv")
            for ranks in (1, 2))
        self.assertEqual(len(serial), 2)
        self.assertEqual(len(parallel), 2)
        recurrence = serial[1]["onset"] - serial[0]["onset"]
        for ours, theirs in zip(serial, parallel):
            self.assertLess(abs(ours["onset"] - theirs["onset"]), 1e-3 * recurrence)
            self.assertEqual(ours["width"], theirs["width"])
            self.assertLess(abs(ours["peak_slip"] / theirs["peak_slip"] - 1), 1e-2)


class AntisymmetricFault(unittest.TestCase):
    """The rupture of TPV101 with large cells: generalised alpha with Richardson's control, a stress
    in time, absorbing boundaries."""

    def test_arrivals_on_two_ranks(self):
        changes = settings("Mesh/Rectangle/Cell Size Factor=8", "Time Stepping/Final Time=2",
                           "Time Stepping/Richardson/Tolerance=1e-2")
        folders = [asperity_run.run_to_end(f"tpv101_{ranks}",
                                           asperity_run.SOURCE / "xml" / "tpv101_2d.xml",
                                           *changes, ranks=ranks, timeout=400)
                   for ranks in (1, 2)]
        events = [asperity_run.table(folder / "events.csv") for folder in folders]
        self.assertEqual([len(each) for each in events], [1, 1])
        serial, parallel = (asperity_run.series(folder / "rupture.h5")["first_rupture_time"]
                            for folder in folders)
        self.assertGreater(numpy.isfinite(serial).sum(), 4)
        numpy.testing.assert_allclose(parallel, serial, rtol=0, atol=1e-3)  # nan where none came


if __name__ == "__main__":
    unittest.main()
