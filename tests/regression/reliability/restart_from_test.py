"""A new run begins with the state of another run, whose mesh and fields may differ."""

import unittest

import asperity_run
import numpy
import runs

HALF, END = 0.05, 0.1  # [s]
SMOOTH = runs.settings("Time Stepping/Prescribed/Levels={2}",
                       "Initial State/alpha=-8 * exp(-((x - 0.2625) / 0.03)^2)")
DECK = [runs.DECK, "--overlay", runs.DECK.parent / "rupture.xml", *SMOOTH]
SHORT = runs.settings(f"Time Stepping/Final Time={HALF}")
FINE = runs.settings("Mesh/Wedge/Cell Size=0.005")
FIELDS = ("fields/alpha", "fields/slip", "fields/slip_rate")


def fields(folder):
    return asperity_run.series(folder / "fault.h5")


def largest_difference(ours, theirs):
    return numpy.abs(ours - theirs).max() / numpy.abs(theirs).max()


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
        result = asperity_run.run(*DECK, *FINE, "--restart", folder / "checkpoint.h5", "--output",
                                  folder)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        runs.assert_same_results(self, self.new_run("unbroken", *FINE), folder, ("fault.h5",))

    def assert_refused(self, *arguments, pieces, run=None):
        result = asperity_run.run(*DECK, *arguments, "--restart-from", run or self.other,
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


if __name__ == "__main__":
    unittest.main()
