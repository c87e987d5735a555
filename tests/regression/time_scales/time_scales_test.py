"""The decks that go from milliseconds to centuries, each in a hurry: on cells that are too large,
laid over with the short files in this folder. What they find differs from the full decks' answers,
by how much is said below; a change of these numbers is a change of the method.
"""

import pathlib
import unittest

import numpy

import asperity_run
from sequence import YEAR, sequence, slip_in_events

HERE = pathlib.Path(__file__).parent


class Deck(unittest.TestCase):
    def run_deck(self, deck, overlay):
        folder = asperity_run.run_to_end(deck, asperity_run.SOURCE / f"xml/{deck}.xml",
                                         "--overlay", HERE / overlay, timeout=300)
        self.folder = folder
        self.events = asperity_run.table(folder / "events.csv")
        self.steps = asperity_run.table(folder / "steps.csv")
        return folder

    def assert_within(self, value, expected, fraction):
        self.assertLess(abs(value / expected - 1.0), fraction, f"{value} instead of {expected}")

    def onsets(self):
        """Of events a day or more after the one before, in years."""
        return numpy.array([rows[0]["onset"] for rows in sequence(self.folder)]) / YEAR

    def coupled_steps_each(self):
        return sum(row["coupled_steps"] for row in self.steps) / len(self.steps)

    def assert_balance(self, fraction):
        """The energy of the whole run, relative to the work of friction."""
        last = self.steps[-1]
        self.assertLess(abs(last["energy_defect"]), fraction * last["friction_work"])


class StrikeSlip(Deck):
    """BP1 on cells of 200 m. With 100 m and less: 196.4 years, then 76 years quasi-dynamic and
    about 115 years with inertia."""

    def test_quasi_dynamic(self):
        self.run_deck("bp1_qd", "short_bp1.xml")
        onsets = self.onsets()
        self.assertEqual(len(onsets), 2)
        self.assert_within(onsets[0], 191.8, 0.01)
        self.assert_within(onsets[1] - onsets[0], 75.9, 0.02)
        self.assertLess(self.coupled_steps_each(), 1.6)
        self.assert_balance(1e-10)

    def test_inertia_lets_more_slip(self):
        """3.96 m in the first event (4.08 m on a fine mesh) instead of 2.82 m, and a longer wait
        for the second one. How much longer is ill-conditioned: millimetres of slip decide which
        swing of the creeping zone runs away."""
        folder = self.run_deck("bp1_fd", "short_bp1.xml")
        onsets = self.onsets()
        self.assertEqual(len(onsets), 2)
        self.assert_within(onsets[0], 191.8, 0.01)
        self.assertGreater(onsets[1] - onsets[0], 1.1 * 75.9)
        self.assert_within(slip_in_events(folder, "dp050")[0], 3.96, 0.01)
        self.assertLess(self.coupled_steps_each(), 1.6)
        self.assert_balance(1e-10)


class Rupture(Deck):
    """TPV101 on cells of 200 m, on which the rupture runs ahead by 5 percent."""

    def test_arrivals(self):
        folder = self.run_deck("tpv101_2d", "short_tpv101.xml")
        rupture = asperity_run.series(folder / "rupture.h5")
        x = rupture["geometry/positions"]
        arrivals = numpy.interp([0, 2500, 5000, 7500, 9000, 12000], x,
                                rupture["first_rupture_time"])
        references = [0.569, 1.657, 2.615, 3.474, 3.978, 4.974]
        expected = [1.0, 0.995, 0.951, 0.954, 0.956, 0.960]
        for arrival, reference, ratio in zip(arrivals, references, expected):
            self.assert_within(arrival, ratio * reference, 0.01)
        slip = abs(asperity_run.series(folder / "receivers.h5")["on_fault/fields/slip"][-1])
        for station, reference in ((0, 10.16), (2, 7.25), (4, 5.62)):
            self.assert_within(slip.reshape(-1)[station], reference, 0.04)


class Megathrust(Deck):
    """The wedge of 200 km on cells of 1.6 km, with a characteristic distance of 4 cm."""

    def test_cycle(self):
        self.run_deck("megathrust_2d", "short_megathrust.xml")
        onsets = self.onsets()
        self.assertEqual(len(onsets), 2)
        self.assert_within(onsets[0], 33.4, 0.02)
        self.assert_within(onsets[1] - onsets[0], 205.9, 0.02)
        self.assertGreater(self.events[0]["width"], 80e3)
        self.assertLess(self.coupled_steps_each(), 1.6)
        self.assert_balance(1e-10)


if __name__ == "__main__":
    unittest.main()
