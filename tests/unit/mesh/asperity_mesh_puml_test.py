"""asperity-mesh, given as the first argument: converts SeisSol's meshes (PUML), refuses errors.

The second argument is a folder with files of other projects; without a mesh of SeisSol's there one
test is left out."""

import collections
import os
import sys
import unittest

import h5py
import mesh_tool
import numpy

PUBLISHED = os.path.join(sys.argv.pop(1), "tpv13_training.puml.h5")
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))  # of SeisSol

# A pyramid over a square and its mirror image below, each of two tetrahedra: 0 to 3 is the square,
# which is a fault, 4 the upper top and 5 the lower one, 6 is in no cell.
VERTICES = numpy.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0.5, 0.5, 1],
                        [0.5, 0.5, -1], [9, 9, 9]], dtype=float)
CELLS = numpy.array([[0, 1, 2, 4], [0, 2, 3, 4], [0, 2, 1, 5], [0, 3, 2, 5]])
GROUPS = numpy.array([2, 2, 7, 7], dtype="i4")
SQUARE = {0, 1, 2, 3}
FREE, FAULT, FAR = 1, 3, 5


def code(vertices):
    if set(vertices) <= SQUARE:
        return FAULT
    if {0, 2} <= set(vertices):
        return 0  # between the two tetrahedra of a pyramid
    return FREE if 4 in vertices else FAR


def codes():
    return numpy.array([[code([cell[k] for k in face]) for face in FACES] for cell in CELLS])


def packed(bits):
    return sum(codes()[:, face].astype("i8") << (bits * face) for face in range(4))


def write(name="pyramids.puml.h5", leave_out=(), **changes):
    data = {"connect": CELLS.astype("i8"), "geometry": VERTICES, "group": GROUPS,
            "boundary": packed(8).astype("i4"), **changes}
    with h5py.File(name, "w") as file:
        for key, values in data.items():
            if key not in leave_out:
                file[key] = values
    return name


class Convert(mesh_tool.Case):
    NAMES = ("--names", "1=free,3=fault,5=far")

    def assert_pyramids(self, *options):
        text = self.assert_done("convert", "pyramids.puml.h5", "out.h5", "--overwrite", *options)
        self.assertIn("6 vertices, 4 cells, 2 regions, 2 boundaries, 1 faults", text)
        with h5py.File("out.h5") as file:
            self.assertEqual(set(file["boundaries"]), {"free", "fault", "far"})
            x = file["vertices"][:]
            for cell in file["cells"]:
                self.assertAlmostEqual(numpy.linalg.det(x[cell[1:]] - x[cell[0]]), 1)
            names = file["region_names"].asstr()[:]
            self.assertEqual([names[r] for r in file["cell_regions"]],
                             ["region_2", "region_2", "region_7", "region_7"])
            facets = {name: file[f"boundaries/{name}/facets"][:] for name in file["boundaries"]}
            self.assertEqual({name: len(of) for name, of in facets.items()},
                             {"free": 4, "fault": 2, "far": 4})
            for name, top in (("free", 4), ("far", 5)):
                for facet in facets[name]:
                    self.assertIn(top, facet)
                    normal = numpy.cross(x[facet[1]] - x[facet[0]], x[facet[2]] - x[facet[0]])
                    outward = x[facet].mean(axis=0) - [0.5, 0.5, 0]
                    self.assertGreater(normal @ outward, 0)
        return text

    def test_both_sides_of_a_fault_are_one_boundary(self):
        write()
        text = self.assert_pyramids(*self.NAMES)
        self.assertIn("group 2 is called 'region_2'", text)
        self.assertIn("z from -1 to 1 m", text)
        self.assertIn("fault: 2 facets, 4 vertices", self.assert_done("info", "out.h5"))

    def test_widths_of_codes(self):
        for changes, attribute in (({"boundary": packed(16)}, None),
                                   ({"boundary": packed(16)}, "i64"),
                                   ({"boundary": packed(8)}, numpy.bytes_("i32")),
                                   ({"boundary": packed(8).astype("u4")}, "i32"),
                                   ({"boundary": codes().astype("i4")}, "i32x4")):
            write(**changes)
            if attribute is not None:
                with h5py.File("pyramids.puml.h5", "a") as file:
                    file.attrs["boundary-format"] = attribute
            with self.subTest(attribute=attribute):
                self.assert_pyramids(*self.NAMES)

    def test_meanings_are_names(self):
        write()
        text = self.assert_done("convert", "pyramids.puml.h5", "out.h5")
        self.assertIn("face code 5 is called 'absorbing'", text)
        with h5py.File("out.h5") as file:
            self.assertEqual(set(file["boundaries"]), {"free_surface", "fault", "absorbing"})

    def test_scale_regions_and_what_is_left_out(self):
        write()
        text = self.assert_done("convert", "pyramids.puml.h5", "out.h5", "--scale", "1000",
                                "--region-names", "2=rock,7=rock", "--without", "absorbing")
        self.assertIn("x from 0 to 1000 m", text)
        self.assertIn("1 regions, 1 boundaries, 1 faults", text)

    def test_unused_names_are_told(self):
        write()
        result = mesh_tool.run("convert", "pyramids.puml.h5", "out.h5", "--names", "4=wall")
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("4=wall names nothing", result.stderr)
        self.assertIn("only 1, 3, 5", result.stderr)

    def refuse(self, *pieces, options=(), **changes):
        write(**changes)
        self.assert_refused(["convert", "pyramids.puml.h5", "bad.h5", *options],
                            "pyramids.puml.h5", *pieces)
        self.assertFalse(os.path.exists("bad.h5"))

    def test_errors(self):
        self.refuse("no dataset 'boundary'", leave_out=("boundary",))
        self.refuse("'group' needs 4 rows", group=GROUPS[:3])
        self.refuse("'connect' needs", "4 numbers", connect=CELLS[:, :3].astype("i8"))
        self.refuse("'connect'", "integers", connect=CELLS.astype(float))
        self.refuse("vertex 70, outside [0, 7)", connect=numpy.where(CELLS == 4, 70, CELLS))
        self.refuse("no such boundary or fault", "'absorbing'", options=("--without", "absorbin"))
        self.refuse("--set h=1", "only for Gmsh", options=("--set", "h=1"))
        with open("text.puml.h5", "w", encoding="utf-8") as file:
            file.write("no mesh")
        self.assert_refused(["convert", "text.puml.h5", "bad.h5"], "'text.puml.h5'",
                            "cannot be read")
        self.assert_refused(["convert", "mesh.txt", "bad.h5"], "'mesh.txt'",
                            ".geo, .inp, .msh, .puml.h5")


class Published(mesh_tool.Case):
    @unittest.skipUnless(os.path.exists(PUBLISHED), PUBLISHED + " is not there")
    def test_of_a_fault(self):
        text = self.assert_done("convert", PUBLISHED, "published.h5", *Convert.NAMES)
        with h5py.File(PUBLISHED) as file:
            connect, boundary = file["connect"][:], file["boundary"][:].astype("i8")
        sides = collections.Counter()
        of_code = collections.defaultdict(set)
        for number, face in enumerate(FACES):
            of_face = boundary >> (8 * number) & 255
            for cell in numpy.flatnonzero(of_face):
                key = tuple(sorted(connect[cell, list(face)].tolist()))
                sides[key, of_face[cell]] += 1
                of_code[of_face[cell]].add(key)
        self.assertEqual({sides[key, FAULT] for key in of_code[FAULT]}, {2})
        with h5py.File("published.h5") as file:
            self.assertEqual(len(file["cells"]), len(connect))
            for name, number in (("free", FREE), ("fault", FAULT), ("far", FAR)):
                self.assertEqual(len(file[f"boundaries/{name}/facets"]), len(of_code[number]))
        self.assertIn("1 faults", text)


if __name__ == "__main__":
    unittest.main()
