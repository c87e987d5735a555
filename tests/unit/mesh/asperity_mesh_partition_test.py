"""asperity-mesh partition: balance, the way from 8 parts to 2, and what it refuses."""

import pathlib
import re
import unittest

import h5py
import numpy

import mesh_tool


def datasets(name):
    """All datasets of a file and its attributes."""
    with h5py.File(name) as file:
        found = {}
        file.visititems(lambda path, item: found.update(
            {path: item[()].tolist()} if isinstance(item, h5py.Dataset) else {}))
        return found, {key: numpy.array(value).tolist() for key, value in file.attrs.items()}


def balance(output):
    """Largest part over the mean: of all vertices, and of those of the boundary."""
    return [float(number) for number in re.findall(r"(?:vertices|base) ([\d.]+)", output)[-2:]]


class Partition(mesh_tool.Case):
    def setUp(self):
        super().setUp()
        self.assert_done("wedge", "wedge.h5")

    def partition(self, source, parts, target, *options):
        return self.assert_done("partition", source, "--parts", str(parts), "--output", target,
                                *options)

    def test_balances_the_fault(self):
        output = self.partition("wedge.h5", 8, "wedge_8.h5", "--boundary", "base")
        self.assertIn("wedge_8.h5: 8 parts of 4789 vertices, 9246 cells\n", output)
        vertices, base = balance(output)
        self.assertTrue(1.0 <= vertices < 1.1 and 1.0 <= base < 1.1, output)
        with h5py.File("wedge_8.h5") as file:
            owned = file["num_owned/values"][:]
            self.assertEqual(owned.sum(), 4789)
            self.assertAlmostEqual(vertices, owned.max() * 8 / 4789, places=4)
            offsets = file["boundaries/base/facets/offsets"][:]
            facets = file["boundaries/base/facets/values"][:]
            # A part lists the facets that touch its vertices; those it owns of the base:
            counts = [len({v for v in facets[offsets[p]:offsets[p + 1]].ravel() if v < owned[p]})
                      for p in range(8)]
            self.assertEqual(sum(counts), 262)
            self.assertAlmostEqual(base, max(counts) * 8 / 262, places=4)

    def test_from_eight_to_two(self):
        self.partition("wedge.h5", 8, "wedge_8.h5", "--boundary", "base")
        self.assertIn("those of boundary base",
                      self.partition("wedge_8.h5", 2, "by_way_of_8.h5"))
        self.partition("wedge.h5", 2, "directly.h5", "--boundary", "base")
        self.assertEqual(datasets("by_way_of_8.h5"), datasets("directly.h5"))
        info = self.assert_done("info", "by_way_of_8.h5")
        self.assertRegex(info, r"parts +2, with boundary base balanced\n"
                               r"fingerprint +[0-9a-f]{16}\n")
        self.assertEqual(info.split("\n", 2)[2], self.assert_done("info", "wedge.h5"))

    def test_refuses_options(self):
        target = ["--output", "out.h5"]
        for options, pieces in ((["--parts", "0"], ["--parts = 0", "[1, inf)"]),
                                (["--parts", "5000"], ["4789 vertices", "5000"]),
                                (["--parts", "two"], ["--parts", "'two'"]),
                                ([], ["--parts is missing"]),
                                (["--parts", "2", "--boundary", "bass"], ["Did you mean 'base'?"]),
                                (["--parts", "2", "--boundary-weight", "0"], ["= 0", "[1, inf)"])):
            self.assert_refused(["partition", "wedge.h5", *options, *target], *pieces)
        self.assert_refused(["partition", "wedge.h5", "--parts", "2"], "--output is missing")
        self.assert_refused(["partition", "wedge.h5", "--parts", "2", "--output", "wedge.h5"],
                            "'wedge.h5' is there already", "--overwrite")
        self.assert_refused(["partition", "none.h5", "--parts", "2", *target], "does not exist")
        self.assertFalse(pathlib.Path("out.h5").exists())


class BadMeshes(mesh_tool.Case):
    """Whole meshes and partitioned ones, through partition and info alike."""

    def assert_bad(self, name, *pieces):
        pieces = (f"'{name}'", *pieces)
        self.assert_refused(["info", name], *pieces)
        self.assert_refused(["partition", name, "--parts", "2", "--output", "out.h5"], *pieces)
        self.assertFalse(pathlib.Path("out.h5").exists())

    def setUp(self):
        super().setUp()
        self.assert_done("box", "box.h5", "--cells-x", "3", "--cells-y", "3", "--cells-z", "3")
        self.assert_done("partition", "box.h5", "--parts", "2", "--output", "box_2.h5")

    def test_tetrahedron_turned_over(self):
        with h5py.File("box.h5", "r+") as file:
            cell = file["cells"][17]
            file["cells"][17] = cell[[1, 0, 2, 3]]
        self.assert_bad("box.h5", "cell 17", "inverted")
        with h5py.File("box_2.h5", "r+") as file:
            cell = file["cells/values"][17]
            file["cells/values"][17] = cell[[1, 0, 2, 3]]
        self.assert_bad("box_2.h5", "part 0 of '/cells'", "checksum")

    def test_fault_inside_the_body(self):
        with h5py.File("box.h5", "r+") as file:
            del file.attrs["checksum"]
            x = file["vertices"][:]
            middle = [cell[numpy.isclose(x[cell, 1], 1 / 3)] for cell in file["cells"][:]]
            inside = next(facet for facet in middle if len(facet) == 3)
            file["boundaries/bottom/facets"][0] = inside
        self.assert_bad("box.h5", "boundary 'bottom'", "inside the body")

    def test_truncated(self):
        for name in ("box.h5", "box_2.h5"):
            content = pathlib.Path(name).read_bytes()
            pathlib.Path(name).write_bytes(content[:len(content) * 2 // 3])
            self.assert_bad(name, "truncated")

    def test_parts_of_another_mesh(self):
        self.assert_done("box", "other.h5", "--cells-x", "3", "--cells-y", "3", "--cells-z", "3",
                         "--depth", "2")
        self.assert_done("partition", "other.h5", "--parts", "2", "--output", "other_2.h5")
        with h5py.File("box_2.h5", "r+") as file, h5py.File("other_2.h5") as other:
            del file["vertices"]
            other.copy("vertices", file)
        self.assert_bad("box_2.h5", "part 0 of '/vertices'", "put together from several")


if __name__ == "__main__":
    unittest.main()
