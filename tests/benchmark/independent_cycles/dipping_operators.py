"""How slip along dip stresses a fault that dips in a half space, in plane strain, by boundary
elements with constant slip: two edge dislocations each, with Muskhelishvili's potentials and the
image that frees the surface y = 0 of the half plane y < 0 from traction."""

import numpy


def _stresses(z, z0, burgers, shear_modulus, poisson):
    """sxx, syy, sxy [Pa] at z = x + iy of an edge dislocation at z0, burgers = bx + i by [m]."""
    A = shear_modulus * burgers / (1j * numpy.pi * (4 - 4 * poisson))
    B, c0 = numpy.conj(A), numpy.conj(z0)
    d, e = z - z0, z - c0
    # Of the whole plane phi = A ln d and psi = B ln d - A c0 / d; of the image phi1 = -B z / e -
    # A ln e + B z0 / e and psi1 = -B ln e - z phi1'.
    phi1 = -B / e + B * d / e ** 2 - A / e  # the first derivatives
    phi2 = 2 * B / e ** 2 - 2 * B * d / e ** 3 + A / e ** 2  # the second
    psi1 = B / d + A * c0 / d ** 2 - B / e - phi1 - z * phi2
    phi1 = phi1 + A / d
    phi2 = phi2 - A / d ** 2
    mean, deviator = 2 * phi1.real, numpy.conj(z) * phi2 + psi1
    return mean - deviator.real, mean + deviator.real, deviator.imag


class DippingElements:
    """Slip in thrust on elements of `cell` [m] down to `length` [m], dip in degrees."""

    def __init__(self, cell, length, dip, shear_modulus, poisson=0.25):
        count = int(round(length / cell))
        down = numpy.exp(-1j * numpy.radians(dip))
        self.positions = cell * (numpy.arange(count) + 0.5)
        normal = 1j * down  # into the hanging wall
        tn = numpy.outer([down.real, down.imag], [normal.real, normal.imag])
        nn = numpy.outer([normal.real, normal.imag], [normal.real, normal.imag])
        shear, tension = numpy.empty((2, count, count + 1))
        for end in range(count + 1):
            sxx, syy, sxy = _stresses(self.positions * down, end * cell * down, down,
                                      shear_modulus, poisson)
            shear[:, end] = tn[0, 0] * sxx + (tn[0, 1] + tn[1, 0]) * sxy + tn[1, 1] * syy
            tension[:, end] = nn[0, 0] * sxx + 2 * nn[0, 1] * sxy + nn[1, 1] * syy
        # Of an element: what moves down dip on one side moves up on the other. The traction along
        # the slip is the same for both senses, the compression changes its sign.
        self._count = count
        self._matrix = numpy.concatenate([numpy.diff(shear, axis=1), numpy.diff(tension, axis=1)])
        assert self._matrix[0, 0] < 0  # slip releases the traction that drives it

    def stress_of(self, slip):
        both = self._matrix @ slip
        return both[:self._count], both[self._count:]
