"""The pressure of SEAS BP8: water flows from a Gaussian source at x = y = 0 into a square that is
closed. With its cosine waves, of the wavenumbers k = 2 pi (m, n) / 800 m,

    p = sum p_k(t) cos(k_x x) cos(k_y y),  S w p_k' = q_k - (k w / eta) |k|^2 p_k

while it flows; then they decay. The source spreads like heat that began as a point, so that before
the sides matter p = Q eta / (4 pi k w) ln(1 + 2 alpha t / variance) at its middle.
"""

import math

import numpy

RATE, PUMPED_FOR = 0.003, 360e3                    # m^3/s, s
CAPACITY, MOBILITY = 1e-9 * 1, 5e-14 * 1 / 1e-3    # S w [m/Pa], k w / eta [m^3/(Pa s)]
DIFFUSIVITY = MOBILITY / CAPACITY                  # m^2/s
SIDE, VARIANCE = 800.0, 50.0**2                    # m, m^2
K = 2 * math.pi / SIDE * numpy.arange(24)          # the Gaussian has no shorter waves
SQUARE = K[:, None]**2 + K**2
SHARE = numpy.where(K > 0, 2, 1) / SIDE * numpy.exp(-VARIANCE * K**2 / 2)


def in_the_middle(time):
    """Without sides, while water flows [Pa]."""
    return RATE / (4 * math.pi * MOBILITY) * math.log(1 + 2 * DIFFUSIVITY * time / VARIANCE)


def pressure(time, x, y):
    """At places in the square [Pa]."""
    def since(duration):
        grown = numpy.full_like(SQUARE, max(0, duration))
        numpy.divide(-numpy.expm1(-DIFFUSIVITY * SQUARE * grown), DIFFUSIVITY * SQUARE, out=grown,
                     where=SQUARE > 0)
        return grown

    modes = RATE / CAPACITY * SHARE[:, None] * SHARE * (since(time) - since(time - PUMPED_FOR))
    in_x, in_y = (numpy.cos(numpy.multiply.outer(place, K)) for place in (x, y))
    return ((in_x @ modes) * in_y).sum(axis=-1)
