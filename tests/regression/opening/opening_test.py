"""A fault in a plate that is pulled and pushed back, so that it opens and closes: ranks, restart,
energy, what is written; pushed first, it is a fault that cannot open."""

import pathlib
import unittest

import asperity_run
import numpy
from asperity_run import settings
from comparisons import assert_same_results

DECK = pathlib.Path(__file__).parent.parent / "orientation" / "two_faults.xml"
CONTACT, RIGHT = "Boundary Conditions/Upright/Contact", "Boundary Conditions/Right"
OPENING = settings({
    CONTACT: "Unilateral", f"{RIGHT}/Type": "Prescribed Velocity", f"{RIGHT}/Direction": "{1, 0}",
    "Friction/Normal Stress": 1e6, "Friction/Normal Stress Change": "Coupled",
    "Friction/Shear Traction": 0.8e6,
    "TNNMG/Relative Tolerance": 1e-11, "Coupling/Tolerance": 1e-9,
    "Output/Fault History/Fields": "{slip, opening, normal_stress}",
    "Output/Fault History/Every n Steps": 1})


def moved(amount, duration):
    """To the right by this many metres within half of the duration, and back."""
    velocity = 2 * amount / duration
    return settings({f"{RIGHT}/Velocity": f"t < {duration / 2} ? {velocity} : {-velocity}",
                     "Time Stepping/Final Time": duration,
                     "Time Stepping/Largest Step": duration / 32,
                     "Time Stepping/Smallest Step": duration / 32})


SLOWLY = moved(0.2, 1000)
# Waves cross the plate in 1.4 s.
FAST = [*moved(0.2, 8), *settings({"Bulk/Dynamics": "Inertial", "Time Stepping/Scheme": "Newmark"})]


class Opening(unittest.TestCase):
    def run_deck(self, name, motion, *arguments, ranks=1):
        return asperity_run.run_to_end(name, DECK, *OPENING, *motion, *arguments, ranks=ranks)

    @staticmethod
    def fields(folder):
        """Places, weights, and slip and opening (rows, nodes)."""
        history = asperity_run.series(folder / "fault.h5")
        count = len(history["time"])
        return (history["geometry/coordinates"], history["geometry/weights"],
                *(history[f"fields/{name}"].reshape(count, -1) for name in ("slip", "opening")))

    def assert_same(self, expected, found):
        (places, _, *ours), (other_places, _, *theirs) = map(self.fields, (expected, found))
        numpy.testing.assert_array_equal(places, other_places)
        for left, right in zip(ours, theirs):
            self.assertGreater(abs(left).max(), 1e-3)
            numpy.testing.assert_allclose(right, left, rtol=0, atol=1e-7 * abs(left).max())

    def test_opens_and_closes(self):
        """In a step of a part of the fault that `share_open` says; the energy balances."""
        for motion in (SLOWLY, FAST):
            folder = self.run_deck("whole", motion)
            rows = asperity_run.table(folder / "steps.csv")
            _, weights, _, opening = self.fields(folder)
            is_open = opening[1:] > 1e-9 * opening.max()
            share = [row["share_open"] for row in rows]
            numpy.testing.assert_allclose(share, is_open @ weights / weights.sum(), atol=1e-7)
            self.assertGreater(max(share), 0.5)
            self.assertEqual(sum(row["energy_increases"] for row in rows), 0)
            last = rows[-1]
            scale = max(row["elastic_energy"] + row["kinetic_energy"] for row in rows)
            self.assertLess(abs(last["energy_defect"]), 1e-10 * scale)
            if motion is SLOWLY:
                self.assertEqual((share[0], share[-1]), (0, 0))
                self.assertGreaterEqual(opening.min(), -1e-12 * opening.max())
            else:  # contact takes energy in each step
                taken = numpy.diff([0, *(row["contact_work"] for row in rows)])
                self.assertGreater(taken.max(), 0)
                self.assertGreaterEqual(taken.min(), -1e-10 * scale)

    def test_ranks_and_solvers(self):
        multigrid = settings({"TNNMG/Linear Correction": "Multigrid"})
        for motion in (SLOWLY, FAST):
            expected = self.run_deck("one_rank", motion)
            for ranks, more in ((2, ()), (3, ()), (1, multigrid)):
                self.assert_same(expected, self.run_deck("other", motion, *more, ranks=ranks))

    def test_restart(self):
        """While the fault is open: on the same ranks to the last digit, on others up to the
        tolerance of the solver."""
        for motion, middle in ((SLOWLY, 500), (FAST, 4)):
            whole = self.run_deck("whole", motion)
            for before, after in ((1, 1), (1, 2)):
                parts = self.run_deck("parts", motion, *settings(
                    {"Time Stepping/Final Time": middle}), ranks=before)
                self.assertGreater(asperity_run.table(parts / "steps.csv")[-1]["share_open"], 0)
                asperity_run.go_on(parts, DECK, *OPENING, *motion, ranks=after)
                self.assert_same(whole, parts)
                if before == after:
                    assert_same_results(whole, parts, series=("fault.h5",), tables=("steps.csv",))

    def test_in_compression_it_is_a_bilateral_fault(self):
        slip = []
        for contact in ("Unilateral", "Bilateral"):
            folder = self.run_deck(contact, moved(-0.2, 1000), *settings(
                {CONTACT: contact, "Output/Fault History/Fields": "{slip, normal_stress}"}))
            history = asperity_run.series(folder / "fault.h5")
            self.assertGreater(history["fields/normal_stress"].min(), 0.5e6)
            slip.append(history["fields/slip"])
        self.assertGreater(abs(slip[1]).max(), 1e-3)
        numpy.testing.assert_allclose(slip[0], slip[1], rtol=0, atol=1e-7 * abs(slip[1]).max())


if __name__ == "__main__":
    unittest.main()
