#!/usr/bin/env python3
"""Writes meshes of this folder as other programs have them, in km and with numbers for names.

others.msh      Gmsh's format 2.2, as for tandem or PyLith: groups 1 ground, 3 fault, 5 far
others.puml.h5  PUML, as for SeisSol: the same numbers as codes of faces, on both sides of the fault

Both have the same cells: bricks of six tetrahedra around a vertical fault at x = 0, 3 < y < 27 and
z > -12 km, cells of 3 km there. Needs python3-numpy and python3-h5py.
"""

import itertools
import pathlib

import h5py
import numpy

FOLDER = pathlib.Path(__file__).parent
AXES = (numpy.array([-21, -9, -3, 0, 3, 9, 21.0]),
        numpy.array([-9, 0, 3, 6, 9, 12, 15, 18, 21, 24, 27, 30, 39.0]),
        numpy.array([-24, -16, -12, -9, -6, -3, 0.0]))
GROUND, FAULT, FAR = 1, 3, 5
FACES = ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))  # of PUML, codes of 8 bits in this order


def grid():
    """Vertices (n, 3) and cells (m, 4), six around the diagonal of each brick."""
    number = numpy.arange(numpy.prod([len(axis) for axis in AXES])).reshape(
        [len(axis) for axis in AXES])
    vertices = numpy.stack(numpy.meshgrid(*AXES, indexing="ij"), axis=-1).reshape(-1, 3)
    cells = []
    for order in itertools.permutations(range(3)):
        corner = numpy.zeros(3, dtype=int)
        path = [corner.copy()]
        for axis in order:
            corner[axis] += 1
            path.append(corner.copy())
        cells.append(numpy.stack([number[tuple(
            slice(o, len(axis) - 1 + o) for o, axis in zip(offset, AXES))].ravel()
            for offset in path], axis=1))
    cells = numpy.concatenate(cells)
    edges = vertices[cells[:, 1:]] - vertices[cells[:, :1]]
    turned = numpy.linalg.det(edges) < 0
    cells[turned, 2:] = cells[turned, :1:-1]
    return vertices, cells


def code(corners):
    """The number of a facet with these corners (3, 3); 0 for what is no boundary."""
    def on(axis, value):
        return (corners[:, axis] == value).all()

    if on(2, AXES[2][-1]):
        return GROUND
    if any(on(axis, AXES[axis][end]) for axis, end in ((0, 0), (0, -1), (1, 0), (1, -1), (2, 0))):
        return FAR
    y, z = corners[:, 1], corners[:, 2]
    return FAULT if on(0, 0) and y.min() >= 3 and y.max() <= 27 and z.min() >= -12 else 0


def main():
    vertices, cells = grid()
    codes = numpy.array([[code(vertices[cell[list(face)]]) for face in FACES] for cell in cells])
    facets = {tuple(sorted(cell[list(face)])): value for cell, row in zip(cells, codes)
              for face, value in zip(FACES, row) if value}
    elements = [f"2 2 {value} {value} " + " ".join(str(v + 1) for v in facet)
                for facet, value in facets.items()]
    elements += ["4 2 1 1 " + " ".join(str(v + 1) for v in cell) for cell in cells]
    lines = ["$MeshFormat", "2.2 0 8", "$EndMeshFormat", "$Nodes", str(len(vertices))]
    lines += [f"{i} " + " ".join(f"{x:g}" for x in vertex) for i, vertex in enumerate(vertices, 1)]
    lines += ["$EndNodes", "$Elements", str(len(elements))]
    lines += [f"{i} {element}" for i, element in enumerate(elements, 1)]
    (FOLDER / "others.msh").write_text("\n".join(lines + ["$EndElements", ""]))
    packed = (codes << (8 * numpy.arange(4))).sum(axis=1, dtype="i4")
    with h5py.File(FOLDER / "others.puml.h5", "w") as file:
        for name, values in (("geometry", vertices), ("connect", cells.astype("i4")),
                             ("group", numpy.ones(len(cells), "i4")), ("boundary", packed)):
            file.create_dataset(name, data=values, compression="gzip", shuffle=True)


if __name__ == "__main__":
    main()
