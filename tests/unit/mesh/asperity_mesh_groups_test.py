"""asperity-mesh convert: names of Gmsh's physical groups, what Gmsh does when it saves a mesh,
meshes in other units, in parts, and of bodies that touch.

Gmsh's own library meshes and saves the same scripts for comparison (gmsh_program.py).
"""

import pathlib
import re
import subprocess
import sys
import unittest

import h5py
import numpy

import mesh_tool
import time_limits

# A fault of 10 km in a square of 40 km, drawn in kilometres.
SQUARE = """
Point(1) = {-20, -20, 0, 4}; Point(2) = {20, -20, 0, 4}; Point(3) = {20, 20, 0, 4};
Point(4) = {-20, 20, 0, 4}; Point(5) = {-5, 0, 0, 1}; Point(6) = {5, 0, 0, 1};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1}; Line(5) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Curve{5} In Surface{1};
"""
NAMED = SQUARE + """
Physical Curve("outside") = {1, 2, 3, 4}; Physical Curve("fault") = {5};
Physical Surface("rock") = {1};
"""
NUMBERED = SQUARE + """
Physical Curve(5) = {1, 2, 3, 4}; Physical Curve(3) = {5}; Physical Surface(1) = {1};
"""
BOX = """SetFactory("OpenCASCADE");
Box(1) = {0, 0, 0, 4, 4, 4}; Rectangle(20) = {1, 1, 2, 2, 2};
Surface{20} In Volume{1}; Mesh.MeshSizeMax = 1;
Physical Volume("rock") = {1}; Physical Surface("rim") = {1:6}; Physical Surface("fault") = {20};
"""
# The halves of a square on both sides of x = 0, each with a curve of its own there.
HALVES = """
Point(1) = {-2, -2, 0, H}; Point(2) = {0, -2, 0, H}; Point(3) = {0, 2, 0, H};
Point(4) = {-2, 2, 0, H}; Point(5) = {0, -2, 0, H}; Point(6) = {2, -2, 0, H};
Point(7) = {2, 2, 0, H}; Point(8) = {0, 2, 0, H};
Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Line(5) = {5, 6}; Line(6) = {6, 7}; Line(7) = {7, 8}; Line(8) = {8, 5};
Curve Loop(1) = {1:4}; Plane Surface(1) = {1}; Curve Loop(2) = {5:8}; Plane Surface(2) = {2};
Transfinite Curve{2} = 9; Transfinite Curve{8} = EIGHT;
Physical Curve("outside") = {1, 3:7}; Physical Curve("fault") = {2};
Physical Surface("west") = {1}; Physical Surface("east") = {2}; MORE
"""


def halves(points_of_curve_8=9, more=""):
    return HALVES.replace("H}", "0.5}").replace("EIGHT", str(points_of_curve_8)) \
        .replace("MORE", more)


def library():
    linked = subprocess.run(["ldd", mesh_tool.PROGRAM], capture_output=True, text=True, check=True)
    return re.search(r"libgmsh\S* => (\S+)", linked.stdout).group(1)


def contents(name):
    with h5py.File(name) as file:
        found = {key: file[key][:] for key in ("vertices", "cells", "cell_regions")}
        found["region_names"] = file["region_names"].asstr()[:].tolist()
        for boundary, group in file["boundaries"].items():
            found[boundary] = group["facets"][:]
    return found


class Case(mesh_tool.Case):
    def convert(self, text, *options, name="case.geo"):
        pathlib.Path(name).write_text(text + "\n")
        return self.assert_done("convert", name, "case.h5", "--overwrite", *options)

    def save(self, text, target, parts=0):
        pathlib.Path("gmsh.geo").write_text(text + "\n")
        script = pathlib.Path(__file__).with_name("gmsh_program.py")
        subprocess.run([sys.executable, script, library(), "gmsh.geo", target, str(parts)],
                       check=True, timeout=time_limits.seconds(60), capture_output=True)

    def assert_not_converted(self, text, *pieces, options=()):
        pathlib.Path("bad.geo").write_text(text)
        said = self.assert_refused(["convert", "bad.geo", "bad.h5", *options], *pieces)
        self.assertEqual(list(pathlib.Path(".").glob("bad.h5*")), [])
        return said

    def warnings(self, *arguments):
        result = mesh_tool.run("convert", *arguments)
        self.assertEqual(result.returncode, 0, result.stderr)
        return re.findall("asperity-mesh: WARNING: (.*)", result.stderr)

    def assert_same_mesh(self, found, expected):
        self.assertEqual(found.keys(), expected.keys())
        for key, values in expected.items():
            if key == "vertices":
                size = numpy.abs(values).max()  # texts have 16 digits
                numpy.testing.assert_allclose(found[key], values, rtol=0, atol=1e-15 * size)
            else:
                numpy.testing.assert_array_equal(found[key], values)


class WhatGmshSaves(Case):
    OPTIONS = ("", "Mesh.ScalingFactor = 1000;", "Mesh.ScalingFactor = 0.01;", "Mesh.SaveAll = 1;",
               "Mesh.SaveParametric = 1;", "Mesh.Binary = 1;", "Mesh.MshFileVersion = 2.2;",
               "Mesh.MshFileVersion = 4.0;", "Mesh.SaveGroupsOfNodes = 1;",
               "Mesh.SaveGroupsOfElements = 0;", "Mesh.SaveTopology = 1;",
               "Mesh.ScalingFactor = 1000; Mesh.MshFileVersion = 2.2;",
               "Mesh.SaveElementTagType = 2;")

    def test_options_that_act_when_a_mesh_is_saved(self):
        for base, options in ((NAMED, self.OPTIONS), (BOX, self.OPTIONS[1:7:5])):
            for option in options:
                with self.subTest(option):
                    self.save(base + option, "gmsh.msh")
                    self.assert_done("convert", "gmsh.msh", "gmsh.h5", "--overwrite")
                    self.convert(base + option)
                    self.assert_same_mesh(contents("case.h5"), contents("gmsh.h5"))

    def test_the_size_of_the_body(self):
        report = self.convert("Mesh.ScalingFactor = 1000;" + NAMED)
        self.assertIn("x from -20000 to 20000 m, y from -20000 to 20000 m", report)
        self.assertAlmostEqual(contents("case.h5")["vertices"].max(), 20e3)
        # Gmsh's own factor and --scale multiply.
        self.assertIn("x from -2e+07 to 2e+07 m",
                      self.convert("Mesh.ScalingFactor = 1000;" + NAMED, "--scale", "1000"))

    def test_scale(self):
        unscaled = self.convert(NAMED) and contents("case.h5")
        self.assertIn("x from -20000 to 20000 m", self.convert(NAMED, "--scale", "1000"))
        scaled = contents("case.h5")
        numpy.testing.assert_array_equal(scaled.pop("vertices"), 1000 * unscaled.pop("vertices"))
        self.assert_same_mesh({"vertices": numpy.ones(1), **scaled},
                              {"vertices": numpy.ones(1), **unscaled})
        self.save(NAMED, "gmsh.msh")
        self.assert_done("convert", "gmsh.msh", "case.h5", "--overwrite", "--scale=1000")
        numpy.testing.assert_allclose(contents("case.h5")["vertices"].max(), 20e3)
        self.assert_done("convert", "gmsh.msh", "km.h5", "--units", "km")
        self.assert_same_mesh(contents("km.h5"), contents("case.h5"))
        self.assert_refused(["convert", "gmsh.msh", "bad.h5", "--units", "miles"],
                            "Option --units = miles", "--scale")
        self.assert_refused(["convert", "gmsh.msh", "bad.h5", "--units=m", "--scale=2"],
                            "--units and --scale")
        for factor in ("0", "-1", "km"):
            self.assert_refused(["convert", "gmsh.msh", "bad.h5", "--scale", factor],
                                "Option --scale")

    def test_bodies_without_a_group(self):
        """Gmsh does not save them, and the program says so before it meshes."""
        two = halves().replace('Physical Surface("east") = {2};', "").replace(
            '{1, 3:7}', '{1, 3, 4}')
        pathlib.Path("case.geo").write_text(two)
        found = self.warnings("case.geo", "case.h5")
        self.assertIn("Surface 2 is in no physical Surface", found[0])
        self.save(two, "gmsh.msh")
        self.assert_done("convert", "gmsh.msh", "gmsh.h5", "--overwrite")
        self.assert_same_mesh(contents("case.h5"), contents("gmsh.h5"))
        self.assert_not_converted(two + "Mesh.SaveAll = 1;", "Surface 2 has cells but is in no")

    def test_cells_of_other_kinds(self):
        for option, piece in (("Mesh.ElementOrder = 2;", "Mesh.ElementOrder = 2"),
                              ("Mesh.RecombineAll = 1;", "Mesh.RecombineAll")):
            with self.subTest(option):
                said = self.assert_not_converted(NAMED + option, piece, "--simplices")
                self.assertNotIn("Meshing", said)
                self.convert(NAMED + option, "--simplices")
                mesh = contents("case.h5")
                self.assertEqual(len(mesh["fault"]), 10)
                a, b, c = (mesh["vertices"][mesh["cells"][:, i]] for i in range(3))
                self.assertAlmostEqual(numpy.cross(b - a, c - a).sum() / 2, 40 ** 2)

    def test_progress_of_gmsh(self):
        self.assertIn("Meshing surface 1", self.convert(NAMED))

    def test_a_folder_that_is_not_there(self):
        pathlib.Path("case.geo").write_text(NAMED)
        said = self.assert_refused(["convert", "case.geo", "no/bad.h5"], "'no/bad.h5'", "folder")
        self.assertNotIn("Meshing", said)

    def test_nothing_is_left_behind(self):
        self.convert(NAMED)
        self.assert_not_converted(NAMED.replace('"rock") = {1}', '"rock") = {1}; Physical '
                                                'Curve("twice") = {5}'), "'twice'")
        self.assertEqual([path.name for path in pathlib.Path(".").glob("*.h5*")], ["case.h5"])

    def test_fields_that_wait_for_each_other(self):
        """Gmsh 4.8 hangs; here the script ends before it meshes."""
        fields = ('Field[1] = MathEval; Field[1].F = "1 + 0.1 * x * x"; Field[2] = KIND; '
                  'Field[2].F = "F1 + 0.1"; Mesh.ElementOrder = 1;\n')
        pathlib.Path("wait.geo").write_text(NAMED + fields.replace("KIND", "MathEval"))
        result = mesh_tool.run("convert", "wait.geo", "case.h5", "--overwrite")
        self.assertEqual(result.returncode, 0, result.stderr)  # no background field
        self.assertIn("Field[2] and Field[1] are MathEval", result.stderr)
        self.assertIn("waits for ever", result.stderr)
        distance = fields.replace("KIND", "MathEval").replace(
            'Field[1] = MathEval; Field[1].F = "1 + 0.1 * x * x"', "Field[1] = Distance")
        pathlib.Path("wait.geo").write_text(NAMED + distance)
        self.assertEqual(self.warnings("wait.geo", "case.h5", "--overwrite"), [])


class Names(Case):
    def test_by_number(self):
        report = self.convert(NUMBERED)
        found = contents("case.h5")
        self.assertEqual(found["region_names"], ["region_1"])
        self.assertIn("boundary_5", found)
        self.assertEqual(len(found["boundary_3"]), 10)
        self.assertIn("physical Curve 3 has no name and is called 'boundary_3'", report)
        self.assertLess(report.index("'boundary_3'"), report.index("Meshing"))

    def test_given(self):
        pathlib.Path("case.geo").write_text(NUMBERED)
        found = self.warnings("case.geo", "case.h5", "--names", "1=free,3=fault, 5=far",
                              "--region-names", "1=rock")
        self.assertIn("--names 1=free names nothing", found[0])
        self.assertIn("only 3, 5", found[0])
        self.assertEqual({"vertices", "cells", "cell_regions", "region_names", "fault", "far"},
                         set(contents("case.h5")))
        self.assertEqual(contents("case.h5")["region_names"], ["rock"])
        self.save(NUMBERED, "gmsh.msh")
        self.assert_done("convert", "gmsh.msh", "gmsh.h5", "--names", "3=fault", "--names=5=far",
                         "--region-names", "1=rock")
        self.assert_same_mesh(contents("case.h5"), contents("gmsh.h5"))

    def test_by_name(self):
        self.convert(NAMED, "--names", "fault=main, outside=far", "--region-names", "rock=crust")
        found = contents("case.h5")
        self.assertEqual((found["region_names"], len(found["main"])), (["crust"], 10))
        self.assertIn("far", found)
        self.assert_not_converted(NAMED, "has no group 'falt'",
                                  "Did you mean 'fault'?", options=["--names", "falt=main"])

    def test_two_groups_of_one_name(self):
        two = NUMBERED.replace("Physical Curve(5) = {1, 2, 3, 4}",
                               "Physical Curve(5) = {1, 2}; Physical Curve(7) = {3, 4}")
        self.convert(two, "--names", "5=far,7=far,3=fault")
        self.assertEqual(len(contents("case.h5")["far"]), 40)

    def test_refused_before_meshing(self):
        for options, pieces in (
                (["--names", "3"], ["'3' is not of the form NUMBER=NAME"]),
                (["--names", "=3"], ["not of the form"]),
                (["--names", "fault=main"], ["--names", "has no group 'fault'"]),
                (["--names", "a=b,a=c"], ["gives a name to a twice"]),
                (["--names", "3="], ["not of the form"]),
                (["--names", "3=a,3=b"], ["gives a name to 3 twice"]),
                (["--names", "3=a/b"], ["'a/b' cannot be the name", "--names 3=NAME"]),
                (["--without", "falt", "--names", "3=fault,5=far"],
                 ["Option --without falt", "Did you mean 'fault'?"]),
                (["--without", "region_1"], ["is a region", "Only boundaries and faults"]),
                (["--without", ",a"], ["a name is missing"])):
            with self.subTest(options):
                said = self.assert_not_converted(NUMBERED, *pieces, options=options)
                self.assertNotIn("Meshing", said)
        for text, pieces in (
                (SQUARE, ["has no physical Surface"]),
                (SQUARE + "Physical Surface(1) = {1};", ["has no physical Curve"]),
                (NUMBERED + 'Physical Surface("more") = {1};', ["in two regions", "'more'"]),
                (NUMBERED + 'Physical Curve("boundary_3") = {1};', ["'boundary_3'", "--names"])):
            said = self.assert_not_converted(text, *pieces)
            self.assertNotIn("Meshing", said)

    def test_a_group_within_another(self):
        """As fault_coseismic within fault_slabtop of PyLith's subduction-2d."""
        nested = NAMED.replace("Line(5) = {5, 6};", "Point(7) = {0, 0, 0, 1}; Line(5) = {5, 7}; "
                               "Line(6) = {7, 6};").replace("Curve{5} In", "Curve{5, 6} In") \
            .replace('"fault") = {5};', '"fault") = {5, 6}; Physical Curve("inner") = {6};')
        pathlib.Path("case.geo").write_text(nested)
        found = self.warnings("case.geo", "case.h5")
        self.assertEqual(len(found), 1)
        self.assertIn("5 facets are in fault 'fault' and in fault 'inner'. They stay in 'inner'",
                      found[0])
        inner, rest = contents("case.h5")["inner"], contents("case.h5")["fault"]
        self.assertEqual((len(inner), len(rest)), (5, 5))
        self.assertEqual({frozenset(f) for f in inner.tolist()}
                         & {frozenset(f) for f in rest.tolist()}, set())
        equal = nested.replace('Curve("inner") = {6}', 'Curve("inner") = {5, 6}')
        self.assert_not_converted(equal, "all facets of fault 'inner' are in fault 'fault'",
                                  "--without inner")
        self.convert(nested, "--without", "inner")
        self.assertEqual(len(contents("case.h5")["fault"]), 10)
        self.assertNotIn("inner", contents("case.h5"))
        self.convert(nested, "--without=fault,outside")
        self.assertEqual(len(contents("case.h5")["inner"]), 5)
        self.assertNotIn("outside", contents("case.h5"))


class Parts(Case):
    def test_partitioned_by_gmsh(self):
        """Put together, the parts are the mesh before it was partitioned, up to numbers."""
        for name, text in (("plane", NAMED), ("space", BOX)):
            for option in ("", "Mesh.Binary = 1;", "Mesh.MshFileVersion = 2.2;",
                           "Mesh.PartitionCreatePhysicals = 0;",
                           "Mesh.PartitionCreateTopology = 0;", "Mesh.PartitionCreateGhostCells=1;"
                           )[:6 if name == "plane" else 1]:
                with self.subTest(name + option):
                    self.save(text + option, "whole.msh")
                    self.save(text + option, "parts.msh", 3)
                    self.assert_done("convert", "whole.msh", "whole.h5", "--overwrite")
                    said = self.assert_done("convert", "parts.msh", "parts.h5", "--overwrite")
                    self.assertIn("is partitioned by Gmsh; its 3 parts are put together", said)
                    whole, parts = contents("whole.h5"), contents("parts.h5")
                    self.assertEqual(whole.keys(), parts.keys())

                    def places(mesh, key):
                        corners = mesh["vertices"][mesh[key]].round(9)
                        return sorted(sorted(map(tuple, one)) for one in corners.tolist())
                    for key in set(whole) - {"vertices", "cell_regions", "region_names"}:
                        self.assertEqual(places(whole, key), places(parts, key), key)

    def test_one_part(self):
        split = NAMED + "Mesh.PartitionSplitMeshFiles = 1;"
        for more in ("", "Mesh.Binary = 1;"):
            self.save(split + more, "split.msh", 3)
            for part in ("split_1.msh", "split_2.msh"):
                self.assert_refused(["convert", part, "bad.h5"], f"'{part}' is a part of a mesh",
                                    "PartitionSplitMeshFiles")


class BodiesThatTouch(Case):
    def test_with_equal_divisions(self):
        pathlib.Path("case.geo").write_text(halves())
        found = self.warnings("case.geo", "case.h5")
        self.assertEqual(len(found), 1)
        self.assertIn("8 facets of region 'west' lie on facets of region 'east' without sharing "
                      "vertices, the first at (0, ", found[0])
        self.assertIn("on boundary 'fault'", found[0])

    def test_with_other_divisions(self):
        pathlib.Path("case.geo").write_text(halves(6))
        self.assertRegex(self.warnings("case.geo", "case.h5")[0],
                         "facets of region '....' lie on facets of region '....' without sharing")

    def test_one_curve_for_both(self):
        """With common vertices there is a fault and no word."""
        one = halves().replace("{5:8}", "{5, 6, 7, -2}").replace("{5, 6}", "{2, 6}") \
            .replace("{7, 8}", "{7, 3}").replace("Line(8) = {8, 5};", "") \
            .replace("Transfinite Curve{8} = 9;", "")
        self.assertIn("1 faults", self.convert(one))


if __name__ == "__main__":
    unittest.main()
