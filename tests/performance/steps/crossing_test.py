"""A crossing does not make steps dearer: the counts of a coupled step where two faults cross, and
on the same cells where the second fault is in two pieces, which end two cells before the first one.

The deck is step_over_3d.xml, with the faults in the planes z = 0 and x = 0, 40 km long, 20 and 17.5
km deep, under the same shear stress; quasi-dynamic, the walls stand still."""

import unittest

import asperity_run
from asperity_run import settings

DECK = asperity_run.SOURCE / "xml" / "step_over_3d.xml"
FAULTS = settings({
    "Mesh/Box/Cell Size": "2500 + 0.3 * (max(0, abs(x) - 25e3) + max(0, abs(z) - 25e3)"
                          " + max(0, -y - 20e3))",
    "Mesh/Faults/near": "abs(z) < 1 && abs(x) < 20.001e3 && y > -20.001e3",
    "Names/sense": 1,
    # one on each
    "Names/in_square": "min(abs(z) + abs(x + 12e3), abs(x) + abs(z + 12e3)) < 6e3"
                       " && abs(-y - 10e3) < 6e3",
    "Friction/L": "0.28 - 0.02 * mean(in_square)",  # of cells twice as large
    "Friction/Slip Direction": "{1, 0, 1}",
    "TNNMG/Linear Correction": "Multigrid"})
SECOND = {"cross": "abs(x) < 1 && abs(z) < 20.001e3 && y > -17.501e3",
          "apart": "abs(x) < 1 && abs(abs(z) - 15e3) < 10.001e3 && y > -17.501e3"}
MOST = 1.1


class Crossing(unittest.TestCase):
    def counts(self, name, *more):
        """Of a coupled step; both faults slip fast enough to matter."""
        folder = asperity_run.run_to_end(
            name, DECK, *FAULTS, *settings({"Mesh/Faults/far": SECOND[name]}), *more, timeout=300)
        rows = asperity_run.table(folder / "steps.csv")
        total = {column: sum(row[column] for row in rows) for column in
                 ("coupled_steps", "rate_problems", "tnnmg_iterations", "v_cycles",
                  "energy_increases", "failed_steps")}
        self.assertEqual((total["energy_increases"], total["failed_steps"]), (0, 0))
        self.assertTrue(all(asperity_run.table(folder / f"events_{fault}.csv")
                            for fault in ("near", "far")))
        print(name, len(rows), "steps,", total, flush=True)
        return {column: total[column] / total["coupled_steps"]
                for column in ("rate_problems", "tnnmg_iterations", "v_cycles")}

    def check(self, *more):
        cross, apart = (self.counts(name, *more) for name in SECOND)
        for column, most in apart.items():
            print(f"{column} of a coupled step: {cross[column]:.3g} and {most:.3g}", flush=True)
            self.assertLessEqual(cross[column], MOST * most, column)

    def test_with_inertia(self):
        self.check(*settings({"Time Stepping/Final Time": 20}))

    def test_quasi_dynamic(self):
        self.check(*settings({"Bulk/Dynamics": "Quasi-dynamic", "Time Stepping/Final Time": 20}, {
            f"Boundary Conditions/{wall}/Type": "Fixed"
            for wall in ("Left", "Right", "Bottom", "Front", "Back")}))


if __name__ == "__main__":
    unittest.main()
