"""A run in space that ends early and is continued leaves the very numbers of one that does not."""

import shutil
import unittest

import asperity_run
import wedge_runs
from comparisons import assert_same_results

OUTPUT = wedge_runs.settings(
    "Mesh/Deep Wedge/Cell Size=0.05", "Output/Receivers/On Fault/middle={0.27, 0, 0.04}",
    "Output/Receivers/Off Fault/above={0.27, 0.05, 0.04}",
    # every step has its row, so that the one where a run ends is no more than others
    "Output/Fault History/Every n Steps=1", "Output/Surface History/Every n Steps=1")
PRESCRIBED = [*wedge_runs.RUPTURE, *wedge_runs.GLASS, *OUTPUT,
              *wedge_runs.settings("Time Stepping/Final Time=0.016")]
ADAPTIVE = [*wedge_runs.GLASS, *OUTPUT, *wedge_runs.settings(
    "Time Stepping/Final Time=0.2", "Time Stepping/Step Doubling/Tolerance=1e-3")]
SERIES = ["fault.h5", "surface.h5", "receivers.h5", "rupture.h5"]
TABLES = ["steps.csv", "events.csv", "global.csv"]


class Restart(unittest.TestCase):
    def check(self, name, run, end, ranks=1, series=tuple(SERIES)):
        """Ends the run at a time `end` before its own, an instant of both, and continues it."""
        run = [*run, *wedge_runs.settings(f"Time Stepping/Instants={{{end}}}")]
        whole = wedge_runs.run_deck(f"{name}_whole", *run, ranks=ranks)
        folder = wedge_runs.run_deck(f"{name}_continued", *run,
                                     *wedge_runs.settings(f"Time Stepping/Final Time={end}"),
                                     ranks=ranks)
        num_steps = [len(asperity_run.table(each / "steps.csv")) for each in (whole, folder)]
        self.assertGreater(num_steps[0], num_steps[1] + 3)
        self.assertGreater(num_steps[1], 3)
        shutil.copy(folder / "checkpoint.h5", f"{name}_checkpoint.h5")
        asperity_run.go_on(folder, wedge_runs.DECK, *run, ranks=ranks, timeout=300,
                           checkpoint=f"{name}_checkpoint.h5")
        assert_same_results(whole, folder, series, TABLES)

    def test_adaptive_steps(self):
        self.check("adaptive", ADAPTIVE, end=0.05)

    def test_prescribed_steps_on_two_ranks(self):
        self.check("prescribed", PRESCRIBED, end=0.008, ranks=2, series=[*SERIES, "volume.h5"])


if __name__ == "__main__":
    unittest.main()
