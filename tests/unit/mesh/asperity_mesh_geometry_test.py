"""asperity-mesh meshes Gmsh's geometries and splits meshes along the faults inside them.

The second argument is the folder of the geometries that come with the decks.
"""

import pathlib
import re
import shutil
import sys
import unittest

import h5py
import numpy

import mesh_tool

MESHES = pathlib.Path(sys.argv.pop(1))
NETWORK = ("main_west", "main_middle", "main_east", "north_west", "north_east", "south_west",
           "south_east", "cross_middle", "cross_east", "link", "branch_north", "branch_south")

# A square with a fault that rises from (1, 1) to the right side; `slope` is a constant.
SQUARE = """// DefineConstant[hidden = 1];
DefineConstant[
  slope = {0.5, Name "Parameters/slope [-]"}, // of the fault
  h = 0.4
];
Point(1) = {0, 0, 0}; Point(2) = {4, 0, 0}; Point(3) = {4, 4, 0}; Point(4) = {0, 4, 0};
Point(5) = {1, 1, 0}; Point(6) = {4, 1 + 3 * slope, 0};
Line(1) = {1, 2}; Line(2) = {2, 6}; Line(3) = {6, 3}; Line(4) = {3, 4}; Line(5) = {4, 1};
Line(6) = {5, 6};
Curve Loop(1) = {1, 2, 3, 4, 5}; Plane Surface(1) = {1};
Curve{6} In Surface{1};
MORE
Physical Surface("rock") = {1}; Physical Curve("rim") = {1, 2, 3, 4, 5};
Physical Curve("fault") = {6};
Mesh.MeshSizeMax = h;
"""

BOX = """SetFactory("OpenCASCADE");
DefineConstant[h = 0.25];
Box(1) = {0, 0, 0, 1, 1, 1};
Rectangle(20) = {0.25, 0.25, 0.5, 0.5, 0.5};
Surface{20} In Volume{1};
Physical Volume("rock") = {1};
Physical Surface("rim") = {1:6};
Physical Surface("fault") = {20};
Mesh.MeshSizeMax = h;
"""

# Nothing but its corners and one line across: all of the fault's vertices are tips.
SHORT = SQUARE.replace("Point(6) = {4, 1 + 3 * slope, 0}", "Point(6) = {2, 1, 0}") \
    .replace("{2, 6}; Line(3) = {6, 3}", "{2, 3}; Line(3) = {2, 3}") \
    .replace("{1, 2, 3, 4, 5}", "{1, 2, 4, 5}") \
    .replace("MORE", "Transfinite Curve{6} = 2;")


def square(more=""):
    return SQUARE.replace("MORE", more)


class Geometry(mesh_tool.Case):
    def convert(self, text, *options):
        pathlib.Path("case.geo").write_text(text)
        return self.assert_done("convert", "case.geo", "case.h5", "--overwrite", *options)

    def assert_not_converted(self, text, *pieces, options=()):
        pathlib.Path("bad.geo").write_text(text)
        self.assert_refused(["convert", "bad.geo", "bad.h5", *options], *pieces)
        self.assertFalse(pathlib.Path("bad.h5").exists())

    def fault_of(self, name):
        with h5py.File(name) as file:
            return file["vertices"][:][file["boundaries/fault/facets"][:]]


class Faults(Geometry):
    def test_in_the_plane(self):
        for slope in (0.5, 0.25):
            report = self.convert(square(), "--set", f"slope={slope}")
            self.assertIn("1 regions, 1 boundaries, 1 faults", report)
            x, y = self.fault_of("case.h5").reshape(-1, 2).T
            numpy.testing.assert_allclose(y, 1 + slope * (x - 1), atol=1e-12)
            self.assertAlmostEqual(x.min(), 1)
            self.assertAlmostEqual(x.max(), 4)
        coarse = len(self.fault_of("case.h5"))
        self.convert(square(), "--set", "h=0.2", "--set=slope=0.25")
        self.assertGreater(len(self.fault_of("case.h5")), 1.8 * coarse)

    def test_info(self):
        self.convert(square())
        info = self.assert_done("info", "case.h5")
        facets = len(self.fault_of("case.h5"))
        self.assertIn(f"fault            fault: {facets} facets, {facets + 1} vertices, 1 tip, ",
                      info)
        self.assertRegex(info, rf"vertices  +\d+, {facets + 1} of them copies at faults\n")
        self.assertRegex(info, r"boundary  +rim: \d+ facets, \d+ vertices, shortest edge")
        self.assertIn("area             16 m^2", info)

    def test_in_space(self):
        self.convert(BOX, "--set", "h=0.2")
        corners = self.fault_of("case.h5")
        numpy.testing.assert_allclose(corners[:, :, 2], 0.5, atol=1e-12)
        sides = corners[:, 1:, :2] - corners[:, :1, :2]
        self.assertAlmostEqual(numpy.abs(numpy.linalg.det(sides)).sum() / 2, 0.25)
        self.assertRegex(self.assert_done("info", "case.h5"), r"fault  +fault: .* \d+ tips, ")

    def test_partition(self):
        """The parts are split: all their rows for one part together are the split mesh."""
        self.convert(square())
        self.assert_done("partition", "case.h5", "--parts", "3", "--output", "three.h5",
                         "--boundary", "fault")
        self.assert_done("partition", "three.h5", "--parts", "1", "--output", "one.h5")
        with h5py.File("case.h5") as whole, h5py.File("one.h5") as one:
            num_originals = len(whole["vertices"])
            pairs = one["splits/values"][:]
            self.assertEqual(one.attrs["version"], 2)
            self.assertEqual(list(one["faults"].asstr()), ["fault"])
            self.assertEqual(pairs[:, 0].tolist(),
                             list(range(num_originals, num_originals + len(pairs))))
            vertices = one["vertices/values"][:]
            numpy.testing.assert_array_equal(vertices[pairs[:, 0]], vertices[pairs[:, 1]])
            tips = vertices[pairs[pairs[:, 2] == 1, 1]]
            numpy.testing.assert_array_equal(tips, [[1, 1]])
            # Cells of the plus side lie above the fault.
            cells = one["cells/values"][:]
            above = vertices[cells].mean(axis=1)[(cells >= num_originals).any(axis=1)]
            self.assertGreater(len(above), len(pairs) - 1)
            self.assertTrue((above[:, 1] > 1 + 0.5 * (above[:, 0] - 1)).all())

        def faults(name):
            return re.findall("fault  .*|boundary  .*|vertices  .*", self.assert_done("info", name))
        self.assertEqual(faults("three.h5"), faults("case.h5"))

    def test_those_of_the_decks(self):
        for path in MESHES.glob("*.geo"):
            shutil.copy(path, ".")
        for arguments, faults in (
                (["bp3.geo", "--set", "h=1000"], {"fault": 0, "deep": 0}),
                (["bp3.geo", "--set", "h=1000", "--set", "dip=30"], {"fault": 0, "deep": 0}),
                (["subduction_2d.geo", "--set", "h=4000"], {"megathrust": 0, "deep": 0}),
                (["splay_2d.geo", "--set", "h=2000"], {"megathrust": 0, "deep": 0, "splay": 1}),
                (["subduction_3d.geo", "--set", "h=16e3"], {"megathrust": 0, "deep": 0}),
                (["subduction_3d.geo", "--set", "h=16e3", "--set", "right=500e3"],
                 {"megathrust": 0, "deep": 0}),
                (["network.geo", "--set", "h=600"], dict.fromkeys(NETWORK, 2))):
            with self.subTest(arguments):
                self.assert_done("convert", arguments[0], "deck.h5", "--overwrite", *arguments[1:])
                info = self.assert_done("info", "deck.h5")
                tips = {name: int(number) for name, number
                        in re.findall(r"fault +(\w+): .* (\d+) tips?, ", info)}
                self.assertEqual(tips, faults)
                for name in ("(surface|top)", "left", "right", "bottom"):
                    self.assertRegex(info, rf"boundary +{name}: ")
                crossings = re.findall(r"crossing +(\w+ and \w+) at ", info)
                self.assertEqual(crossings, ["cross_middle and main_middle",
                                             "cross_east and main_east"]
                                 if "main_east" in faults else [])
        # test_faults_that_meet_in_space has conjugate_3d.geo
        self.assertEqual({path.name for path in MESHES.glob("*.geo")},
                         {"bp3.geo", "conjugate_3d.geo", "network.geo", "subduction_2d.geo",
                          "splay_2d.geo", "subduction_3d.geo"})

    def test_faults_that_meet_in_space(self):
        """The line of conjugate_3d.geo, along which faults cross or the branch slips, is one cell
        shorter than the branch is deep: at its lower end the branch has a tip."""
        shutil.copy(MESHES / "conjugate_3d.geo", ".")
        for left_east, found in (("15e3", "crossing         left_lateral and right_lateral"),
                                 ("0", "joint            left_lateral ends on right_lateral")):
            self.assert_done("convert", "conjugate_3d.geo", "meet.h5", "--overwrite", "--set",
                             "h=3e3", "--set", f"left_east={left_east}")
            info = self.assert_done("info", "meet.h5")
            self.assertEqual(len(re.findall("^(?:crossing|joint) ", info, re.MULTILINE)), 1)
            self.assertRegex(info, rf"\n{found} at 6 vertices from .* m, 15000 m long\n")

    def test_dip_in_space(self):
        """The interface of subduction_3d.geo steepens in proportion to its depth."""
        shutil.copy(MESHES / "subduction_3d.geo", ".")
        self.assert_done("convert", "subduction_3d.geo", "coast.h5", "--set", "h=8e3")
        with h5py.File("coast.h5") as file:
            corners = file["vertices"][:][file["boundaries/megathrust/facets"][:]]
            faces = {name: file["vertices"][:][file[f"boundaries/{name}/facets"][:]]
                     for name in ("front", "back", "left", "right", "bottom", "surface", "deep")}
        normals = numpy.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        sizes = numpy.linalg.norm(normals, axis=1)
        dip = numpy.degrees(numpy.arccos(numpy.abs(normals[:, 1]) / sizes))
        depth = -corners[:, :, 1].mean(axis=1)
        numpy.testing.assert_allclose(dip, 8 + 17 * depth / 40e3, atol=1)
        self.assertAlmostEqual(depth.max(), 40e3, delta=3e3)
        # Flat boundaries, each where it belongs.
        for name, axis, place in (("front", 2, 0), ("back", 2, 200e3), ("left", 0, -150e3),
                                  ("right", 0, 350e3), ("bottom", 1, -150e3), ("surface", 1, 0)):
            numpy.testing.assert_allclose(faces[name][:, :, axis], place, atol=1e-3, err_msg=name)
        self.assertAlmostEqual(faces["deep"][:, :, 1].max(), -40e3, delta=1)

    def test_cells_on_bp3(self):
        shutil.copy(MESHES / "bp3.geo", ".")
        self.assert_done("convert", "bp3.geo", "bp3.h5", "--set", "h=500", "--set", "dip=30")
        facets = self.fault_of("bp3.h5")
        dip = numpy.radians(30)
        down_dip = facets @ [numpy.cos(dip), -numpy.sin(dip)]
        numpy.testing.assert_allclose(facets @ [numpy.sin(dip), numpy.cos(dip)], 0, atol=1e-6)
        self.assertAlmostEqual(down_dip.max(), 40e3, places=3)
        lengths = numpy.abs(down_dip[:, 1] - down_dip[:, 0])
        numpy.testing.assert_allclose(lengths[down_dip.max(axis=1) < 36e3 + 1], 500)

    def test_rows_beside_bp3(self):
        """Next to the fault lie rows whose first is 0.35 h high, its vertices between those of the
        fault, and each side mirrors the other."""
        shutil.copy(MESHES / "bp3.geo", ".")
        self.assert_done("convert", "bp3.geo", "rows.h5", "--set", "h=500")
        with h5py.File("rows.h5") as file:
            vertices = file["vertices"][:]
        dip = numpy.radians(60)
        along = vertices @ [numpy.cos(dip), -numpy.sin(dip)]
        away = vertices @ [numpy.sin(dip), numpy.cos(dip)]
        for height in (0.35 * 500, 0.35 * 500 * (1 + 1.04)):
            above, below = (numpy.sort(along[numpy.abs(away - side * height) < 1e-6])
                            for side in (1, -1))
            self.assertEqual(len(above), (36e3 - 1e3) / 500 + 1)
            numpy.testing.assert_allclose(above, below, atol=1e-6)
            numpy.testing.assert_allclose(numpy.diff(above), 500)
        numpy.testing.assert_allclose(above[0], 1e3 + 500)  # of the second row


class Refusals(Geometry):
    def test_constants(self):
        def refused(setting, *pieces):
            self.assert_not_converted(square(), f"Option --set {setting}", *pieces,
                                      options=["--set", setting])
        refused("slop=1", "'bad.geo' defines no constant 'slop'", "'slope', 'h'",
                "Did you mean 'slope'?")
        refused("hidden=1", "no constant 'hidden'")
        refused("slope=steep", "not a number")
        refused("slope", "not of the form NAME=VALUE")
        self.assert_not_converted(square(), "gives 'h' twice",
                                  options=["--set", "h=1", "--set", "h=2"])
        pathlib.Path("mesh.msh").write_text("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n")
        self.assert_refused(["convert", "mesh.msh", "bad.h5", "--set", "h=1"], "is no geometry")

    def test_what_gmsh_cannot_mesh(self):
        bow_tie = square().replace("Point(3) = {4, 4, 0}; Point(4) = {0, 4, 0}",
                                   "Point(3) = {0, 4, 0}; Point(4) = {4, 4, 0}")
        # Gmsh says so itself, or, from 4.15 on, leaves out a part, which the conversion finds.
        self.assert_not_converted(bow_tie, "Gmsh geometry 'bad.geo'")
        self.assert_not_converted(square().replace("{6, 3}", "{6, 33}"),
                                  "'bad.geo' cannot be read by Gmsh", "33")
        self.assert_not_converted("Point(1) = {0, 0", "'bad.geo' cannot be read by Gmsh", "line ",
                                  "syntax error")
        self.assert_not_converted("Point(1) = {0, 0, 0};", "neither a surface nor a volume")
        self.assert_not_converted("", "neither a surface nor a volume")
        self.assert_refused(["convert", "none.geo", "bad.h5"], "'none.geo' cannot be opened")

    def test_a_dip_that_leaves_no_room(self):
        """The fault along the surface, on either side, and one that rises above it."""
        shutil.copy(MESHES / "bp3.geo", ".")
        for dip in (0, 180, -30):
            with self.subTest(dip):
                self.assert_refused(["convert", "bp3.geo", "bad.h5", "--set", "h=2000",
                                     "--set", f"dip={dip}"], "bp3.geo")
                self.assertFalse(pathlib.Path("bad.h5").exists())

    def test_no_names(self):
        unnamed = square().replace('Physical Surface("rock") = {1};', "")
        self.assert_not_converted(unnamed, "has no physical Surface")

    def test_other_programs(self):
        self.assert_not_converted('SystemCall "touch was_run";\n' + square(),
                                  "runs other programs (SystemCall)")
        pathlib.Path("other.geo").write_text('SystemCall "touch was_run";\n')
        self.assert_not_converted('Include "other.geo";\n' + square(), "SystemCall")
        self.assertFalse(pathlib.Path("was_run").exists())

    def test_a_last_line_without_its_end(self):
        """Gmsh reads its first statement alone: the size of the body would be another one."""
        self.convert(square() + "Mesh.Binary = 1; // a comment")
        self.convert(square() + "Mesh.Binary = 1; Mesh.ScalingFactor = 1000;\n")
        self.assertIn("x from 0 to 4000 m", self.assert_done(
            "convert", "case.geo", "case.h5", "--overwrite"))
        script = square() + "Mesh.Binary = 1; Mesh.ScalingFactor = 1000; // m"
        pieces = ("no newline at the end of the last line", "only 'Mesh.Binary = 1;'",
                  "Add a newline")
        self.assert_not_converted(script, "'bad.geo'", *pieces)
        pathlib.Path("other.geo").write_text(script)
        self.assert_not_converted('Include "other.geo";\n', "'other.geo'", *pieces)

    def test_faults_that_cross(self):
        crossing = square("Point(7) = {2, 0, 0.0};").replace(
            "Point(5) = {1, 1, 0}; Point(6) = {4, 1 + 3 * slope, 0};",
            "Point(5) = {1, 1, 0}; Point(6) = {4, 1, 0}; Point(8) = {2, 1, 0}; "
            "Point(9) = {2, 2, 0}; Point(10) = {2, 0.5, 0};").replace(
            "Line(6) = {5, 6};", "Line(6) = {5, 8}; Line(16) = {8, 6}; Line(7) = {8, 9}; "
            "Line(8) = {10, 8};").replace(
            "Curve{6} In", "Curve{6, 16, 7, 8} In").replace(
            'Curve("fault") = {6};', 'Curve("fault") = {6, 16}; Physical Curve("dyke") = {7, 8};')
        self.convert(crossing)
        whole = self.assert_done("info", "case.h5")
        self.assertRegex(whole, r"dyke.* 2 tips")
        self.assertIn("crossing         dyke and fault at (2, 1) m", whole)
        self.assert_done("partition", "case.h5", "--parts", "3", "--output", "three.h5")
        self.assertIn("crossing         dyke and fault at (2, 1) m",
                      self.assert_done("info", "three.h5"))

    def test_a_fault_without_a_node_that_slips(self):
        self.assert_not_converted(SHORT, "fault 'fault' has no node that could slip", "refine")

    def test_a_tip_on_the_boundary(self):
        # A triangle that touches the box in its middle of the left side, and nowhere else.
        triangle = BOX.replace(
            "Rectangle(20) = {0.25, 0.25, 0.5, 0.5, 0.5};",
            "Point(21) = {0, 0.5, 0.5}; Point(22) = {0.5, 0.2, 0.5}; Point(23) = {0.5, 0.8, 0.5}; "
            "Line(21) = {21, 22}; Line(22) = {22, 23}; Line(23) = {23, 21}; "
            "Curve Loop(20) = {21, 22, 23}; Plane Surface(20) = {20}; "
            "Point{21} In Surface{1};")
        self.assert_not_converted(triangle, "a tip of fault 'fault' lies on the boundary",
                                  "(0, 0.5, 0.5)")

    def test_parts_of_the_version_before(self):
        self.convert(square())
        self.assert_done("partition", "case.h5", "--parts", "2", "--output", "two.h5")
        with h5py.File("two.h5", "r+") as file:
            file.attrs["version"] = 1
        self.assert_refused(["info", "two.h5"], "version 1",
                            "asperity-mesh partition MESH.h5 --parts 2 --output PARTS.h5")


if __name__ == "__main__":
    unittest.main()
