"""asperity-mesh convert --simplices: cells of other kinds are cut into triangles and tetrahedra.

Bricks of hexahedra, prisms and pyramids in Gmsh's format 2.2, whose nodes have numbers in no order:
the cuts have to agree on common sides whatever the numbers are."""

import itertools
import pathlib
import random
import unittest

import h5py
import numpy

import mesh_tool

TRIANGLE, QUADRILATERAL, HEXAHEDRON, PRISM, PYRAMID = 2, 3, 5, 6, 7  # Gmsh's types
LINE_3, TRIANGLE_6, TETRAHEDRON_10, QUADRILATERAL_8, HEXAHEDRON_20 = 8, 9, 11, 16, 17
HEXAHEDRON_EDGES = ((0, 1), (0, 3), (0, 4), (1, 2), (1, 5), (2, 3), (2, 6), (3, 7), (4, 5), (4, 7),
                    (5, 6), (6, 7))  # in Gmsh's order
TETRAHEDRON_EDGES = ((0, 1), (1, 2), (2, 0), (3, 0), (2, 3), (1, 3))


class Mesh:
    """Nodes by place, elements of physical groups; shear makes hexahedra with oblique sides."""

    def __init__(self, dimension, seed=None):
        self.dimension, self.seed = dimension, seed
        self.nodes, self.elements = {}, []

    def node(self, place):
        place = tuple(numpy.asarray(place, dtype=float).tolist())
        return self.nodes.setdefault(place, len(self.nodes) + 1)

    def add(self, kind, group, places, edges=()):
        places = [numpy.asarray(place, dtype=float) for place in places]
        places += [(places[a] + places[b]) / 2 for a, b in edges]
        self.elements.append((kind, group, [self.node(place) for place in places]))

    def write(self, move=lambda place: place):
        numbers = list(range(1, len(self.nodes) + 1))
        if self.seed is not None:
            random.Random(self.seed).shuffle(numbers)
        d = self.dimension
        lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$PhysicalNames", "3",
                 f'{d} 1 "rock"', f'{d - 1} 2 "outside"', f'{d - 1} 3 "fault"', "$EndPhysicalNames",
                 "$Nodes", str(len(self.nodes))]
        for place, node in sorted(self.nodes.items(), key=lambda item: numbers[item[1] - 1]):
            lines.append(f"{numbers[node - 1]} " + " ".join(f"{x:.17g}" for x in move(place)))
        lines += ["$EndNodes", "$Elements", str(len(self.elements))]
        for number, (kind, group, nodes) in enumerate(self.elements, start=1):
            lines.append(f"{number} {kind} 2 {group} {group} "
                         + " ".join(str(numbers[node - 1]) for node in nodes))
        pathlib.Path("cells.msh").write_text("\n".join([*lines, "$EndElements", ""]))


def corners(x, y, z):
    return [(x, y, z), (x + 1, y, z), (x + 1, y + 1, z), (x, y + 1, z),
            (x, y, z + 1), (x + 1, y, z + 1), (x + 1, y + 1, z + 1), (x, y + 1, z + 1)]


def hexahedra(n, seed, kind=HEXAHEDRON, edges=()):
    """A cube of n^3 hexahedra; the fault is its middle z = n / 2."""
    mesh = Mesh(3, seed)
    square = ((0, 1), (1, 2), (2, 3), (3, 0)) if edges else ()
    side = QUADRILATERAL_8 if edges else QUADRILATERAL
    for x, y, z in itertools.product(range(n), repeat=3):
        mesh.add(kind, 1, corners(x, y, z), edges)
    for x, y in itertools.product(range(n), repeat=2):
        for z, group in ((0, 2), (n, 2), (n // 2, 3)):
            mesh.add(side, group, corners(x, y, z)[:4], square)
    return mesh


class Simplices(mesh_tool.Case):
    def convert(self, mesh, move=lambda place: place):
        mesh.write(move)
        result = mesh_tool.run("convert", "cells.msh", "cells.h5", "--overwrite", "--simplices")
        self.assertEqual(result.returncode, 0, result.stderr)
        with h5py.File("cells.h5") as file:
            found = {"vertices": file["vertices"][:], "cells": file["cells"][:]}
            for name in file["boundaries"]:
                found[name] = file[f"boundaries/{name}/facets"][:]
        self.warning = result.stderr
        return found

    def sizes(self, found, key):
        x = found["vertices"][found[key]]
        edges = x[:, 1:] - x[:, :1]
        gram = numpy.linalg.det(edges @ edges.transpose(0, 2, 1))
        return numpy.sqrt(gram) / (1, 1, 2, 6)[edges.shape[1]]

    def assert_conforming(self, found):
        """Sides of cells occur twice, or once on the outside, which the program checks too."""
        sides = {}
        for cell in found["cells"].tolist():
            for i in range(len(cell)):
                key = frozenset(cell[:i] + cell[i + 1:])
                sides[key] = sides.get(key, 0) + 1
        self.assertLessEqual(max(sides.values()), 2)
        for facet in found["fault"].tolist():
            self.assertEqual(sides[frozenset(facet)], 2)
        for facet in found["outside"].tolist():
            self.assertEqual(sides[frozenset(facet)], 1)
        return sum(1 for count in sides.values() if count == 1)

    def test_hexahedra(self):
        def shear(place):
            x, y, z = place
            return x + 0.4 * y - 0.2 * z, y + 0.3 * z, z - 0.1 * x
        determinant = numpy.linalg.det([[1, 0.4, -0.2], [0, 1, 0.3], [-0.1, 0, 1]])
        for seed in (None, 1, 2, 3):
            for move, volume in ((lambda place: place, 1), (shear, determinant)):
                with self.subTest(seed=seed, volume=volume):
                    found = self.convert(hexahedra(4, seed), move)
                    self.assertEqual(len(found["cells"]), 6 * 64)
                    numpy.testing.assert_allclose(self.sizes(found, "cells"), volume / 6)
                    self.assertEqual(self.assert_conforming(found), 2 * 6 * 16)
                    self.assertEqual((len(found["fault"]), len(found["outside"])), (32, 64))
                    self.assertEqual(self.warning, "")

    def test_prisms(self):
        for seed in (None, 1, 2):
            mesh = Mesh(3, seed)
            for x, y, z in itertools.product(range(2), range(2), range(2)):
                c = corners(x, y, z)
                mesh.add(PRISM, 1, [c[i] for i in (0, 1, 2, 4, 5, 6)])
                mesh.add(PRISM, 1, [c[i] for i in (0, 2, 3, 4, 6, 7)])
                mesh.add(QUADRILATERAL, 2, [c[i] for i in ((0, 1, 5, 4) if y == 0 else
                                                           (3, 2, 6, 7))])
                if z == 0:
                    mesh.add(TRIANGLE, 3, [c[i] for i in (4, 5, 6)])
                    mesh.add(TRIANGLE, 3, [c[i] for i in (4, 6, 7)])
            found = self.convert(mesh)
            self.assertEqual(len(found["cells"]), 3 * 16)
            numpy.testing.assert_allclose(self.sizes(found, "cells"), 1 / 6)
            self.assert_conforming(found)
            self.assertAlmostEqual(self.sizes(found, "fault").sum(), 4)
            self.assertAlmostEqual(self.sizes(found, "outside").sum(), 8)

    def test_pyramids(self):
        """A cube of six pyramids around its centre on a layer of hexahedra."""
        faces = ((0, 3, 2, 1), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
        for seed in (None, 1, 2, 3, 4):
            mesh = Mesh(3, seed)
            cube = corners(0, 0, 0)
            for face in faces:
                mesh.add(PYRAMID, 1, [cube[i] for i in face] + [(0.5, 0.5, 0.5)])
                if face != faces[1]:
                    mesh.add(QUADRILATERAL, 2, [cube[i] for i in face])
            mesh.add(HEXAHEDRON, 1, corners(0, 0, 1))
            mesh.add(QUADRILATERAL, 3, cube[4:])
            found = self.convert(mesh)
            self.assertEqual(len(found["cells"]), 2 * 6 + 6)
            self.assertAlmostEqual(self.sizes(found, "cells").sum(), 2)
            self.assert_conforming(found)
            self.assertAlmostEqual(self.sizes(found, "outside").sum(), 5)

    def test_quadrilaterals(self):
        for seed in (None, 1, 2):
            mesh = Mesh(2, seed)
            for x, y in itertools.product(range(3), range(2)):
                c = corners(x, y, 0)[:4]
                mesh.add(QUADRILATERAL if y == 0 else QUADRILATERAL_8, 1 + 3 * y, c,
                         () if y == 0 else ((0, 1), (1, 2), (2, 3), (3, 0)))
                mesh.add(LINE_3, 2 + y, c[:2], ((0, 1),))
            mesh.write()
            found = self.convert(mesh)
            self.assertEqual(len(found["cells"]), 12)
            numpy.testing.assert_allclose(self.sizes(found, "cells"), 0.5)
            numpy.testing.assert_allclose(self.sizes(found, "fault"), [1, 1, 1])
            self.assert_conforming(found)

    def test_second_order(self):
        found = self.convert(hexahedra(2, 5, HEXAHEDRON_20, HEXAHEDRON_EDGES))
        self.assertEqual((len(found["vertices"]), len(found["cells"])), (27, 48))
        numpy.testing.assert_allclose(self.sizes(found, "cells"), 1 / 6)
        self.assertEqual(self.warning, "")
        mesh = Mesh(3)
        places = [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)]
        mesh.add(TETRAHEDRON_10, 1, places, TETRAHEDRON_EDGES)
        mesh.add(TRIANGLE_6, 2, places[:3], TETRAHEDRON_EDGES[:3])
        found = self.convert(mesh)
        self.assertEqual((len(found["vertices"]), len(found["outside"])), (4, 1))
        # A node of an edge that is not in its middle.
        self.convert(mesh, lambda place: (place[0] + 0.125 * (place == (0, 0, 0.5)), *place[1:]))
        self.assertIn("curved", self.warning)
        self.assertIn("by up to 0.125 m", self.warning)

    def test_refused(self):
        hexahedra(2, None).write()
        self.assert_refused(["convert", "cells.msh", "bad.h5"], "cell 1 is a hexahedron",
                            "--simplices")
        hexahedra(2, None, HEXAHEDRON_20, HEXAHEDRON_EDGES).write()
        self.assert_refused(["convert", "cells.msh", "bad.h5"], "hexahedron of second order")
        # A corner of a side beyond the opposite one: not convex.
        hexahedra(2, None).write(
            lambda place: (0.8, 0.8, 1) if place == (2, 2, 1) else place)
        self.assert_refused(["convert", "cells.msh", "bad.h5", "--simplices"],
                            "the hexahedron at (1, 1, 0) m cannot be cut", "not convex")
        mesh = Mesh(3)
        mesh.add(29, 1, numpy.random.default_rng(1).random((20, 3)))  # third order
        mesh.add(TRIANGLE, 2, [(0, 0, 0), (1, 0, 0), (0, 1, 0)])
        mesh.write()
        self.assert_refused(["convert", "cells.msh", "bad.h5", "--simplices"], "Tetrahedron 20",
                            "first and, with --simplices, second order")
        self.assertEqual(list(pathlib.Path(".").glob("bad.h5*")), [])


if __name__ == "__main__":
    unittest.main()
