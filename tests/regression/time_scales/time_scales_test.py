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
        return asperity_run.run_to_end(deck, asperity_run.SOURCE / f"xml/{deck}.xml", "--overlay",
                                       HERE / overlay, timeout=300)

    def run_cycle(self, deck, overlay, first, tolerance):
        """Two events, the first after so many years: the folder, and the years between them.

        Of events within a day the first counts. The energy is that of the whole run.
        """
        folder = self.run_deck(deck, overlay)
        onsets = numpy.array([rows[0]["onset"] for rows in sequence(folder)]) / YEAR
        self.assertEqual(len(onsets), 2)
        self.assert_within(onsets[0], first, tolerance)
        steps = asperity_run.table(folder / "steps.csv")
        self.assertLess(sum(row["coupled_steps"] for row in steps) / len(steps), 1.6)
        self.assertLess(abs(steps[-1]["energy_defect"]), 1e-10 * steps[-1]["friction_work"])
        return folder, onsets[1] - onsets[0]

    def assert_within(self, value, expected, fraction):
        self.assertLess(abs(value / expected - 1.0), fraction, f"{value} instead of {expected}")


class StrikeSlip(Deck):
    """BP1 on cells of 200 m. With 100 m and less: 196.4 years, then 76 years quasi-dynamic and
    about 115 years with inertia."""

    def test_quasi_dynamic(self):
        _, wait = self.run_cycle("bp1_qd", "short_bp1.xml", 191.8, 0.01)
        self.assert_within(wait, 75.9, 0.02)

    def test_inertia_lets_more_slip(self):
        """3.96 m in the first event (4.08 m on a fine mesh) instead of 2.82 m, and a longer wait
        for the second one. How much longer is ill-conditioned: millimetres of slip decide which
        swing of the creeping zone runs away."""
        folder, wait = self.run_cycle("bp1_fd", "short_bp1.xml", 191.8, 0.01)
        self.assertGreater(wait, 1.1 * 75.9)
        self.assert_within(slip_in_events(folder, "dp050")[0], 3.96, 0.01)


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
        folder, wait = self.run_cycle("megathrust_2d", "short_megathrust.xml", 33.4, 0.02)
        self.assert_within(wait, 205.9, 0.02)
        self.assertGreater(asperity_run.table(folder / "events.csv")[0]["width"], 80e3)


if __name__ == "__main__":
    unittest.main()
