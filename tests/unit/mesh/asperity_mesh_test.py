"""asperity-mesh, given as the first argument: converts Gmsh's files, makes wedges, refuses errors.

The files it makes are read with h5py, which knows nothing of the program that wrote them.
"""

import pathlib
import subprocess
import sys
import unittest

import h5py
import numpy

PROGRAM = sys.argv.pop(1)

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


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=60)


class Case(unittest.TestCase):
    def setUp(self):
        for path in pathlib.Path(".").glob("*.h5*"):
            path.unlink()

    def assert_done(self, *arguments):
        result = run(*arguments)
        self.assertEqual((result.returncode, result.stderr), (0, ""), result.stdout)
        return result.stdout

    def assert_refused(self, arguments, *pieces):
        """Exit status 2 and one paragraph on stderr that contains the pieces."""
        result = run(*arguments)
        self.assertEqual(result.returncode, 2, result.stderr)
        self.assertEqual(result.stdout, "")
        self.assertTrue(result.stderr.startswith("asperity-mesh: "), result.stderr)
        self.assertEqual(result.stderr.count("\n"), 1, result.stderr)
        for piece in pieces:
            self.assertIn(piece, result.stderr)

    def assert_not_converted(self, text, *pieces):
        pathlib.Path("bad.msh").write_text(text)
        self.assert_refused(["convert", "bad.msh", "bad.h5"], "'bad.msh'", *pieces)
        self.assertFalse(pathlib.Path("bad.h5").exists())


class Convert(Case):
    def test_square(self):
        pathlib.Path("square.msh").write_text(msh())
        self.assertIn("5 vertices, 4 cells", self.assert_done("convert", "square.msh", "square.h5"))
        with h5py.File("square.h5") as file:
            self.assertEqual(dict(file.attrs),
                             {"format": "asperity-mesh", "version": 1, "dimension": 2})
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

    def test_missing_names(self):
        self.assert_not_converted(msh(names=NAMES.replace('1 2 "sides"\n', "")),
                                  "physical Curve 2 has no name", 'Physical Curve("name", 2)')
        self.assert_not_converted(msh(names=NAMES.replace('2 4 "upper"\n', "")),
                                  "physical Surface 4 has no name")

    def test_missing_groups(self):
        no_curves = [e.replace(" 1 2 1 ", " 1 2 0 ").replace(" 1 2 2 ", " 1 2 0 ")
                     for e in ELEMENTS]
        self.assert_not_converted(msh(elements=no_curves), "has no physical Curve")
        no_surfaces = ELEMENTS[:4] + [e.replace(" 2 2 3 ", " 2 2 0 ").replace(" 2 2 4 ", " 2 2 0 ")
                                      for e in ELEMENTS[4:]]
        self.assert_not_converted(msh(elements=no_surfaces), "has no physical Surface")
        some = ELEMENTS[:6] + [e.replace(" 2 2 4 ", " 2 2 0 ") for e in ELEMENTS[6:]]
        self.assert_not_converted(msh(elements=some), "Surface 2 has cells but is in no physical")

    def test_meshes_that_do_not_fit(self):
        self.assert_not_converted(msh(nodes={**NODES, 8: "1 1 0.5"}), "node 8", "z = 0.5")
        self.assert_not_converted(msh(elements=ELEMENTS[:4] + ["5 3 2 3 1 2 3 5 7"]),
                                  "Quadrilateral 4", "tag 5")
        self.assert_not_converted(msh(nodes={**NODES, 8: "1 0 0"}), "is degenerate", "(1, 0)")
        inside = ["1 1 2 1 1 3 8"] + ELEMENTS[1:]
        self.assert_not_converted(msh(elements=inside), "boundary 'base'", "inside the body")
        outside = ["1 1 2 1 1 2 9"] + ELEMENTS[1:]
        self.assert_not_converted(msh(elements=outside), "'base' has node 9", "no cell")

    def test_files_that_are_no_meshes(self):
        self.assert_refused(["convert", "none.msh", "none.h5"],
                            "'none.msh'", "cannot be opened")
        # Gmsh would run this as a script of its own.
        self.assert_not_converted('SystemCall "touch was_run";\n', "no mesh of Gmsh's")
        self.assertFalse(pathlib.Path("was_run").exists())
        self.assert_not_converted(msh()[:200], "cannot be read by Gmsh")
        self.assert_not_converted("", "no mesh of Gmsh's")

    def test_existing_files_stay(self):
        pathlib.Path("square.msh").write_text(msh())
        pathlib.Path("mine.h5").write_text("mine")
        self.assert_refused(["convert", "square.msh", "mine.h5"], "'mine.h5'", "--overwrite")
        self.assertEqual(pathlib.Path("mine.h5").read_text(), "mine")
        self.assert_done("convert", "square.msh", "mine.h5", "--overwrite")
        with h5py.File("mine.h5") as file:
            self.assertEqual(len(file["cells"]), 4)
        self.assert_refused(["convert", "square.msh", "no/where.h5"], "cannot be written")


class WedgeRectangleAndInfo(Case):
    def test_wedge(self):
        self.assert_done("wedge", "wedge.h5")
        info = self.assert_done("info", "wedge.h5")
        self.assertIn("area             0.135 m^2\n", info)
        self.assertIn("cell diameters   0.0010115", info)
        self.assertRegex(info, r"boundary +base: 261 facets, 262 vertices")
        self.assertRegex(info, r"region +lower: \d+ cells")

    def test_wedge_options(self):
        self.assert_done("wedge", "small.h5", "--cell-size", "0.05", "--viscous-thickness", "0")
        with h5py.File("small.h5") as file:
            self.assertLess(len(file["vertices"]), 150)
            self.assertEqual(list(file["region_names"].asstr()), ["upper"])
        self.assert_refused(["wedge", "a.h5", "--cell-size", "-1"], "Cell Size = -1")
        self.assert_refused(["wedge", "a.h5", "--cell-size", "two"], "--cell-size", "'two'")
        self.assert_refused(["wedge", "a.h5", "--cell-size"], "needs a value")
        self.assert_refused(["wedge", "a.h5", "--cell-sise", "1"], "Did you mean '--cell-size'?")
        self.assert_refused(["wedge"], "OUT.h5 is missing")
        self.assertFalse(pathlib.Path("a.h5").exists())

    def test_rectangle(self):
        self.assertIn("6 vertices, 4 cells",
                      self.assert_done("rectangle", "plain.h5", "--cells-x", "2"))
        self.assert_done("rectangle", "graded.h5", "--width", "1600", "--height", "3200",
                         "--cells-y", "2", "--left", "-800", "--bottom", "-3200",
                         "--cell-size", "100 + 0.2 * (x + 800)")
        info = self.assert_done("info", "graded.h5")
        self.assertIn("bounding box     [-800, 800] x [-3200, 0] m\n", info)
        self.assertIn("smallest angle   45 degrees\n", info)
        self.assertIn("left: 32 facets, 33 vertices, shortest edge 100 m\n", info)
        self.assertIn("right: 8 facets, 9 vertices, shortest edge 400 m\n", info)

    def test_rectangle_refuses(self):
        for options, pieces in ((["--width", "0"], ["Width = 0"]),
                                (["--cells-x", "2.5"], ["--cells-x", "'2.5'", "whole number"]),
                                (["--cell-size", "t + 1"], ["--cell-size depends on t"]),
                                (["--cell-size", "x - 0.5"], ["--cell-size is -0.5 at", "(0, 0)"]),
                                (["--cell-size", "x +"], ["--cell-size", "no valid expression"])):
            self.assert_refused(["rectangle", "a.h5", *options], *pieces)
        self.assertFalse(pathlib.Path("a.h5").exists())

    def test_info_of_bad_files(self):
        self.assert_refused(["info", "none.h5"], "'none.h5' does not exist")
        pathlib.Path("text.h5").write_text("This is no HDF5 file.")
        self.assert_refused(["info", "text.h5"], "cannot be opened as an HDF5 file")


class CommandLine(Case):
    def test_commands(self):
        self.assert_refused([], "A command is missing")
        self.assert_refused(["convrt"], "Did you mean 'convert'?")
        self.assert_refused(["info", "a.h5", "b.h5"], "Unexpected argument 'b.h5'")
        text = self.assert_done("--help")
        self.assertIn("--growth-factor", text)
        self.assertIn("(0.002)", text)


if __name__ == "__main__":
    unittest.main()
