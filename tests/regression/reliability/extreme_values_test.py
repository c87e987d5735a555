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

    def test_forgotten_extents_and_sizes(self):
        """The mesh is refused before it is made."""
        for deck, entry in (("bp1_fd", "Rectangle/Width"),
                            ("megathrust_2d", "Wedge/Cell Size"),
                            ("megathrust_3d", "Deep Wedge/Cell Size")):
            with self.subTest(deck=deck, entry=entry):
                path = DECK.with_name(f"{deck}.xml")
                result = asperity_run.run(path, "--validate", "--remove", f"Mesh/{entry}",
                                          timeout=20)
                runs.assert_one_message(self, result, runs.INPUT, entry.split("/")[1],
                                        "vertices", "500000", "Asperity / Mesh / Most Vertices")

    def test_larger_meshes_are_made_where_they_are_allowed(self):
        few = runs.settings("Mesh/Most Vertices=1000")
        result = asperity_run.run(DECK, "--validate", *few)
        runs.assert_one_message(self, result, runs.INPUT, "more than 1000 vertices", "Cell Size",
                                "Asperity / Mesh / Most Vertices")


if __name__ == "__main__":
    unittest.main()
