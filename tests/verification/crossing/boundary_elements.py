"""Two straight cracks of half length 1 that cross at right angles in an infinite body, by
displacement discontinuities: N elements of constant slip on each, plane strain.

An edge dislocation has the stress of Hirth and Lothe, Theory of Dislocations, with
K = b G / (2 pi (1 - nu)). Lengths and stresses are scaled so that a crack alone has the slip
sqrt(1 - x^2) / 2, and so the potency pi / 4: G / (1 - nu) = 1, and the stress drop is 1/4."""

import numpy

K = 1 / (2 * numpy.pi)
DROP = 0.25


def shear_of_dislocation(x, y):
    """sigma_xy at (x, y) of an edge dislocation at the origin with its Burgers vector along x."""
    return K * x * (x * x - y * y) / (x * x + y * y) ** 2


def shear_of_slip(x, y, half):
    """sigma_xy of unit slip between (-half, 0) and (half, 0): the upper side moves along +x."""
    return shear_of_dislocation(x - half, y) - shear_of_dislocation(x + half, y)


def slip(n, with_second):
    """Slip of the upper side along +x on the crack along x, at the centres of its elements.

    The other crack, along y, has the slip of its right side along +y. sigma_xy acts on both alike,
    and mirror images have the same slip."""
    size = 2 / n
    x = -1 + size * (numpy.arange(n) + 0.5)
    matrix = shear_of_slip(x[:, None] - x, numpy.zeros((n, n)), size / 2)
    if with_second:
        # The mirror image x <-> y of slip on the other crack: sigma_xy keeps its sign.
        zero = numpy.zeros((n, n))
        matrix = matrix + shear_of_slip(zero - x, x[:, None] + zero, size / 2)
    return x, numpy.linalg.solve(matrix, numpy.full(n, -DROP))


def potency_and_middle(with_second, n=200):
    """The integral of slip, and slip in the middle, extrapolated: errors are of first order."""
    values = []
    for elements in (n, 2 * n):
        _, found = slip(elements, with_second)
        values.append(numpy.array([found.sum() * 2 / elements,
                                   found[elements // 2 - 1:elements // 2 + 1].mean()]))
    return 2 * values[1] - values[0]


if __name__ == "__main__":
    for second in (False, True):
        print(potency_and_middle(second))
