"""How slip along strike stresses a vertical fault in a half space, by boundary elements: squares
of constant slip, whose stress in the whole space is known in closed form, and the image that frees
the surface from traction, a double couple of Mindlin's forces, by Gauss's rule.

Axes: 1 along strike, 2 across the fault, 3 up, as in Okada, Bull. Seismol. Soc. Am. 82 (1992),
1018, whose equations 1 and 2 these are.
"""

import itertools

import numpy
import sympy


def _image_kernel(poisson):
    """Of the shear stress over the shear modulus at (x, 0, x3) that slip of a unit area at
    (0, 0, xi3) has in the half space and not in the whole space: a function of x, x3, xi3."""
    x = sympy.symbols("x1:4", real=True)
    xi = sympy.symbols("xi1:4", real=True)
    alpha = 1 / (2 * (1 - sympy.nsimplify(poisson)))
    delta = sympy.eye(3)

    def distances(x3):
        R = [x[0] - xi[0], x[1] - xi[1], -x3 - xi[2]]
        return R, sympy.sqrt(sum(r ** 2 for r in R))

    def u(i, j):
        """The parts of Okada's equations 1 and 2 that the whole space does not have."""
        R, r = distances(x[2])
        a = ((2 - alpha) * delta[i, j] / r + alpha * R[i] * R[j] / r ** 3) / 2
        below = 1 if i < 2 else 0
        beside = 1 if j < 2 else 0
        b = (delta[i, j] / r + R[i] * R[j] / r ** 3
             + (1 - alpha) / alpha
             * (delta[i, j] / (r + R[2])
                + (R[i] * delta[j, 2] - R[j] * delta[i, 2] * beside) / (r * (r + R[2]))
                - R[i] * R[j] * below * beside / (r * (r + R[2]) ** 2)))
        c = ((1 - 2 * delta[i, 2])
             * ((2 - alpha) * (R[i] * delta[j, 2] - R[j] * delta[i, 2]) / r ** 3
                + alpha * xi[2] * (delta[i, j] / r ** 3 - 3 * R[i] * R[j] / r ** 5)))
        return (-a + b + x[2] * c) / (4 * sympy.pi)  # times the shear modulus

    def displacement(i):
        return sympy.diff(u(i, 0), xi[1]) + sympy.diff(u(i, 1), xi[0])

    stress = sympy.diff(displacement(0), x[1]) + sympy.diff(displacement(1), x[0])
    stress = stress.subs({x[1]: 0, xi[0]: 0, xi[1]: 0})
    return sympy.lambdify((x[0], x[2], xi[2]), stress)


class StrikeSlipElements:
    """Slip on squares of `cell` [m], `columns` along strike and `rows` from the surface down."""

    def __init__(self, cell, columns, rows, shear_modulus, poisson=0.25, points=6):
        self.along = cell * (numpy.arange(columns) + 0.5)
        self.depths = cell * (numpy.arange(rows) + 0.5)
        self.shape = (rows, columns)
        along, down = numpy.meshgrid(self.along, self.depths)
        self.positions = numpy.stack([along.ravel(), down.ravel()], 1)
        lag = cell * numpy.arange(columns)
        kernel = numpy.zeros((rows, rows, columns))  # receiver, source, distance along strike
        for side, end in itertools.product((-1, 1), repeat=2):
            X = lag + side * cell / 2
            Z = (self.depths[:, None] - self.depths)[:, :, None] + end * cell / 2
            r = numpy.hypot(X, Z)
            kernel -= side * end / (4 * numpy.pi) * (Z / (X * r) / (1 - poisson) + X / (Z * r))
        image = _image_kernel(poisson)
        nodes, weights = numpy.polynomial.legendre.leggauss(points)
        for (s, ws), (t, wt) in itertools.product(zip(nodes, weights), repeat=2):
            kernel += (cell ** 2 / 4 * ws * wt
                       * image(lag + s * cell / 2, -self.depths[:, None, None],
                               -self.depths[None, :, None] + t * cell / 2))
        assert kernel[0, 0, 0] < 0
        self.kernel = shear_modulus * kernel
        padded = numpy.zeros((rows, rows, 2 * columns))
        padded[:, :, :columns] = self.kernel
        padded[:, :, columns + 1:] = self.kernel[:, :, :0:-1]
        self._spectrum = numpy.ascontiguousarray(
            numpy.fft.rfft(padded).transpose(2, 0, 1))  # wave number, receiver, source

    def stress_of(self, slip):
        rows, columns = self.shape
        waves = numpy.fft.rfft(slip.reshape(self.shape), 2 * columns).T[:, :, None]
        stress = numpy.fft.irfft((self._spectrum @ waves)[:, :, 0].T, 2 * columns)
        return stress[:, :columns].ravel(), 0.
