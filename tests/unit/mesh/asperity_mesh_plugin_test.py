"""asperity-mesh --plugin: the formats of examples/plugin/TriangleMesh.cpp and GtsSurface.cpp.

Arguments: asperity-mesh, the two libraries.
"""

import pathlib
import re
import sys
import unittest

import h5py
import mesh_tool
import numpy

PLUGIN, SURFACES = sys.argv.pop(1), sys.argv.pop(1)
# Two squares, each of two triangles, with a fault between them; numbers begin with 1.
NODES = "6 2 0 0\n1 0 0\n2 1 0\n3 2 0\n4 0 1 # a comment\n5 1 1\n6 2 1\n"
TRIANGLES = "4 3 1\n1 1 2 5 7\n2 1 5 4 7\n3 2 3 6 8\n4 2 6 5 8\n"
EDGES = "5 1\n1 1 2 1\n2 2 3 1\n3 2 5 3\n4 1 5 0\n5 4 5 4\n"
# A rectangle of two triangles, 20 km by 11 km; GTS has edges between vertices and faces.
CORNERS = "-10 0 1\n10 0 1\n10 0 -10\n-10 0 -10\n"
GTS = (f"4 5 2 GtsSurface GtsFace GtsEdge GtsVertex\n{CORNERS}"
       "1 2\n2 3\n3 1\n3 4\n4 1\n1 2 3\n3 4 5\n")
OFF = f"OFF\n4 2 0\n{CORNERS}3 0 1 2\n3 0 2 3\n"


def write(nodes=NODES, triangles=TRIANGLES, edges=EDGES):
    for ending, text in (("node", nodes), ("ele", triangles), ("edge", edges)):
        pathlib.Path(f"two.{ending}").write_text(text)


class Plugin(mesh_tool.Case):
    def test_reads_its_format(self):
        write()
        self.assert_done("convert", "--plugin", PLUGIN, "two.ele", "two.h5",
                         "--names", "1=bottom,3=fault,4=top", "--region-names", "7=left,8=right")
        with h5py.File("two.h5") as file:
            vertices, cells = file["vertices"][:], file["cells"][:]
            sides = {name: file["boundaries"][name]["facets"][:] for name in file["boundaries"]}
        self.assertEqual((len(vertices), len(cells)), (6, 4))
        self.assertEqual({name: len(edges) for name, edges in sides.items()},
                         {"bottom": 2, "fault": 1, "top": 1})
        numpy.testing.assert_array_equal(vertices[sides["fault"].ravel()][:, 0], [1, 1])
        self.assertRegex(self.assert_done("info", "two.h5"), "fault +fault: 1 facets, 2 vertices")

    def test_help_names_it(self):
        self.assertIn("Triangle (.ele)", self.assert_done(f"--plugin={PLUGIN}", "--help"))
        self.assertNotIn("Triangle", self.assert_done("--help"))

    def test_one_message(self):
        plugin = ["--plugin", PLUGIN]
        write()
        self.assert_refused(["convert", "two.ele", "a.h5"], "in no format", "--plugin")
        self.assert_refused([*plugin, *plugin, "--help"], "registers nothing here")
        self.assert_refused(["--plugin", "none.so", "info", "a.h5"], "'none.so' is no file")
        self.assert_refused(["info", "--plugin"], "--plugin needs a value")
        self.assert_refused([*plugin, "convert", "two.ele", "a.h5", "--array", "x"],
                            "Option --array x", "read as Triangle", "only for VTK")
        write(triangles=TRIANGLES.replace("4 2 6 5", "4 2 9 5"))
        self.assert_refused([*plugin, "convert", "two.ele", "a.h5"], "'two.ele', line 5",
                            "no vertex 9")
        write(nodes=NODES.replace("6 2 0 0", "7 2 0 0"))
        self.assert_refused([*plugin, "convert", "two.ele", "a.h5"], "'two.node'",
                            "6 lines of 7")
        pathlib.Path("two.node").unlink()
        self.assert_refused([*plugin, "convert", "two.ele", "a.h5"], "two.node")
        self.assertFalse(pathlib.Path("a.h5").exists())


class Surfaces(mesh_tool.Case):
    def dry(self, file):
        return ["build", "--fault", f"main={file},units=km", "--size", "3km", "--largest", "10km",
                "--margin", "15km", "--depth", "25km", "--dry"]

    def forecast(self, file, *words):
        """What `build --dry` says of the model, without the seconds."""
        result = mesh_tool.run(*self.dry(file), *words)
        self.assertTrue(result.returncode == 0 or "without CGAL" in result.stderr, result.stderr)
        self.assertIn("read 1 fault; ", result.stdout)
        return re.sub(r"(?m)^ *[\d.]+ s  ", "", result.stdout), result.stderr

    def test_are_those_of_another_format(self):
        pathlib.Path("main.gts").write_text(GTS)
        pathlib.Path("main.off").write_text(OFF)
        self.assertEqual(self.forecast("main.gts", "--plugin", SURFACES), self.forecast("main.off"))

    def test_are_in_the_list_of_parameters(self):
        parameters = ["build", "--print-parameters"]
        self.assertIn("GTS (.gts)", self.assert_done(*parameters, "--plugin", SURFACES))
        self.assertNotIn("GTS", self.assert_done(*parameters))

    def test_one_message(self):
        plugin = ["--plugin", SURFACES]
        for text, *pieces in (
                (GTS[:-len("3 4 5\n")], "'bad.gts'", "before all faces"),
                (GTS.replace("3 4 5", "2 4 5"), "'bad.gts', line 12", "three edges"),
                (GTS.replace("3 4 5", "3 4 6"), "line 12", "edge 6 is outside [1, 5]"),
                (GTS.replace("4 1\n", "4 5\n"), "line 10", "vertex 5 is outside [1, 4]"),
                ("# nothing\n", "empty")):
            pathlib.Path("bad.gts").write_text(text)
            self.assert_refused([*self.dry("bad.gts"), *plugin], *pieces)
        self.assert_refused([*plugin, *plugin, "--help"], "registers nothing here")


if __name__ == "__main__":
    unittest.main()
