"""Meshes of two bodies with a fault between them, written for the program.

A mesh is made on a grid in the coordinates (x, y) or (x, y, z), y across the fault, which lies at
y = 0. Sides are named by their place there. Then its vertices are mapped to where they shall be.
"""

import dataclasses
import itertools
import math

import mesh_files
import numpy

CLOSE = 1e-9


@dataclasses.dataclass(frozen=True)
class Mesh:
    vertices: numpy.ndarray  # (num_vertices, dimension) in m
    cells: numpy.ndarray     # (num_cells, dimension + 1), positively oriented
    boundaries: dict         # name: facets (num_facets, dimension)
    upper: numpy.ndarray     # (num_cells), whether the cell lies at y > 0 of the grid

    def mapped(self, place):
        """The same with each vertex at place(vertices)."""
        vertices = place(self.vertices)
        return dataclasses.replace(self, vertices=vertices,
                                   cells=oriented(vertices, self.cells.copy()))

    def write(self, name):
        """The regions are `lower` and `upper`."""
        mesh_files.write(name, self.vertices, self.cells, self.boundaries, self.upper.astype(int),
                         [b"lower", b"upper"])


def grid(*axes):
    """Vertices at all combinations of the coordinates; each brick has as many simplices as there
    are orders of its axes, all around the diagonal from its lowest corner."""
    numbers = numpy.arange(math.prod(map(len, axes))).reshape([len(axis) for axis in axes])
    vertices = numpy.stack(numpy.meshgrid(*axes, indexing="ij"), axis=-1).reshape(-1, len(axes))

    def corners(offsets):
        return numbers[tuple(slice(o, len(axis) - 1 + o) for o, axis in zip(offsets, axes))].ravel()

    cells = []
    for order in itertools.permutations(range(len(axes))):
        offsets = numpy.zeros(len(axes), dtype=int)
        path = [corners(offsets)]
        for axis in order:
            offsets[axis] += 1
            path.append(corners(offsets))
        cells.append(numpy.stack(path, axis=1))
    return vertices, oriented(vertices, numpy.concatenate(cells))


def oriented(vertices, cells):
    edges = vertices[cells[:, 1:]] - vertices[cells[:, :1]]
    turned = numpy.linalg.det(edges) < 0
    cells[turned, -2:] = cells[turned, :-3:-1]
    return cells


def mirrored(vertices, cells):
    """With the mirror image at y = 0, where the vertices are shared."""
    image = numpy.arange(len(vertices))
    off = numpy.abs(vertices[:, 1]) > CLOSE
    image[off] = len(vertices) + numpy.arange(off.sum())
    other = vertices[off] * numpy.where(numpy.arange(vertices.shape[1]) == 1, -1, 1)
    both = numpy.concatenate((vertices, other))
    return both, oriented(both, numpy.concatenate((cells, image[cells])))


def facets_where(vertices, cells, condition):
    """All facets of cells, each once, of which every vertex meets condition(vertices)."""
    holds = condition(vertices)
    facets = numpy.concatenate([numpy.delete(cells, corner, axis=1)
                                for corner in range(cells.shape[1])])
    return numpy.unique(numpy.sort(facets[holds[facets].all(axis=1)], axis=1), axis=0)


def collapsed(vertices, cells):
    """What has x = 0 and differs in y alone is one vertex, at y = 0: where polar coordinates begin.
    """
    at_origin = numpy.abs(vertices[:, 0]) < CLOSE
    moved = vertices.copy()
    moved[at_origin, 1] = 0
    kept, number = numpy.unique(moved, axis=0, return_inverse=True)
    cells = numpy.sort(number.reshape(-1)[cells], axis=1)
    return kept, cells[(numpy.diff(cells, axis=1) > 0).all(axis=1)]


SIDES = (("left", "right"), ("bottom", "top"), ("back", "front"))


def with_sides(vertices, cells, more, names=SIDES):
    """A mesh with the sides of the grid's box, where each axis begins and ends, those called None
    left out, and more boundaries and faults, {name: condition(vertices)}."""
    conditions = {}
    for axis, pair in enumerate(names[:vertices.shape[1]]):
        ends = vertices[:, axis].min(), vertices[:, axis].max()
        for name, end in zip(pair, ends):
            conditions[name] = (lambda x, axis=axis, end=end: numpy.abs(x[:, axis] - end) < CLOSE)
    conditions.pop(None, None)
    conditions.update(more)
    boundaries = {name: facets_where(vertices, cells, condition)
                  for name, condition in conditions.items()}
    upper = vertices[cells][:, :, 1].mean(axis=1) > 0
    return Mesh(vertices, cells, boundaries, upper)


def graded(end, num_equal, ratio, far):
    """From 0 by num_equal equal steps to `end`, then by steps that grow by `ratio` beyond `far`."""
    step, points = end / num_equal, list(numpy.linspace(0, end, num_equal + 1))
    while points[-1] < far:
        step *= ratio
        points.append(points[-1] + step)
    return numpy.array(points)


def on_the_fault(x):
    return numpy.abs(x[:, 1]) < CLOSE


def rotation(*angles):
    """In the plane of one angle; of three, about z, then x, then z."""
    def about_z(angle, dimension):
        matrix = numpy.eye(dimension)
        c, s = math.cos(angle), math.sin(angle)
        matrix[:2, :2] = [[c, -s], [s, c]]
        return matrix

    if len(angles) == 1:
        return about_z(angles[0], 2)
    first, second, third = angles
    about_x = numpy.roll(about_z(second, 3), (1, 1), axis=(0, 1))
    return about_z(third, 3) @ about_x @ about_z(first, 3)
