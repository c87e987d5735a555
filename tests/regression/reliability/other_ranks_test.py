"""A checkpoint of some ranks is continued by others."""

import unittest

import asperity_run
import comparisons
import numpy
import runs

PARALLEL = runs.DECK.parent
SOLID = asperity_run.SOURCE / "tests" / "regression" / "solid"
# Steps are prescribed, so that everything must agree to the solver's tolerance.
PLANE = [runs.DECK, "--overlay", PARALLEL / "rupture.xml",
         *runs.settings("TNNMG/Linear Correction=Multigrid", "Output/Checkpoint Every n Steps=5",
                        "Output/Event Catalogue/Threshold=1e-4")]
SPACE = [*PLANE, "--overlay", SOLID / "glass_wedge.xml",
         *runs.settings("Mesh/Deep Wedge/Cell Size=0.05")]
ADAPTIVE = [runs.DECK, *runs.settings(
    "Time Stepping/Final Time=5", "Time Stepping/Step Doubling/Tolerance=1e-3",
    "Mesh/Wedge/Cell Size=0.02", "TNNMG/Linear Correction=Multigrid")]
FREQUENT = runs.settings("Output/Checkpoint Every n Steps=10")
FAULTS = [asperity_run.SOURCE / "xml" / "tpv101_two_sided.xml", *runs.settings(
    "Mesh/Rectangle/Cell Size Factor=8")]
# In equilibrium: a single rank condenses it to its fault.
STRIP = [asperity_run.SOURCE / "tests" / "verification" / "back_slip" / "strip.xml",
         *runs.settings("Boundary Conditions/Fault/Plate Rate=1e-4", "Time Stepping/Final Time=4")]


def checkpoint_values(folder):
    return asperity_run.series(folder / "checkpoint.h5")


class OtherRanks(unittest.TestCase):
    def run_on(self, folder, deck, ranks):
        return asperity_run.run_to_end(folder, *deck, ranks=ranks, timeout=200)

    def go_on(self, folder, deck, ranks):
        result = asperity_run.run(*deck, "--restart", folder / "checkpoint.h5", "--output", folder,
                                  ranks=ranks, timeout=200)
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertNotIn("asperity: ", result.stderr)

    def assert_same_fields(self, whole, folder, largest):
        for name in ("fault.h5", "volume.h5"):
            ours, theirs = (asperity_run.series(each / name) for each in (whole, folder))
            for dataset in ("time", "step", "geometry/coordinates", "geometry/vertex_ids"):
                numpy.testing.assert_array_equal(ours[dataset], theirs[dataset], dataset)
            for dataset, values in ours.items():
                if dataset.startswith("fields/"):
                    error = comparisons.largest_difference(theirs[dataset], values)
                    self.assertLess(error, largest, dataset)

    def check(self, name, deck, end, chain, largest):
        """Ends a run at a time `end` before its own, and continues it on other ranks."""
        deck = [*deck, *runs.settings(f"Time Stepping/Instants={{{end}}}")]
        whole = self.run_on(f"{name}_whole", deck, 1)
        short = [*deck, *runs.settings(f"Time Stepping/Final Time={end}")]
        folder = self.run_on(f"{name}_continued", short, chain[0])
        for ranks in chain[1:]:
            self.go_on(folder, deck, ranks)
        self.assert_same_fields(whole, folder, largest)
        ours, theirs = (asperity_run.table(each / "events.csv") for each in (whole, folder))
        self.assertEqual(len(ours), len(theirs))
        self.assertGreater(len(ours), 0)
        for event, other in zip(ours, theirs):
            for column in ("onset", "end", "peak_slip", "peak_slip_rate"):
                self.assertAlmostEqual(other[column] / event[column], 1, 5, column)

    def test_one_to_three(self):
        self.check("one_to_three", PLANE, 0.006, (1, 3), 1e-9)

    def test_three_to_two_in_space(self):
        self.check("three_to_two", SPACE, 0.006, (3, 2), 1e-8)

    def there_and_back(self, name, deck, ranks, rounding=0):
        """Stops a run of one rank in the middle. Without a step in between, nothing may change."""
        first = runs.fresh(name)
        runs.stop(self, runs.begin(first, *deck))
        begin = checkpoint_values(first)
        # That waves do not cross the body in so short a time is a warning of its own.
        deck = [*deck, *runs.settings("Time Stepping/Final Time=1e-9")]
        for number in (*ranks, 1):
            self.go_on(first, deck, number)
        end = checkpoint_values(first)
        kept, there = ([path for path in each if path.startswith("values/")
                        and not any(word in path for word in ("segment", "num_bytes", "wall_time",
                                                              "values/warnings"))]
                       for each in (begin, end))
        self.assertEqual(kept, there)
        self.assertGreater(len([path for path in kept if path.endswith("/alpha")]), 0)
        for path in kept:
            largest = rounding * numpy.abs(begin[path]).max(initial=0)
            numpy.testing.assert_allclose(begin[path], end[path], 0, largest, err_msg=path)
        return first

    def test_there_and_back(self):
        self.there_and_back("there_and_back", [*ADAPTIVE, *FREQUENT], (2, 3))

    def test_two_bodies_there_and_back(self):
        self.there_and_back("two_bodies", [*FAULTS, *FREQUENT], (2,))

    def test_condensed_there_and_back(self):
        folder = self.there_and_back("condensed", [*STRIP, *FREQUENT], (2,), 1e-12)
        self.assertIn("condensed to its fault", (folder / "run.log").read_text())

    def test_condensed_and_not(self):
        """The condensed run, continued by ranks that do not condense, and the other way round."""
        deck = [*STRIP, *runs.settings("Time Stepping/Instants={1}",
                                       "Output/Fault History/Every n Steps=1")]
        whole = self.run_on("condensed_whole", deck, 1)
        for chain in ((1, 2), (2, 1)):
            folder = self.run_on("condensed_changed",
                                 [*deck, *runs.settings("Time Stepping/Final Time=1")], chain[0])
            self.go_on(folder, deck, chain[1])
            ours, theirs = (asperity_run.table(each / "steps.csv") for each in (whole, folder))
            self.assertEqual(ours[-1]["time"], theirs[-1]["time"])
            self.assertLess(abs(len(ours) - len(theirs)), 0.05 * len(ours))
            for name in ("slip", "alpha"):
                ends = [asperity_run.series(each / "fault.h5")["fields/" + name][-1]
                        for each in (whole, folder)]
                error = comparisons.largest_difference(ends[1], ends[0])
                self.assertLess(error, 1e-4, f"{chain} {name}")

    def test_adaptive_steps(self):
        """A decision may flip: the times of the steps stay close."""
        deck = [*ADAPTIVE, *runs.settings("Time Stepping/Instants={2.5}")]
        whole = self.run_on("adaptive_whole", deck, 1)
        folder = self.run_on("adaptive_continued",
                             [*deck, *runs.settings("Time Stepping/Final Time=2.5")], 2)
        self.go_on(folder, deck, 1)
        ours, theirs = (asperity_run.table(each / "steps.csv") for each in (whole, folder))
        self.assertEqual(ours[-1]["time"], theirs[-1]["time"])
        self.assertLess(abs(len(ours) - len(theirs)), 0.05 * len(ours))

    def test_other_mesh_is_still_refused(self):
        folder = self.run_on("other_mesh", ADAPTIVE, 2)
        result = asperity_run.run(*ADAPTIVE, *runs.settings("Mesh/Wedge/Cell Size=0.03"),
                                  "--restart", folder / "checkpoint.h5", "--output", folder)
        runs.assert_one_message(self, result, runs.INPUT, "belongs to another deck")


if __name__ == "__main__":
    unittest.main()
