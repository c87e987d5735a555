"""Every deck in xml/ is valid as it stands, and the program prints what a deck may contain."""

import unittest
import xml.etree.ElementTree as ElementTree

import asperity_run
from deck_meshes import DECKS, make_meshes, meshes_of
from mesh_files import MESH_TOOL


class Decks(unittest.TestCase):
    def test_there_are_decks(self):
        names = {deck.name for deck in DECKS}
        self.assertLessEqual({"spring_slider.xml", "wedge_2d.xml", "wedge_2d_thesis.xml",
                              "wedge_2d_printed.xml"}, names)

    def test_all_are_valid(self):
        # asperity-mesh is there only where Gmsh is.
        decks = [deck for deck in DECKS if MESH_TOOL.exists() or not meshes_of(deck)]
        for deck in decks:
            make_meshes(deck)
        before = asperity_run.checksums(".")
        for deck in decks:
            with self.subTest(deck.name):
                result = asperity_run.run(deck, "--validate")
                self.assertEqual((result.returncode, result.stderr), (0, ""))
                self.assertIn(f"{deck} is valid", result.stdout)
        self.assertEqual(asperity_run.checksums("."), before)

    def test_size_and_resolution_are_said(self):
        wedge = asperity_run.SOURCE / "xml" / "wedge_2d.xml"
        result = asperity_run.run(wedge, "--validate")
        self.assertRegex(result.stdout, r"Mesh: \d+ triangles, 1364 vertices, 2728 unknowns; cells "
                                        r"have diameters of 0\.00\d+ to 0\.\d+ m\.")
        self.assertRegex(result.stdout, r"Memory: [\d.]+ MB on all ranks")
        self.assertIn("cells of 0.00202 m; cohesive zone", result.stdout)
        self.assertNotIn("WARNING", result.stdout)
        coarse = asperity_run.run(wedge, "--validate", "--set", "Friction/L=1e-6")
        self.assertEqual(coarse.returncode, 0)
        self.assertIn("WARNING: The cohesive zone has fewer than 3 cells", coarse.stdout)
        ranks = asperity_run.run(wedge, "--validate", "--set",
                                 "TNNMG/Linear Correction=Multigrid", ranks=2)
        self.assertIn("multigrid usually takes", ranks.stdout)
        mesh = [line.split(";")[0] for text in (result.stdout, ranks.stdout)
                for line in text.splitlines() if line.startswith("Mesh: ")]
        self.assertEqual(mesh[0], mesh[1])

    def test_a_spoilt_deck_is_not(self):
        for change in ("Friction/a=-1", "Output/Fault History/Fields={slip_rat}",
                       "Boundary Conditions/Backstop/Boundary=rigth"):
            result = asperity_run.run(DECKS[0], "--validate", "--set", change)
            self.assertEqual(result.returncode, 2, change)
            self.assertNotIn("is valid", result.stdout)


class PrintedParameters(unittest.TestCase):
    def print_parameters(self, *arguments, ranks=1):
        result = asperity_run.run("--print-parameters", *arguments, ranks=ranks)
        self.assertEqual((result.returncode, result.stderr), (0, ""))
        return result.stdout

    def test_as_text(self):
        text = self.print_parameters()
        for name in ("Largest Step", "Reference Slip Rate", "Poisson's Ratio", "Event Catalogue",
                     "Linear Correction", "Seismogenic Zone Width", "Multigrid"):
            self.assertIn(name, text)
        self.assertIn("(0, inf)", text)
        for law in ("Law = Regularised", "Law = Truncated", "State Evolution = Ageing",
                    "State Evolution = Slip"):
            self.assertIn(f"\nAsperity / Friction, with {law}\n", text)
        self.assertEqual(self.print_parameters("--format=text"), text)

    def test_as_xml(self):
        text = self.print_parameters("--format=xml")
        self.assertIn("Boundary Conditions", text)  # a comment: its lists are named by the user
        root = ElementTree.fromstring(text)
        self.assertEqual((root.tag, root.get("name")), ("ParameterList", "Asperity"))
        lists = {item.get("name"): item for item in root}
        for name in ("Mesh", "Bulk", "Friction", "Initial State", "Time Stepping", "Coupling",
                     "TNNMG", "Output"):
            self.assertIn(name, lists)
        names = {item.get("name") for item in lists["Coupling"].iter("Parameter")}
        self.assertEqual(names, {"Tolerance", "Norm", "Maximum Iterations", "Anderson Depth"})

    def test_once_on_two_ranks(self):
        self.assertEqual(self.print_parameters(ranks=2), self.print_parameters())


if __name__ == "__main__":
    unittest.main()
