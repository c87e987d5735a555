"""K(s), the shear traction per unit displacement at the face of a strip, for disturbances e^(st).

The strip is 0 < y < H with the fault at y = 0. Along the fault slip varies as cos(qx), and so does
what it causes; the top moves as it is driven, whatever the disturbance. s may be an array, and
moduli those of a viscoelastic body at each s.
"""

import dataclasses
import math

import numpy


@dataclasses.dataclass(frozen=True)
class Antiplane:
    """u_z = U(y) cos(qx)."""
    q: float
    height: float
    shear_modulus: float
    density: float = 0  # 0: quasi-static

    def stiffness(self, s):
        k = numpy.sqrt(self.q**2 + self.density * s**2 / self.shear_modulus)
        return self.shear_modulus * k / numpy.tanh(k * self.height)


@dataclasses.dataclass(frozen=True)
class PlaneStrain:
    """u_x = U(y) cos(qx), u_y = W(y) sin(qx), sigma_xy = T(y) cos(qx), sigma_yy = N(y) sin(qx).

    At the top U = N = 0, on the fault N = 0 if the normal displacement is free, else W = 0.
    """
    q: float
    height: float
    shear_modulus: float
    density: float = 0  # 0: quasi-static
    poissons_ratio: float = 0.25
    free_normal: bool = True

    def stiffness(self, s):
        through = exponential(self.height * self.system(s))  # of (U, W, T, N), fault to top
        other = 1 if self.free_normal else 3  # W or N on the fault, the one that is not zero

        def minor(first, second):
            """Of U and N at the top, by two of those on the fault."""
            return (through[..., 0, first] * through[..., 3, second]
                    - through[..., 0, second] * through[..., 3, first])

        return minor(0, other) / minor(2, other)  # -T / U

    def system(self, s):
        """The matrix of d/dy (U, W, T, N), from Hooke's law and the balance of momentum."""
        G, nu, q = self.shear_modulus, self.poissons_ratio, self.q
        lame = 2 * G * nu / (1 - 2 * nu)
        P = lame + 2 * G
        inertia = self.density * numpy.asarray(s)**2
        A = numpy.zeros(inertia.shape + (4, 4), dtype=complex)
        A[..., 0, 1], A[..., 0, 2] = -q, 1 / G
        A[..., 1, 0], A[..., 1, 3] = lame * q / P, 1 / P
        A[..., 2, 0], A[..., 2, 3] = inertia + q**2 * (P - lame**2 / P), -lame * q / P
        A[..., 3, 1], A[..., 3, 2] = inertia, q
        return A


def exponential(A):
    """exp(A) by its series, scaled and squared: at rest the system has too few eigenvectors."""
    squarings = 4 + max(0, math.ceil(math.log2(numpy.abs(A).sum(axis=-1).max())))
    term = total = numpy.broadcast_to(numpy.eye(A.shape[-1]), A.shape)
    for i in range(1, 13):
        term = term @ A / (i * 2.0**squarings)
        total = total + term
    return numpy.linalg.matrix_power(total, 2**squarings)
