"""Slip between two half planes at rest, e^(ikx): what it does to the traction between them.

A half plane y > 0 moves by u = C t under the traction t = (t_x, t_y) e^(ikx) on its surface,

    C = 1 / (G |k|) [[1 - nu, i s (1 - 2 nu) / 2], [-i s (1 - 2 nu) / 2, 1 - nu]],  s = sign(k);

one at y < 0 by that of -k. Let T be the traction that the upper one exerts on the lower one. A
slip d of the upper past the lower one, without opening, leaves -(C+ + C-) T = (d, 0), C+ at k and
C- at -k. With

    A = (1 - nu+) / G+ + (1 - nu-) / G-,  B = [(1 - 2 nu+) / G+ - (1 - 2 nu-) / G-] / 2,

T_x = -|k| A / (A^2 - B^2) d, and the compression -T_y is i s (B / A) |k| A / (A^2 - B^2) d: where
the upper half plane is the softer one, it falls where slip decreases along x, ahead of slip that
spreads the way in which the upper half plane moves (Weertman 1980). impedance.py checks C.
"""

import dataclasses
import math

import numpy


@dataclasses.dataclass(frozen=True)
class Body:
    shear_modulus: float
    poissons_ratio: float

    def compliance(self, k):
        """C of the half plane y > 0."""
        nu = self.poissons_ratio
        across = 1j * math.copysign(1, k) * (1 - 2 * nu) / 2
        return numpy.array([[1 - nu, across], [-across, 1 - nu]]) / (self.shear_modulus * abs(k))


def per_slip(upper, lower, k):
    """(fall of the shear traction, rise of the compression) per unit slip, in Pa/m."""
    T = numpy.linalg.solve(-(upper.compliance(k) + lower.compliance(-k)), [1, 0])
    return -T[0], -T[1]
