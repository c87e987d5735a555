"""asperity-mesh, given as the first argument: converts Gmsh's files, refuses errors.

The files it makes are read with h5py, which knows nothing of the program that wrote them.
"""

import pathlib
import unittest

import h5py
import numpy

import mesh_tool

# A square of four triangles around (1, 1), two of them clockwise, in two regions. Node 9 is a point
# that only the geometry uses; tags have gaps.
NODES = {2: "0 0 0", 3: "2 0 0", 5: "2 2 0", 7: "0 2 0", 8: "1 1 0", 9: "5 5 0"}
NAMES = '1 1 "base"\n1 2 "sides"\n2 3 "lower"\n2 4 "upper"\n'
ELEMENTS = [
    "1 1 2 1 1 2 3",
    "2 1 2 2 2 3 5",
    "3 1 2 2 3 7 5",
    "4 1 2 2 4 2 7",
    "5 2 2 3 1 2 3 8",
    "6 2 2 3 1 3 8 5",
    "7 2 2 4 2 5 7 8",
    "8 2 2 4 2 7 8 2",
]


def msh(nodes=None, names=NAMES, elements=None):
    """Text of a mesh in Gmsh's format 2.2: element, type, 2, physical group, entity, nodes."""
    nodes = nodes or NODES
    elements = elements or ELEMENTS
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat"]
    if names:
        lines += ["$PhysicalNames", str(names.count("\n")), names.rstrip(), "$EndPhysicalNames"]
    lines += ["$Nodes", str(len(nodes)), *(f"{tag} {xyz}" for tag, xyz in nodes.items())]
    lines += ["$EndNodes", "$Elements", str(len(elements)), *elements, "$EndElements", ""]
    return "\n".join(lines)


# Two volumes of one tetrahedron each, on both sides of the triangle 1 2 3, in Gmsh's format 4.1.
TWO_VOLUMES = """$MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
3
2 7 "fault"
3 8 "below"
3 9 "above"
$EndPhysicalNames
$Entities
0 0 1 2
5 0 0 0 1 1 1 1 {surface} 0
3 0 0 -1 1 1 0 1 8 0
4 0 0 0 1 1 1 1 9 0
$EndEntities
$Nodes
1 5 1 5
3 3 0 5
1
2
3
4
5
0 0 0
1 0 0
0 1 0
0 0 1
0 0 -1
$EndNodes
$Elements
3 3 1 3
2 5 2 1
1 {triangle}
3 3 4 1
2 1 2 3 5
3 4 4 1
3 1 2 3 4
$EndElements
"""

CUBE = """$MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
2 1 "fault"
3 2 "rock"
$EndPhysicalNames
$Nodes
4
1 0 0 0
2 1 0 0
3 0 1 0
4 0 0 1
$EndNodes
$Elements
2
1 2 2 1 1 1 2 3
2 4 2 2 1 1 3 2 4
$EndElements
"""


class Convert(mesh_tool.Case):
    def assert_not_converted(self, text, *pieces):
        pathlib.Path("bad.msh").write_text(text)
        self.assert_refused(["convert", "bad.msh", "bad.h5"], "'bad.msh'", *pieces)
        self.assertFalse(pathlib.Path("bad.h5").exists())

    def test_square(self):
        pathlib.Path("square.msh").write_text(msh())
        self.assertIn("5 vertices, 4 cells", self.assert_done("convert", "square.msh", "square.h5"))
        with h5py.File("square.h5") as file:
            attributes = dict(file.attrs)
            self.assertRegex(attributes.pop("checksum").decode(), "^[0-9a-f]{16}$")
            self.assertEqual(attributes,
                             {"format": b"asperity-mesh", "version": 1, "dimension": 2})
            vertices, cells = file["vertices"][:], file["cells"][:]
            numpy.testing.assert_array_equal(vertices, [[0, 0], [2, 0], [2, 2], [0, 2], [1, 1]])
            names = file["region_names"].asstr()[:]
            self.assertEqual([names[r] for r in file["cell_regions"]],
                             ["lower", "lower", "upper", "upper"])
            self.assertEqual(set(file["boundaries"]), {"base", "sides"})
            # The body lies to the left of every facet.
            facets = [file[f"boundaries/{name}/facets"][:].tolist() for name in ("base", "sides")]
            self.assertEqual(facets, [[[0, 1]], [[1, 2], [2, 3], [3, 0]]])
        a, b, c = (vertices[cells[:, i]] for i in range(3))
        areas = 0.5 * numpy.cross(b - a, c - a)
        numpy.testing.assert_array_equal(areas, [1, 1, 1, 1])
        sets = [set(cell) for cell in cells.tolist()]
        self.assertEqual(sets, [{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {0, 3, 4}])

    def test_tetrahedron(self):
        pathlib.Path("cube.msh").write_text(CUBE)
        self.assert_done("convert", "cube.msh", "cube.h5")
        with h5py.File("cube.h5") as file:
            self.assertEqual(file.attrs["dimension"], 3)
            x = file["vertices"][:][file["cells"][0]]
            self.assertAlmostEqual(numpy.linalg.det(x[1:] - x[0]) / 6, 1 / 6)
            f = file["vertices"][:][file["boundaries/fault/facets"][0]]
            numpy.testing.assert_array_equal(numpy.cross(f[1] - f[0], f[2] - f[0]), [0, 0, -1])
        self.assertIn("volume           0.166667 m^3", self.assert_done("info", "cube.h5"))

    def test_two_volumes(self):
        text = TWO_VOLUMES.format(surface=7, triangle="1 2 4")
        pathlib.Path("two.msh").write_text(text)
        self.assert_done("convert", "two.msh", "two.h5")
        with h5py.File("two.h5") as file:
            names = file["region_names"].asstr()[:]
            regions = {names[region]: set(cell)
                       for region, cell in zip(file["cell_regions"], file["cells"][:])}
            self.assertEqual(regions, {"below": {0, 1, 2, 4}, "above": {0, 1, 2, 3}})
            x = file["vertices"][:]
            for cell in file["cells"]:
                self.assertAlmostEqual(numpy.linalg.det(x[cell[1:]] - x[cell[0]]), 1.0)
            self.assertEqual(list(file["boundaries"]), ["fault"])
            f = x[file["boundaries/fault/facets"][0]]
            numpy.testing.assert_array_equal(numpy.cross(f[1] - f[0], f[2] - f[0]), [0, -1, 0])
        pathlib.Path("two.msh").write_text(
            text.replace('3 9 "above"\n', "").replace("Names\n3", "Names\n2"))
        self.assert_done("convert", "two.msh", "two.h5", "--overwrite")
        with h5py.File("two.h5") as file:
            self.assertEqual(set(file["region_names"].asstr()), {"below", "region_9"})

    def test_a_fault_between_two_volumes(self):
        pathlib.Path("two.msh").write_text(TWO_VOLUMES.format(surface=7, triangle="1 2 3"))
        self.assertIn("0 boundaries, 1 faults", self.assert_done("convert", "two.msh", "two.h5"))
        self.assertIn("fault: 1 facets, 3 vertices, 0 tips", self.assert_done("info", "two.h5"))

    def test_missing_names(self):
        pathlib.Path("square.msh").write_text(
            msh(names=NAMES.replace('1 2 "sides"\n', "").replace('2 4 "upper"\n', "")))
        said = self.assert_done("convert", "square.msh", "square.h5")
        self.assertIn("physical Curve 2 has no name and is called 'boundary_2'", said)
        with h5py.File("square.h5") as file:
            self.assertEqual(set(file["boundaries"]), {"base", "boundary_2"})
            self.assertEqual(set(file["region_names"].asstr()), {"lower", "region_4"})

    def test_facets_in_two_groups(self):
        """Format 2.2 has them once for each group, and gives all copies to each."""
        pathlib.Path("square.msh").write_text(
            msh(names=NAMES + '1 5 "most"\n',
                elements=[*ELEMENTS, "9 1 2 5 1 2 3", "10 1 2 5 2 3 5"]))
        self.assert_done("convert", "square.msh", "square.h5")
        with h5py.File("square.h5") as file:
            facets = {name: sorted(map(sorted, group["facets"][:].tolist()))
                      for name, group in file["boundaries"].items()}
        self.assertEqual(facets, {"base": [[0, 1]], "sides": [[0, 3], [1, 2], [2, 3]],
                                  "most": [[0, 1], [1, 2]]})

    def test_missing_groups(self):
        no_curves = [e.replace(" 1 2 1 ", " 1 2 0 ").replace(" 1 2 2 ", " 1 2 0 ")
                     for e in ELEMENTS]
        self.assert_not_converted(msh(names="", elements=no_curves), "has no physical Curve")
        self.assert_not_converted(msh(elements=no_curves), "has names of physical Curves",
                                  "Mesh.SaveAll")
        no_surfaces = ELEMENTS[:4] + [e.replace(" 2 2 3 ", " 2 2 0 ").replace(" 2 2 4 ", " 2 2 0 ")
                                      for e in ELEMENTS[4:]]
        self.assert_not_converted(msh(names="", elements=no_surfaces), "has no physical Surface")
        self.assert_not_converted(msh(elements=no_surfaces), "has names of physical Surfaces",
                                  "nothing in the mesh belongs to one", "Mesh.SaveAll = 0",
                                  "Mesh.MshFileVersion = 4.1")
        some = ELEMENTS[:6] + [e.replace(" 2 2 4 ", " 2 2 0 ") for e in ELEMENTS[6:]]
        self.assert_not_converted(msh(elements=some), "Surface 2 has cells but is in no physical")

    def test_meshes_that_do_not_fit(self):
        self.assert_not_converted(msh(nodes={**NODES, 8: "1 1 0.5"}), "node 8", "z = 0.5")
        self.assert_not_converted(msh(elements=ELEMENTS[:4] + ["5 3 2 3 1 2 3 5 7"]),
                                  "cell 5 is a quadrilateral", "--simplices")
        self.assert_not_converted(msh(nodes={**NODES, 8: "1 0 0"}), "is degenerate", "(1, 0)")
        inside = ELEMENTS[:1] + ["2 1 2 2 2 3 8"] + ELEMENTS[2:]
        self.assert_not_converted(msh(elements=inside), "boundary 'sides'", "inside the body")
        outside = ["1 1 2 1 1 2 9"] + ELEMENTS[1:]
        self.assert_not_converted(msh(elements=outside), "facets of 'base' are not sides of cells",
                                  "node 9 belongs to no cell", "Curve{...} In Surface{...}",
                                  "BooleanFragments")
        across = ["1 1 2 1 1 2 5"] + ELEMENTS[1:]
        self.assert_not_converted(msh(elements=across), "boundary 'base'",
                                  "not a facet of any cell", "Curve{...} In Surface{...}")

    def test_a_hanging_vertex(self):
        """Beside an edge that is divided on one side alone."""
        cells = ["5 2 2 3 1 2 3 5", "6 2 2 4 2 5 7 8", "7 2 2 4 2 7 8 2"]
        self.assert_not_converted(msh(elements=ELEMENTS[:4] + cells), "does not conform",
                                  "at (1, 1) m lies inside the edge with the corners")

    def test_files_that_are_no_meshes(self):
        self.assert_refused(["convert", "none.msh", "none.h5"],
                            "'none.msh'", "cannot be opened")
        # Gmsh would run this as a script of its own.
        self.assert_not_converted('SystemCall "touch was_run";\n', "not a mesh of Gmsh")
        self.assertFalse(pathlib.Path("was_run").exists())
        self.assert_not_converted(msh()[:200], "cannot be read by Gmsh")
        self.assert_not_converted("", "not a mesh of Gmsh")

    def test_existing_files_stay(self):
        pathlib.Path("square.msh").write_text(msh())
        pathlib.Path("mine.h5").write_text("mine")
        self.assert_refused(["convert", "square.msh", "mine.h5"], "'mine.h5'", "--overwrite")
        self.assertEqual(pathlib.Path("mine.h5").read_text(), "mine")
        self.assert_done("convert", "square.msh", "mine.h5", "--overwrite")
        with h5py.File("mine.h5") as file:
            self.assertEqual(len(file["cells"]), 4)
        self.assert_refused(["convert", "square.msh", "no/where.h5"], "cannot be written")


class CommandLine(mesh_tool.Case):
    def test_commands(self):
        self.assert_refused([], "A command is missing")
        self.assert_refused(["convrt"], "Did you mean 'convert'?")
        self.assert_refused(["info", "a.h5", "b.h5"], "Unexpected argument 'b.h5'")
        text = self.assert_done("--help")
        self.assertIn("--growth-factor", text)
        self.assertIn("(0.002)", text)


if __name__ == "__main__":
    unittest.main()
