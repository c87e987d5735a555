"""Meshes of the square [-FAR, FAR]^2 around one crack, or two that cross, of half length 1: the
boundary `far`, the faults `level` and `upright`."""

import mesh_files
import numpy

FAR = 32.


def lines(size):
    """Coordinates with this distance up to 1.25, and growing distances beyond."""
    half = list(numpy.arange(1, round(1.25 / size) + 1) * size)
    while half[-1] < FAR:
        half.append(half[-1] + 1.2 * (half[-1] - half[-2]))
    half = numpy.array(half)
    half[half > 1.25] = 1.25 + (half[half > 1.25] - 1.25) * (FAR - 1.25) / (half[-1] - 1.25)
    return numpy.concatenate([-half[::-1], [0], half])


def write(name, size, cells_in_sector=2, second=True):
    """Squares in two triangles each, cut so that mirror images in both axes are cells, too: at the
    crossing each sector has one cell or two."""
    x = lines(size)
    n = len(x) - 1
    vertices = numpy.stack(numpy.meshgrid(x, x), axis=-1).reshape(-1, 2)
    cells = []
    for j in range(n):
        for i in range(n):
            a = j * (n + 1) + i
            b, d, c = a + 1, a + n + 1, a + n + 2
            rises = ((x[i] + x[i + 1]) * (x[j] + x[j + 1]) > 0) == (cells_in_sector == 2)
            cells += [[a, b, c], [a, c, d]] if rises else [[a, b, d], [b, c, d]]
    middle = n // 2
    inside = [i for i in range(n) if abs(x[i] + x[i + 1]) < 2]
    along = numpy.arange(n)
    sides = {"level": [[middle * (n + 1) + i, middle * (n + 1) + i + 1] for i in inside],
             "far": numpy.concatenate([
                 numpy.stack([start + step * along, start + step * (along + 1)], axis=1)
                 for start, step in ((0, 1), (n * (n + 1), 1), (0, n + 1), (n, n + 1))])}
    if second:
        sides["upright"] = [[i * (n + 1) + middle, (i + 1) * (n + 1) + middle] for i in inside]
    mesh_files.write(name, vertices, numpy.array(cells), sides)
