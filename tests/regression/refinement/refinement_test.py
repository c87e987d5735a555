"""Runs on meshes that are refined when they are read: `Mesh / Refinements`.

The same on any number of ranks, and as on a mesh that the generator makes twice as fine.
"""

import pathlib
import sys
import unittest

import h5py
import numpy

import asperity_run
import runs
from asperity_run import settings
from comparisons import assert_same_results, largest_difference
from mesh_files import MESH_TOOL, mesh_tool

HERE = pathlib.Path(__file__).parent
BURIED = HERE / "buried_fault.xml"
TINY = HERE.parent / "tiny_wedge"
REFINED = "Mesh/Refinements=1"


class BuriedFault(unittest.TestCase):
    """Friction and a prescribed slip rate on faults inside a box, which end inside it."""

    def setUp(self):
        self.refined = self.run_deck("refined", 1, REFINED)

    @staticmethod
    def run_deck(name, ranks, *changes):
        folder = asperity_run.run_to_end(name, BURIED, *settings(*changes), ranks=ranks,
                                         timeout=100)
        return asperity_run.series(folder / "fault.h5")

    def assert_same_fields(self, ours, theirs, order):
        self.assertGreater(numpy.abs(theirs["fields/slip"]).max(), 1e-3)
        for name in ("fields/slip", "fields/slip_rate", "fields/alpha", "fields/traction"):
            self.assertLess(largest_difference(ours[name][:, order(ours)],
                                               theirs[name][:, order(theirs)]), 1e-10, name)

    def test_two_ranks(self):
        parallel = self.run_deck("two_ranks", 2, REFINED)
        for name in ("geometry/vertex_ids", "geometry/coordinates"):
            numpy.testing.assert_array_equal(parallel[name], self.refined[name])
        self.assert_same_fields(parallel, self.refined, lambda _: slice(None))

    def test_a_finer_box(self):
        finer = self.run_deck("finer", 1, *(f"Mesh/Box/Cells {axis}=8" for axis in "XYZ"))

        def by_place(series):
            return numpy.lexsort(series["geometry/coordinates"].T)

        numpy.testing.assert_array_equal(
            finer["geometry/coordinates"][by_place(finer)],
            self.refined["geometry/coordinates"][by_place(self.refined)])
        self.assert_same_fields(self.refined, finer, by_place)


class TinyWedge(unittest.TestCase):
    """A mesh from a file, whole and in parts."""

    @classmethod
    def setUpClass(cls):
        sys.path.insert(0, str(TINY))
        import tiny_wedge_test  # pylint: disable=import-outside-toplevel
        tiny_wedge_test.write_mesh()
        cls.alone = cls.run_deck("tiny_alone", 1, "tiny_wedge.h5")

    @staticmethod
    def run_deck(name, ranks, mesh):
        folder = asperity_run.run_to_end(
            name, TINY / "tiny_wedge.xml",
            *settings(f"Mesh/File/File Name={mesh}", REFINED, "TNNMG/Linear Correction=Multigrid"),
            ranks=ranks)
        return asperity_run.series(folder / "volume.h5")

    def assert_same(self, volume):
        for name in ("geometry/vertex_ids", "geometry/coordinates"):
            numpy.testing.assert_array_equal(volume[name], self.alone[name])
        for name in ("displacement", "velocity", "acceleration"):
            self.assertLess(largest_difference(volume["fields/" + name],
                                               self.alone["fields/" + name]), 1e-9, name)

    def test_it_is_refined(self):
        with h5py.File("tiny_wedge.h5") as file:
            cells = file["cells"][()]
        edges = {tuple(sorted(edge)) for a, b, c in cells for edge in ((a, b), (b, c), (c, a))}
        self.assertEqual(len(self.alone["geometry/coordinates"]), cells.max() + 1 + len(edges))

    def test_two_ranks(self):
        self.assert_same(self.run_deck("tiny_two", 2, "tiny_wedge.h5"))

    @unittest.skipUnless(MESH_TOOL.exists(), "asperity-mesh is not built")
    def test_in_parts(self):
        pathlib.Path("tiny_wedge_2.h5").unlink(missing_ok=True)
        mesh_tool("partition", "tiny_wedge.h5", "--parts", 2, "--output", "tiny_wedge_2.h5")
        self.assert_same(self.run_deck("tiny_parts", 2, "tiny_wedge_2.h5"))


class Restart(unittest.TestCase):
    def test_goes_on(self):
        for ranks in (1, 2):
            with self.subTest(ranks=ranks):
                whole = asperity_run.run_to_end("whole", BURIED, *settings(REFINED), ranks=ranks)
                half = asperity_run.run_to_end(
                    "half", BURIED, *settings(REFINED, "Time Stepping/Final Time=0.2"), ranks=ranks)
                asperity_run.go_on(half, BURIED, *settings(REFINED), ranks=ranks)
                assert_same_results(whole, half, ["fault.h5"], [])

    def test_not_on_another_mesh(self):
        asperity_run.run_to_end("half", BURIED,
                                *settings(REFINED, "Time Stepping/Final Time=0.2"))
        for changes in (["Mesh/Refinements=2"], []):
            result = asperity_run.run(BURIED, *settings(*changes), "--restart",
                                      "half/checkpoint.h5", "--output", "half")
            self.assertEqual(result.returncode, 2, result.stderr)
            self.assertIn("Asperity / Mesh / Refinements", result.stderr)


class BadInput(unittest.TestCase):
    def test_refused(self):
        cases = {"-1": ["Refinements = -1", "[0, inf)"], "1.5": ["Refinements", "1.5"],
                 "10": ["Refinements = 10", "Refine less often"],
                 "40": ["Refinements = 40", " bits can number"]}
        for value, pieces in cases.items():
            for ranks in (1, 2):
                with self.subTest(value=value, ranks=ranks):
                    result = asperity_run.run(BURIED, *settings(f"Mesh/Refinements={value}"),
                                              "--output", runs.fresh("bad"), ranks=ranks)
                    runs.assert_one_message(self, result, runs.INPUT, *pieces)


if __name__ == "__main__":
    unittest.main()
