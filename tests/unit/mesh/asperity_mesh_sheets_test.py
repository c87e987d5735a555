"""asperity-mesh convert: several faults in one group, faults of several names that meet.

Bodies are drawn in Gmsh, whose cells follow the faults: a square of 40 km and a box of 8 km."""

import pathlib
import re
import unittest

import h5py
import numpy

import mesh_tool

SQUARE = """
Point(1) = {-20, -20, 0, 5}; Point(2) = {20, -20, 0, 5}; Point(3) = {20, 20, 0, 5};
Point(4) = {-20, 20, 0, 5}; Line(1) = {1, 2}; Line(2) = {2, 3}; Line(3) = {3, 4}; Line(4) = {4, 1};
Curve Loop(1) = {1, 2, 3, 4}; Plane Surface(1) = {1}; Point(10) = {0, 0, 0, 1};
Physical Curve("outside") = {1, 2, 3, 4}; Physical Surface("rock") = {1};
"""


def arms(*ends, names=None):
    """The square with arms from its centre to these ends: curves 11, 12, ..., in one group."""
    text, curves = SQUARE, []
    for number, (x, y) in enumerate(ends, start=11):
        text += (f"Point({number}) = {{{x}, {y}, 0, 1}}; Line({number}) = {{10, {number}}}; "
                 f"Curve{{{number}}} In Surface{{1}};\n")
        curves.append(str(number))
    names = names or ["fault"] * len(ends)
    for name in sorted(set(names)):
        its = ", ".join(c for c, n in zip(curves, names) if n == name)
        text += f'Physical Curve("{name}") = {{{its}}};\n'
    return text


# Two rectangles that cross or branch, cut where they meet, in a box from -4 to 4.
BOX = """SetFactory("OpenCASCADE");
Box(1) = {-4, -4, -4, 8, 8, 8};
Rectangle(20) = {-2, -1.5, 0, 4, 3};
Rectangle(21) = {-1, -1, 0, FROM, 2}; Rotate{{0, 1, 0}, {0, 0, 0}, -ANGLE} { Surface{21}; }
BooleanFragments{ Volume{1}; Delete; }{ Surface{20, 21}; Delete; }
f() = Surface In BoundingBox{-3, -3, -3, 3, 3, 3};
Physical Volume("rock") = Volume{:}; Physical Surface("fault") = {f()};
Mesh.MeshSizeMax = 0.8;
"""


class Sheets(mesh_tool.Case):
    def convert(self, text, *options):
        pathlib.Path("case.geo").write_text(text + "\n")
        return mesh_tool.run("convert", "case.geo", "case.h5", "--overwrite", *options)

    def sizes(self):
        """Lengths or areas of boundaries."""
        with h5py.File("case.h5") as file:
            x = file["vertices"][:]
            result = {}
            for name, group in file["boundaries"].items():
                corners = x[group["facets"][:]]
                edges = [corners[:, i] - corners[:, 0] for i in range(1, corners.shape[1])]
                result[name] = (numpy.linalg.norm(edges[0], axis=1).sum() if len(edges) == 1 else
                                numpy.linalg.norm(numpy.cross(*edges), axis=1).sum() / 2)
        return result

    def assert_faults(self, expected, text, *options):
        result = self.convert(text, *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        found = self.sizes()
        found.pop("outside", None)
        self.assertEqual(set(found), set(expected))
        for name, size in expected.items():
            self.assertAlmostEqual(found[name], size, places=9, msg=name)
        return result.stdout

    def assert_not_converted(self, text, *pieces):
        pathlib.Path("case.h5").unlink(missing_ok=True)
        result = self.convert(text)
        self.assertEqual(result.returncode, 2, result.stdout)
        for piece in pieces:
            self.assertIn(piece, result.stderr.splitlines()[-1])
        self.assertEqual(list(pathlib.Path(".").glob("case.h5*")), [])

    def test_branches(self):
        """A T and Ys: what goes straightest on is one fault, the rest another."""
        for branch in ((0, 4), (4, 4), (-2, -3)):
            said = self.assert_faults({"fault.1": 12, "fault.2": numpy.hypot(*branch)},
                                      arms((-6, 0), (6, 0), branch))
            self.assertIn("'fault' meet: it is divided", said)
        # 130, 110 and 120 degrees between the arms: the first two go on.
        a, b, c = 0, numpy.radians(130), numpy.radians(240)
        self.assert_faults({"fault.1": 9, "fault.2": 5},
                           arms((5 * numpy.cos(a), 5 * numpy.sin(a)),
                                (4 * numpy.cos(b), 4 * numpy.sin(b)),
                                (5 * numpy.cos(c), 5 * numpy.sin(c))))

    def test_one_fault_of_several_pieces(self):
        """Nothing to be told apart: it keeps its name."""
        pieces = arms((-6, 0), (6, 1)) + """
Point(31) = {-8, 8, 0, 1}; Point(32) = {8, 8, 0, 1}; Line(31) = {31, 32}; Curve{31} In Surface{1};
Physical Curve("fault") += {31};
"""
        said = self.assert_faults({"fault": 6 + numpy.hypot(6, 1) + 16}, pieces)
        self.assertNotIn("divided", said)

    def test_a_branch_in_space(self):
        text = BOX.replace("FROM", "2 + 1").replace("ANGLE", "Pi/3")
        branch = text.replace("Rectangle(21) = {-1", "Rectangle(21) = {0").replace("2 + 1", "2.5")
        self.assert_faults({"fault.1": 12, "fault.2": 5}, branch)
        with h5py.File("case.h5") as file:
            x = file["vertices"][:]
        inside = numpy.sort(x[(abs(x[:, [0, 2]]) < 1e-9).all(axis=1) & (abs(x[:, 1]) < 0.99), 1])
        self.assertGreater(len(inside), 1)  # beside the tips
        found = re.search(r"joint            fault.2 ends on fault.1 at (\d+) vertices from "
                          r"\(\S+, (\S+), \S+\) to \(\S+, (\S+), \S+\) m, (\S+) m long",
                          mesh_tool.run("info", "case.h5").stdout)
        self.assertEqual(int(found[1]), len(inside))
        numpy.testing.assert_allclose(sorted(map(float, found.groups()[1:3])), inside[[0, -1]],
                                      rtol=1e-5)
        self.assertAlmostEqual(float(found[4]), numpy.ptp(inside), delta=1e-5)

    def test_a_branch_of_an_antiplane_model(self):
        """It has a tip, or a joint, if the mesh is divided for such a model."""
        self.assert_faults({"main": 12, "splay": 4},
                           arms((-6, 0), (6, 0), (0, 4), names=["main", "main", "splay"]))
        for more, tips, joints in (((), 2, []), (("--antiplane",), 1, ["splay ends on main"])):
            with self.subTest(more):
                result = mesh_tool.run("partition", "case.h5", "--parts", "2", "--output",
                                       "two.h5", "--overwrite", *more)
                self.assertEqual(result.returncode, 0, result.stderr)
                info = mesh_tool.run("info", "two.h5").stdout
                self.assertRegex(info, rf"splay: .* {tips} tips?, ")
                self.assertEqual(re.findall(r"joint +(.*) at \(0, 0\) m\n", info), joints)

    def test_crossings(self):
        """Two faults may cross."""
        cross = (-6, 0), (6, 0), (0, 5), (0, -5)
        self.assert_faults({"fault.1": 12, "fault.2": 10}, arms(*cross))
        self.assert_faults({"a": 12, "b": 10}, arms(*cross, names="aabb"))
        self.assert_faults({"fault.1": 12, "fault.2": 6},
                           BOX.replace("FROM", "3").replace("ANGLE", "Pi/3"))
        self.assertRegex(mesh_tool.run("info", "case.h5").stdout,
                         r"crossing         fault.1 and fault.2 at .*\(0, ")

    def test_crossings_that_are_refused(self):
        """The message says which faults, where, and what to do."""
        advice = "Let one fault, with a name of its own, end at the other"
        star = (-6, 0), (6, 0), (0, 5), (0, -5), (4, 4), (-4, -4)
        self.assert_not_converted(arms(*star, names="aabbcc"),
                                  "faults 'a', 'b' and 'c' cross at (0, 0)", advice)

    def test_names_that_are_there(self):
        text = arms((-6, 0), (6, 0), (0, 5), names="aaa").replace(
            '"outside") = {1, 2, 3, 4}', '"a.2") = {1, 2, 3, 4}')
        self.assert_not_converted(text, "'a.2' is another group")

    def test_joints_of_names(self):
        """Of three names the two that bend least go on, and the third one is a branch."""
        ends = ((-6, 0), (6, 0), (3, 4))
        self.assert_faults({"main": 12, "splay": 5}, arms(*ends, names=["main", "main", "splay"]))
        names = ["west", "east", "splay"]
        for branch in ((3, 4), (0, 5)):
            self.assert_faults({"east": 6, "splay": 5, "west": 6},
                               arms(*ends[:2], branch, names=names))
        # No two of three go straighter on than the others. The remedy works.
        x = 27 ** 0.5
        star = arms((0, 6), (x, -3), (-x, -3), names=names)
        self.assert_not_converted(star, "'east', 'splay' and 'west' meet at (0, 0)", "same name",
                                  "--names 3=main,4=main")
        self.assert_faults({"main": 12, "splay": 6}, star, "--names", "east=main,west=main")

    def test_joints_on_both_sides(self):
        """What continues across another fault is one fault, and branches if it bends."""
        names = ["main", "main", "west", "east"]
        self.assert_faults({"east": 5, "main": 12, "west": 6},
                           arms((0, 6), (0, -6), (-6, 0), (5, 0), names=names))
        self.assertIn("crossing         east/west and main at (0, 0) m",
                      mesh_tool.run("info", "case.h5").stdout)
        self.assert_faults({"east": 5, "main": 12, "west": 6},
                           arms((0, 6), (0, -6), (-6, 0), (3, 4), names=names))
        info = mesh_tool.run("info", "case.h5").stdout
        self.assertNotIn("crossing", info)
        self.assertRegex(info, r"east.* 2 tips")


if __name__ == "__main__":
    unittest.main()
