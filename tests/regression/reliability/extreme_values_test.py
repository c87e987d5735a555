"""Values that a deck may have, but nobody can compute with, are refused with status 2 in one line
that names what to look at, without a nan of our own."""

import unittest

import asperity_run
import runs

DECK = asperity_run.SOURCE / "xml" / "wedge_2d.xml"


class ExtremeValues(unittest.TestCase):
    def assert_refused(self, change, *pieces):
        with self.subTest(change=change):
            result = asperity_run.run(DECK, "--validate", *runs.settings(change))
            runs.assert_one_message(self, result, runs.INPUT, *pieces)
            self.assertNotIn("nan", result.stderr)
            self.assertNotIn("internal error", result.stderr)

    def test_moduli(self):
        self.assert_refused("Bulk/Poisson's Ratio=0.4999999999", "Poisson's Ratio")
        self.assert_refused("Bulk/Shear Viscosity=1e308", "viscosities")
        self.assert_refused("Bulk/Bulk Modulus=1e308", "moduli")

    def test_density(self):
        self.assert_refused("Bulk/Density/upper=1e308", "Density")

    def test_cells(self):
        self.assert_refused("Mesh/Wedge/Cell Size=0.008", "is the cell size too large?")
        self.assert_refused("Mesh/Wedge/Growth Factor=1e308", "Growth Factor")
        self.assert_refused("Mesh/Wedge/Growth Length=1e-308", "Growth Length")
        self.assert_refused("Mesh/Wedge/Length=1e308", "Mesh: ", "extents")


if __name__ == "__main__":
    unittest.main()
