"""A new run begins with the state of another run, whose mesh and fields may differ."""

import unittest

import asperity_run
import numpy
import runs
from comparisons import assert_same_results, largest_difference

HALF, END = 0.05, 0.1  # [s]
SMOOTH = runs.settings("Time Stepping/Prescribed/Levels={2}",
                       "Initial State/alpha=-8 * exp(-((x - 0.2625) / 0.03)^2)")
DECK = [runs.DECK, "--overlay", runs.DECK.parent / "rupture.xml", *SMOOTH]
SHORT = runs.settings(f"Time Stepping/Final Time={HALF}")
FINE = runs.settings("Mesh/Wedge/Cell Size=0.005")
SQUARE = asperity_run.SOURCE / "tests" / "regression" / "bad_input" / "square.xml"
# A square that is cut in two, of which the upper half is driven.
CUT = [SQUARE, *runs.settings(
    "Mesh/Faults/main=abs(y - 0.5) < 1e-6", "Boundary Conditions/Fault/Boundary=main",
    "Boundary Conditions/Fault/Type=Two-Sided Fault", "Boundary Conditions/Ground/Boundary=bottom",
    "Boundary Conditions/Ground/Type=Fixed", "Friction/a=0.015 + 0.01 * x",
    "Friction/Normal Stress=1", "Boundary Conditions/Drive/Velocity=1e-5",
    "Time Stepping/Prescribed/Levels={2}",
    "Output/Volume Snapshots/Enabled=true", "Output/Volume Snapshots/Precision=Double",
    "Output/Fault History/Precision=Double",
    "Output/Volume Snapshots/Fields={displacement, velocity}", "Time Stepping/Final Time=0.4")]
CUT_SHORT = runs.settings("Time Stepping/Final Time=0.2")
FIELDS = ("fields/alpha", "fields/slip", "fields/slip_rate")


def fields(folder):
    return asperity_run.series(folder / "fault.h5")


def values_at_places(series, field, row):
    """{place: vectors, sorted} of a field in the body; a place on a fault has two."""
    places = {}
    vectors = series[f"fields/{field}"][row]
    for place, vector in zip(series["geometry/coordinates"], vectors):
        places.setdefault(tuple(numpy.round(place, 9)), []).append(tuple(vector))
    return {place: numpy.array(sorted(vectors)) for place, vectors in places.items()}


class RestartFrom(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.other = asperity_run.run_to_end("other", *DECK, *SHORT)

    def new_run(self, name, *arguments, ranks=1):
        return asperity_run.run_to_end(name, *DECK, *arguments, "--restart-from", self.other,
                                       ranks=ranks)

    def test_on_the_same_mesh_as_the_run_itself(self):
        whole = fields(asperity_run.run_to_end("whole", *DECK))
        ours = fields(self.new_run("same"))
        first = int(numpy.searchsorted(whole["time"], HALF))
        numpy.testing.assert_allclose(ours["time"], whole["time"][first:], rtol=1e-14)
        for name in FIELDS:
            self.assertLess(largest_difference(ours[name], whole[name][first:]), 1e-8, name)

    def test_on_a_mesh_of_half_the_size(self):
        before, after = fields(self.other), fields(self.new_run("fine", *FINE))
        places, new_places = before["geometry/positions"], after["geometry/positions"]
        self.assertGreater(len(new_places), 1.5 * len(places))
        self.assertAlmostEqual(after["time"][0], HALF, places=14)
        self.assertAlmostEqual(after["time"][-1], END, places=14)
        for name in FIELDS:
            expected = numpy.interp(new_places, places, before[name][-1].reshape(len(places)))
            ours = after[name][0].reshape(len(new_places))
            self.assertLess(largest_difference(ours, expected), 1e-9, name)
            # What comes after is what the coarse mesh has, too, as far as it resolves it.
            whole = before[name][-1]
            self.assertTrue(numpy.isfinite(after[name]).all())
            self.assertLess(numpy.abs(after[name]).max(), 10 * numpy.abs(whole).max())

    def test_on_other_ranks(self):
        one, two = (fields(self.new_run(f"ranks_{n}", *FINE, ranks=n)) for n in (1, 2))
        for name in FIELDS:
            self.assertLess(largest_difference(two[name], one[name]), 1e-8, name)

    def test_own_checkpoint_is_restarted_as_any(self):
        short = runs.settings("Time Stepping/Final Time=0.075")
        folder = self.new_run("chain", *FINE, *short)
        asperity_run.go_on(folder, *DECK, *FINE)
        assert_same_results(self.new_run("unbroken", *FINE), folder, ("fault.h5",))

    def test_across_a_fault_on_the_same_mesh(self):
        """On two ranks to the tolerance of the solver, by which runs on one and two differ. Limits
        chosen when the differences were known: 3e-14 on one rank, 1.3e-7 on two."""
        other = asperity_run.run_to_end("cut_other", *CUT, *CUT_SHORT)
        for ranks in (1, 2):
            whole = asperity_run.run_to_end(f"cut_whole_{ranks}", *CUT, ranks=ranks)
            ours = asperity_run.run_to_end(f"cut_same_{ranks}", *CUT, "--restart-from", other,
                                           ranks=ranks)
            slip = asperity_run.series(whole / "fault.h5")["fields/slip"][-1]
            moved = asperity_run.series(whole / "volume.h5")["fields/displacement"][-1]
            self.assertGreater(numpy.abs(slip).max(), 0.1 * numpy.abs(moved).max())
            for name, field in (("fault.h5", "alpha"), ("fault.h5", "slip"),
                                ("volume.h5", "displacement"), ("volume.h5", "velocity")):
                expected = asperity_run.series(whole / name)[f"fields/{field}"][-1]
                last = asperity_run.series(ours / name)[f"fields/{field}"][-1]
                self.assertLess(largest_difference(last, expected), 1e-12 if ranks == 1 else 1e-6,
                                (ranks, field))

    def test_across_a_fault_on_a_finer_mesh(self):
        """At vertices of the coarse mesh, on both sides of the fault, the values are the same."""
        other = asperity_run.run_to_end("cut_coarse", *CUT, *CUT_SHORT)
        fine = asperity_run.run_to_end("cut_fine", *CUT, *runs.settings("Mesh/Refinements=1"),
                                       "--restart-from", other)
        before, after = (asperity_run.series(each / "volume.h5") for each in (other, fine))
        for field in ("displacement", "velocity"):
            expected = values_at_places(before, field, -1)
            ours = values_at_places(after, field, 0)
            size = max(numpy.abs(values).max() for values in expected.values())
            self.assertEqual({place: len(values) for place, values in expected.items()},
                             {place: len(ours[place]) for place in expected})
            for place, values in expected.items():
                self.assertLess(numpy.abs(ours[place] - values).max(), 1e-9 * size, place)
        # The two sides of the fault have moved apart.
        jumps = [values for values in values_at_places(before, "displacement", -1).values()
                 if len(values) == 2]
        self.assertGreater(max(numpy.ptp(values[:, 0]) for values in jumps), 0)

    def assert_refused(self, *arguments, pieces, run=None, deck=DECK):
        result = asperity_run.run(*deck, *arguments, "--restart-from", run or self.other,
                                  "--output", runs.fresh("refused"))
        runs.assert_one_message(self, result, runs.INPUT, *pieces)
        self.assertFalse(runs.fresh("refused").exists())

    def test_what_does_not_fit_is_refused_by_name(self):
        self.assert_refused(*runs.settings("Friction/State Evolution=Slip"),
                            pieces=("State Evolution is 'Slip', but 'Ageing'", "other"))
        self.assert_refused("--overlay", asperity_run.SOURCE / "tests" / "regression" / "solid" /
                            "glass_wedge.xml", pieces=("number of dimensions", "'3'", "'2'"))
        self.assert_refused(*runs.settings("Mesh/Wedge/Length=1.2"),
                            pieces=("The point (", "m outside"))
        self.assert_refused(*runs.settings("Time Stepping/Final Time=0.01"),
                            pieces=("Final Time = 0.01 s is not after",))
        self.assert_refused(pieces=("parameters.xml",), run="nowhere")
        self.assert_refused("--restart", self.other / "checkpoint.h5",
                            pieces=("Give one of the two",))

    def test_rock_that_relaxes_otherwise_is_refused(self):
        def maxwell(viscosity):
            return [*CUT, *runs.settings("Bulk/Law=Maxwell", f"Bulk/Viscosity={viscosity}")]

        other = asperity_run.run_to_end("flowing", *maxwell(1e6), *CUT_SHORT)
        self.assert_refused(deck=maxwell(2e6), run=other,
                            pieces=("relaxation times", "'2'", "'1'"))
        self.assert_refused(deck=CUT, run=other, pieces=("relaxation times", "'none'", "'1'"))
        asperity_run.run_to_end("flows_on", *maxwell(1e6), "--restart-from", other)


if __name__ == "__main__":
    unittest.main()
