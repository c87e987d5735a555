"""asperity-mesh convert: Exodus, Abaqus and VTK (other_formats.py writes them).

The second argument is a folder with files of other projects; it may be missing."""

import itertools
import pathlib
import random
import sys
import unittest

import h5py
import numpy

import mesh_tool
import other_formats

PUBLIC = pathlib.Path(sys.argv.pop(1))

# Sides of cells by nodes from 1 on, as the manuals of the formats print them.
EXODUS_SIDES = {
    "triangle": ((1, 2), (2, 3), (3, 1)),
    "quad": ((1, 2), (2, 3), (3, 4), (4, 1)),
    "tetra": ((1, 2, 4), (2, 3, 4), (1, 4, 3), (1, 3, 2)),
    "pyramid": ((1, 2, 5), (2, 3, 5), (3, 4, 5), (1, 5, 4), (1, 4, 3, 2)),
    "wedge": ((1, 2, 5, 4), (2, 3, 6, 5), (1, 4, 6, 3), (1, 3, 2), (4, 5, 6)),
    "hexahedron": ((1, 2, 6, 5), (2, 3, 7, 6), (3, 4, 8, 7), (1, 5, 8, 4), (1, 4, 3, 2),
                   (5, 6, 7, 8))}
ABAQUS_SIDES = {
    "tetra": ((1, 2, 3), (1, 4, 2), (2, 4, 3), (3, 4, 1)),
    "pyramid": ((1, 2, 3, 4), (1, 5, 2), (2, 5, 3), (3, 5, 4), (4, 5, 1)),
    "wedge": ((1, 2, 3), (4, 6, 5), (1, 4, 5, 2), (2, 5, 6, 3), (3, 6, 4, 1)),
    "hexahedron": ((1, 2, 3, 4), (5, 8, 7, 6), (1, 5, 6, 2), (2, 6, 7, 3), (3, 7, 8, 4),
                   (4, 8, 5, 1))}
POINTS = {"triangle": [(0, 0, 0), (2, 0, 0), (0, 3, 0)],
          "quad": [(0, 0, 0), (2, 0, 0), (2.5, 3, 0), (0, 3, 0)],
          "tetra": [(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 4)],
          "pyramid": [(0, 0, 0), (2, 0, 0), (2, 3, 0), (0, 3, 0), (1, 1, 4)],
          "wedge": [(0, 0, 0), (2, 0, 0), (0, 3, 0), (0, 0, 4), (2, 0, 4), (0, 3, 4)],
          "hexahedron": [(0, 0, 0), (2, 0, 0), (2, 3, 0), (0, 3, 0),
                         (0, 0, 4), (2, 0, 4), (2, 3, 4), (0, 3, 4)]}


def brick(sides_of=None):
    """Hexahedra from 0 to 2, cut in the middle by a fault z = 1, whose sides are given from above
    and below if the format has sides, or else as quadrilaterals. Two regions."""
    points = [(x, y, z) for z, y, x in itertools.product(range(3), repeat=3)]
    cells = [[points.index((x + i, y + j, z + k))
              for i, j, k in ((0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1),
                              (1, 1, 1), (0, 1, 1))]
             for z, y, x in itertools.product(range(2), repeat=3)]
    mesh = {"points": points, "sides": {}, "nodes": {},
            "blocks": {"lower": ("hexahedron", cells[:4]), "upper": ("hexahedron", cells[4:])}}
    planes = {"bottom": (2, 0), "fault": (2, 1), "left": (0, 0)}
    for name, (axis, value) in planes.items():
        on_plane = {i for i, point in enumerate(points) if point[axis] == value}
        if sides_of:
            mesh["sides"][name] = [
                (number, side) for number, cell in enumerate(cells)
                for side, nodes in enumerate(sides_of["hexahedron"], start=1)
                if {cell[node - 1] for node in nodes} <= on_plane]
        else:
            quads = {tuple(sorted(q)): q for cell in cells for nodes in EXODUS_SIDES["hexahedron"]
                     for q in [[cell[node - 1] for node in nodes]] if set(q) <= on_plane}
            mesh["blocks"][name] = ("quad", list(quads.values()))
    return mesh


def half_bricks(overlap=False):
    """The brick below and above its middle, each with its own points; the fault is in the lower
    one. overlap: the upper one repeats the lower one as ghosts."""
    whole = brick()
    halves = []
    for own, groups in (("lower", ("bottom", "fault", "left")), ("upper", ("left",))):
        blocks, ghosts = {}, []
        for name, (kind, cells) in whole["blocks"].items():
            heights = [sum(whole["points"][i][2] for i in cell) / len(cell) for cell in cells]
            inside = [height < 1 if own == "lower" else height > 1 for height in heights]
            kept = [cell for cell, is_inside, height in zip(cells, inside, heights)
                    if is_inside or (height == 1 and name in groups)
                    or (overlap and own == "upper" and kind == "hexahedron")]
            blocks[name] = (kind, kept)
            ghosts += [int(overlap and own == "upper" and name == "lower")] * len(kept)
        used = sorted({i for _, cells in blocks.values() for cell in cells for i in cell})
        number = {old: new for new, old in enumerate(used)}
        halves.append({"points": [whole["points"][i] for i in used], "sides": {}, "nodes": {},
                       "ghosts": ghosts,
                       "blocks": {name: (kind, [[number[i] for i in cell] for cell in cells])
                                  for name, (kind, cells) in blocks.items()}})
    return halves


PARALLEL = """<VTKFile type="PUnstructuredGrid"><PUnstructuredGrid>
<Piece Source="lower.vtu"/><Piece Source="upper.vtu"/></PUnstructuredGrid></VTKFile>
"""


class Case(mesh_tool.Case):
    def convert(self, name, *options):
        result = mesh_tool.run("convert", name, "out.h5", "--overwrite", *options)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.said = result.stdout + result.stderr
        with h5py.File("out.h5") as file:
            found = {key: file[key][:] for key in ("vertices", "cells", "cell_regions")}
            found["regions"] = file["region_names"].asstr()[:].tolist()
            found["boundaries"] = {key: group["facets"][:]
                                   for key, group in file["boundaries"].items()}
        return found

    def places(self, found, simplices):
        return sorted(sorted(map(tuple, corners))
                      for corners in found["vertices"][simplices].tolist())

    def assert_brick(self, found, names=("lower", "upper", "bottom", "fault", "left")):
        """Cells and facets as from Gmsh's format, whose test knows their volumes."""
        lower, upper, bottom, fault, left = names
        self.assertEqual(len(found["cells"]), 48)
        volumes = numpy.linalg.det(found["vertices"][found["cells"][:, 1:]]
                                   - found["vertices"][found["cells"][:, :1]]) / 6
        numpy.testing.assert_allclose(volumes, 1 / 6)
        heights = found["vertices"][found["cells"]].mean(axis=1)[:, 2]
        of_cell = [found["regions"][region] for region in found["cell_regions"]]
        self.assertEqual(of_cell, [lower if z < 1 else upper for z in heights])
        self.assertEqual(set(found["boundaries"]), {bottom, fault, left})
        for name, axis, value in ((bottom, 2, 0), (fault, 2, 1), (left, 0, 0)):
            x = found["vertices"][found["boundaries"][name]]
            self.assertEqual(len(x), 8)
            numpy.testing.assert_array_equal(x[:, :, axis], value)
            areas = numpy.linalg.norm(numpy.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1) / 2
            numpy.testing.assert_allclose(areas, 0.5)
            self.assertEqual(len({tuple(sorted(map(tuple, facet))) for facet in x.tolist()}), 8)

    def refuse(self, name, content, *pieces, options=()):
        pathlib.Path(name).write_bytes(content if isinstance(content, bytes) else content.encode())
        self.assert_refused(["convert", name, "bad.h5", *options], name, *pieces)
        self.assertEqual(list(pathlib.Path(".").glob("bad.h5*")), [])


class Exodus(Case):
    def test_side_sets_on_both_sides(self):
        mesh = brick(EXODUS_SIDES)
        for version in (1, 2):
            pathlib.Path("brick.exo").write_bytes(other_formats.exodus(mesh, version))
            self.assert_brick(self.convert("brick.exo", "--simplices"))
        other_formats.exodus_netcdf4(mesh, "brick4.exo")
        self.assert_brick(self.convert("brick4.exo", "--simplices"))
        pathlib.Path("brick.e").write_bytes(other_formats.exodus({**mesh, "named": False}))
        self.assert_brick(self.convert("brick.e", "--simplices", "--names", "10=low,11=fault",
                                       "--region-names", "1=a"),
                          ("a", "region_2", "low", "fault", "boundary_12"))
        self.assertIn("set 12 is called 'boundary_12'", self.said)

    def test_node_sets(self):
        """Also a set of an edge, which has no sides, and one of all nodes."""
        mesh = brick()
        for name in ("bottom", "fault", "left"):
            mesh["nodes"][name] = sorted({n for q in mesh["blocks"].pop(name)[1] for n in q})
        mesh["nodes"].update({"edge": [0, 1, 2], "all": range(27)})
        pathlib.Path("brick.exo").write_bytes(other_formats.exodus(mesh))
        self.assert_brick(self.convert("brick.exo", "--simplices"))
        self.assertIn("left out: 'edge', 'all'", self.said)

    def test_a_node_set_of_a_bent_fault(self):
        """An L: the nodes at its bend are those of a side of the outside, too."""
        mesh = brick()
        mesh["blocks"] = {key: mesh["blocks"][key] for key in ("lower", "upper")}
        mesh["nodes"]["fault"] = [i for i, (x, _, z) in enumerate(mesh["points"])
                                  if (z == 1 and x <= 1) or (x == 1 and z <= 1)]
        pathlib.Path("brick.exo").write_bytes(other_formats.exodus(mesh))
        found = self.convert("brick.exo", "--simplices")
        self.assertEqual(len(found["boundaries"]["fault"]), 8)

    def test_blocks_of_sides(self):
        pathlib.Path("brick.exo").write_bytes(other_formats.exodus(brick()))
        self.assert_brick(self.convert("brick.exo", "--simplices"))

    def test_every_side_of_every_cell(self):
        for kind, sides in EXODUS_SIDES.items():
            points = POINTS[kind]
            mesh = {"points": points, "nodes": {}, "flat": kind in ("triangle", "quad"),
                    "blocks": {"rock": (kind, [list(range(len(points)))])},
                    "sides": {f"s{k}": [(0, k)] for k in range(1, len(sides) + 1)}}
            pathlib.Path("one.exo").write_bytes(other_formats.exodus(mesh))
            found = self.convert("one.exo", "--simplices")
            for k, nodes in enumerate(sides, start=1):
                corners = {tuple(found["vertices"][v]) for v in
                           found["boundaries"][f"s{k}"].ravel()}
                d = found["vertices"].shape[1]
                self.assertEqual(corners, {tuple(map(float, points[n - 1][:d])) for n in nodes})

    def test_damaged(self):
        mesh = brick(EXODUS_SIDES)
        good = other_formats.exodus(mesh)
        self.refuse("a.exo", good, "cell 1 is a hexahedron", "--simplices")
        simplices = ("--simplices",)
        self.refuse("a.exo", good[:len(good) // 2], options=simplices)
        self.refuse("a.exo", b"no mesh", "neither CDF nor HDF")
        bad = {**mesh, "sides": {"s": [(8, 1)]}}
        self.refuse("a.exo", other_formats.exodus(bad), "element 9, outside [1, 8]",
                    options=simplices)
        bad = {**mesh, "sides": {"s": [(0, 7)]}}
        self.refuse("a.exo", other_formats.exodus(bad), "side 7, outside [1, 6]", options=simplices)
        bad = {**mesh, "nodes": {"n": [27]}}
        self.refuse("a.exo", other_formats.exodus(bad), "node 28, outside [1, 27]",
                    options=simplices)
        self.refuse("a.exo", good.replace(b"HEX8", b"HAX8"), "type 'HAX8'", options=simplices)
        self.refuse("a.exo", good, "no such boundary or fault", "'fault'",
                    options=("--simplices", "--without", "falt"))
        other_formats.exodus_netcdf4(mesh, "whole.exo")
        whole = pathlib.Path("whole.exo").read_bytes()
        self.refuse("a.exo", whole[:len(whole) // 2], "cut or damaged")


class Abaqus(Case):
    def test_surfaces_and_sections(self):
        mesh = brick(ABAQUS_SIDES)
        numbers = random.Random(1).sample(range(1, 100), 27)
        for sections, of_nodes in itertools.product((False, True), (None, numbers)):
            pathlib.Path("brick.inp").write_text(other_formats.abaqus(mesh, of_nodes, sections))
            self.assert_brick(self.convert("brick.inp", "--simplices"))
        found = self.convert("brick.inp", "--simplices", "--names", "fault=main,left=far",
                             "--region-names", "lower=crust", "--without", "bottom")
        self.assertEqual(set(found["boundaries"]), {"main", "far"})
        self.assertEqual(found["regions"], ["crust", "upper"])

    def test_shells_and_sets_of_nodes(self):
        pathlib.Path("brick.inp").write_text(other_formats.abaqus(brick()))
        self.assert_brick(self.convert("brick.inp", "--simplices"))
        mesh = brick()
        for name in ("bottom", "fault", "left"):
            mesh["nodes"][name] = sorted({n for q in mesh["blocks"].pop(name)[1] for n in q})
        text = other_formats.abaqus(mesh)
        pathlib.Path("brick.inp").write_text(text)
        self.assert_brick(self.convert("brick.inp", "--simplices"))
        text = text.replace("*Nset, nset=left", "*Nset, nset=_left, internal")
        pathlib.Path("brick.inp").write_text(
            text.replace("nset=_left", "nset=left_") +
            "*Surface, type=NODE, name=left\nleft_, 1.\n")
        found = self.convert("brick.inp", "--simplices", "--without", "left_")
        self.assert_brick(found)

    def test_every_side_of_every_cell(self):
        for kind, sides in ABAQUS_SIDES.items():
            points = POINTS[kind]
            mesh = {"points": points, "nodes": {},
                    "blocks": {"rock": (kind, [list(range(len(points)))])},
                    "sides": {f"s{k}": [(0, k)] for k in range(1, len(sides) + 1)}}
            pathlib.Path("one.inp").write_text(other_formats.abaqus(mesh))
            found = self.convert("one.inp", "--simplices")
            for k, nodes in enumerate(sides, start=1):
                corners = {tuple(found["vertices"][v]) for v in
                           found["boundaries"][f"s{k}"].ravel()}
                self.assertEqual(corners, {tuple(map(float, points[n - 1])) for n in nodes})

    def test_damaged(self):
        good = other_formats.abaqus(brick(ABAQUS_SIDES))
        self.refuse("a.inp", good, "is a hexahedron", "--simplices")
        for old, new, piece in (
                ("*Node, nset=all", "*Include, input=nodes.inp", "*INCLUDE is not followed"),
                ("type=C3D8R", "type=ROTARYI", "'ROTARYI'"),
                ("\n1, 0, 0, 0", "\n2, 0, 0, 0", "node 2 is given twice"),
                ("\n1, 0, 0, 0", "\n1, 0, 0, nan", "'nan'"),
                ("\n1, 0, 0, 0", "", "has node 1, which is not there"),
                ("name=fault\n", "name=fault\nnone, S1\n", "'none', which is neither"),
                ("name=fault\n", "name=fault\n1, S7\n", "side 'S7' of element 1"),
                ("name=fault\n", "\n", "*SURFACE needs a name"),
                ("elset=_fault_S1", "elset=_fault_S1, generate", "first, last, step"),
                ("*HEADING", "*Instance, name=a, part=b\n 1., 0., 0.\n*HEADING", "instance")):
            self.assertIn(old, good)
            self.refuse("a.inp", good.replace(old, new, 1), piece, options=("--simplices",))
        elements = good[:good.index("*Element")]
        self.refuse("a.inp", elements, "has no *ELEMENT")
        self.refuse("a.inp", good[:good.index("*Element")] + "*Element, type=C3D8\n1, 1, 2,\n",
                    "element 1 ends with a comma")


class Vtk(Case):
    NAMES = ("--simplices", "--region-names", "1=lower,2=upper", "--names",
             "3=bottom,4=fault,5=left")

    def test_legacy(self):
        for binary, version in itertools.product((False, True), ("3.0", "4.2", "5.1")):
            pathlib.Path("brick.vtk").write_bytes(other_formats.vtk(brick(), binary, version))
            self.assert_brick(self.convert("brick.vtk", *self.NAMES))

    def test_xml(self):
        brick_ = brick()
        for form, header, compressed, order, together in (
                ("ascii", "UInt32", False, "LittleEndian", True),
                ("binary", "UInt32", False, "LittleEndian", True),
                ("binary", "UInt64", False, "LittleEndian", False),
                ("binary", "UInt32", True, "BigEndian", True),
                ("appended raw", "UInt64", False, "BigEndian", True),
                ("appended raw", "UInt32", True, "LittleEndian", True),
                ("appended base64", "UInt32", False, "LittleEndian", True),
                ("appended base64", "UInt64", True, "LittleEndian", True)):
            with self.subTest(form=form, header=header, compressed=compressed, order=order):
                pathlib.Path("brick.vtu").write_bytes(other_formats.vtu(
                    brick_, form, header, compressed, order, together))
                self.assert_brick(self.convert("brick.vtu", *self.NAMES, "--array", "group"))

    def test_pieces(self):
        """Two halves, in one file and in two, are the body of one file."""
        for form in ("ascii", "appended raw", "binary"):
            halves = [other_formats.vtu(half, form) for half in half_bricks()]
            for name, half in zip(("lower.vtu", "upper.vtu"), halves):
                pathlib.Path(name).write_bytes(half)
            pathlib.Path("brick.pvtu").write_text(PARALLEL)
            self.assert_brick(self.convert("brick.pvtu", *self.NAMES, "--array", "group"))
            self.assertIn("2 pieces are put together at 9 points", self.said)
        one, two = (other_formats.vtu(half) for half in half_bricks())
        begin, end = two.index(b"<Piece"), two.index(b"</UnstructuredGrid>")
        pathlib.Path("brick.vtu").write_bytes(
            one.replace(b"</UnstructuredGrid>", two[begin:end] + b"</UnstructuredGrid>"))
        self.assert_brick(self.convert("brick.vtu", *self.NAMES, "--array", "group"))

    def test_cells_that_pieces_repeat(self):
        """Cells of vtkGhostType are those of another piece."""
        for name, half in zip(("lower.vtu", "upper.vtu"), half_bricks(overlap=True)):
            pathlib.Path(name).write_bytes(other_formats.vtu(half))
        pathlib.Path("brick.pvtu").write_text(PARALLEL)
        self.assert_brick(self.convert("brick.pvtu", *self.NAMES, "--array", "group"))

    def test_pieces_that_do_not_fit(self):
        lower, upper = half_bricks()
        pathlib.Path("brick.pvtu").write_text(PARALLEL)
        options = ("--simplices", "--array", "group")
        pathlib.Path("lower.vtu").write_bytes(other_formats.vtu(lower))
        pathlib.Path("upper.vtu").unlink(missing_ok=True)
        self.assert_refused(["convert", "brick.pvtu", "bad.h5", *options], "upper.vtu")
        apart = dict(upper, points=[(x, y, z + 1) for x, y, z in upper["points"]])
        pathlib.Path("upper.vtu").write_bytes(other_formats.vtu(apart))
        self.convert("brick.pvtu", *options)
        self.assertIn("The body is in pieces, too.", self.said)
        doubled = dict(upper, points=upper["points"] + [lower["points"][-1]])
        pathlib.Path("upper.vtu").write_bytes(other_formats.vtu(doubled))
        self.assert_refused(["convert", "brick.pvtu", "bad.h5", *options],
                            "several points at (2, 2, 1)", "one piece")
        pathlib.Path("brick.pvtu").write_text(PARALLEL.replace("Source", "File"))
        self.assert_refused(["convert", "brick.pvtu", "bad.h5"], "piece without Source")

    def test_options_of_other_formats(self):
        pathlib.Path("brick.vtk").write_bytes(other_formats.vtk(brick()))
        self.assert_refused(["convert", "brick.vtk", "bad.h5", "--set", "h=1"], "Option --set h=1",
                            "is read as VTK", "only for Gmsh")
        pathlib.Path("brick.inp").write_text(other_formats.abaqus(brick(ABAQUS_SIDES)))
        self.assert_refused(["convert", "brick.inp", "bad.h5", "--array", "group"],
                            "Option --array group", "is read as Abaqus", "only for VTK")

    def test_numbers_without_names(self):
        pathlib.Path("brick.vtk").write_bytes(other_formats.vtk(brick()))
        self.assert_brick(self.convert("brick.vtk", "--simplices"),
                          ("region_1", "region_2", "boundary_3", "boundary_4", "boundary_5"))
        self.assertIn("number 4 is called 'boundary_4'", self.said)
        self.assert_refused(["convert", "brick.vtk", "bad.h5", "--simplices", "--array", "rank"],
                            "boundary 'boundary_0' has facets inside the body",
                            "and on its surface")

    def test_plane_pixels_and_no_boundaries(self):
        text = """# vtk DataFile Version 3.0
pixels
ASCII
DATASET UNSTRUCTURED_GRID
POINTS 6 float
0 0 0 1 0 0 2 0 0 0 1 0 1 1 0 2 1 0
CELLS 2 10
4 0 1 3 4 4 1 2 4 5
CELL_TYPES 2
8 8
"""
        pathlib.Path("pixels.vtk").write_text(text)
        found = self.convert("pixels.vtk", "--simplices")
        self.assertEqual((len(found["cells"]), found["regions"]), (4, ["region_1"]))
        self.assertIn("no boundaries and faults", self.said)

    def test_damaged(self):
        good = other_formats.vtk(brick())
        self.refuse("a.vtk", good, "is a hexahedron", "--simplices")
        self.refuse("a.vtk", b"no mesh", "'# vtk DataFile Version'")
        for old, new, piece in ((b"ASCII", b"ASCI", "ASCII or BINARY"),
                                (b"POINTS 27", b"POINTS 2700000000", "number of values"),
                                (b"POINTS 27", b"POINTS 270000000", "too short"),
                                (b"UNSTRUCTURED_GRID", b"POLYDATA", "'POLYDATA'"),
                                (b"\n8 0 1", b"\n8 70 1", "point 70, outside [0, 27)"),
                                (b"CELL_TYPES", b"CELL_TIPES", "'cell_tipes' is not known"),
                                (b"\n12 12", b"\n42 12", "VTK's type 42")):
            self.assertIn(old, good)
            self.refuse("a.vtk", good.replace(old, new, 1), piece, options=("--simplices",))
        self.refuse("a.vtk", good, "'CellEntityIds'", "no such array of cell data",
                    options=("--simplices", "--array", "CellEntityId"))
        good = other_formats.vtu(brick(), "binary", compressed=True)
        self.refuse("a.vtu", good[:len(good) // 2])
        self.refuse("a.vtu", good.replace(b'type="UnstructuredGrid"', b'type="PolyData"'),
                    "not a complete file of VTK's type UnstructuredGrid")
        self.refuse("a.vtu", good.replace(b"vtkZLib", b"vtkLZ4"), "vtkLZ4DataCompressor")
        self.refuse("a.vtu", other_formats.vtu(brick()).replace(b"Piece", b"Peace"), "no piece")


class Published(Case):
    """Files of other projects, which are not in the tree."""

    def need(self, name):
        if not (PUBLIC / name).exists():
            self.skipTest(f"{name} is not in {PUBLIC}")
        return str(PUBLIC / name)

    def areas(self, found, name):
        x = found["vertices"][found["boundaries"][name]]
        edges = x[:, 1:] - x[:, :1]
        return (numpy.linalg.norm(edges[:, 0], axis=1).sum() if x.shape[1] == 2 else
                numpy.linalg.norm(numpy.cross(edges[:, 0], edges[:, 1]), axis=1).sum() / 2)

    def test_node_sets_of_a_box(self):
        found = self.convert(self.need("pylith_box3d_tet.exo"))
        self.assertEqual(len(found["cells"]), 381)
        for name, area in (("zpos", 144e6), ("zneg", 144e6), ("xpos", 108e6), ("xneg", 108e6),
                           ("ypos", 108e6), ("yneg", 108e6)):
            self.assertAlmostEqual(self.areas(found, f"boundary_{name}") / area, 1, places=9)

    def test_a_subduction_zone(self):
        """Its coseismic fault is a part of the top of the slab; sides are given from both sides."""
        name = self.need("pylith_subduction2d_tri.exo")
        found = self.convert(name)
        number = {key: len(facets) for key, facets in found["boundaries"].items()}
        self.assertEqual((number["fault_coseismic"], number["fault_slabtop"],
                          number["fault_slabbot"]), (51, 77 - 51, 102))
        self.assertIn("51 facets are in fault 'fault_slabtop'", self.said)
        whole = self.convert(name, "--without", "fault_coseismic")
        self.assertEqual(len(whole["boundaries"]["fault_slabtop"]), 77)

    def test_crossing_faults(self):
        """Two that end at the main fault continue each other: they bend by 5 degrees there."""
        name = self.need("pylith_crustal2d_tri.msh")
        self.convert(name)
        self.assertIn("crossing         fault_east/fault_west and fault_main at (453735",
                      mesh_tool.run("info", "out.h5").stdout)
        found = self.convert(name, "--without", "fault_west")
        self.assertEqual({key for key in found["boundaries"] if key.startswith("fault")},
                         {"fault_main", "fault_east"})


if __name__ == "__main__":
    unittest.main()
