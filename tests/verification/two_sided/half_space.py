"""The surface of an elastic half space in which a dipping fault slips.

The fault's trace is the axis of the second coordinate, along strike; it dips towards x > 0. Slip is
that of a thrust: the hanging wall, x > 0, moves up dip. x, up and strike are right-handed axes.
"""

import math

import numpy


def edge_dislocation(x, dip, depth):
    """(u_x, u_up) of unit slip from the surface down to `depth`, in plane strain, whatever
    Poisson's ratio is (Segall 2010, Earthquake and Volcano Deformation, section 3.3, after Freund
    and Barnett 1976)."""
    zeta = x / depth - 1 / math.tan(dip)
    # 0 far away on both sides, with a jump by pi at the trace
    angle = numpy.arctan(zeta) + math.pi / 2 - math.pi * (x > 0)
    s, c = math.sin(dip), math.cos(dip)
    return numpy.stack((c * angle + (s - zeta * c) / (1 + zeta**2),
                        -s * angle - (c + zeta * s) / (1 + zeta**2))) / math.pi


def rectangle(x, strike, dip, width, length, poisson, top=0.0):
    """(u_x, u_z, u_up) of unit slip on a rectangle that reaches down dip from `top` to `width`
    and along strike, z, from -length/2 to length/2 (Okada 1985, equations 25 to 30, dip slip)."""
    s, c = math.sin(dip), math.cos(dip)
    ratio = 1 - 2 * poisson  # G / (lambda + G)

    def corner(xi, eta, q):
        R, X = numpy.sqrt(xi**2 + eta**2 + q**2), numpy.sqrt(xi**2 + q**2)
        y, d = eta * c + q * s, eta * s - q * c
        I4 = ratio / c * (numpy.log(R + d) - s * numpy.log(R + eta))
        I5 = ratio * 2 / c * numpy.arctan((eta * (X + q * c) + X * (R + X) * s)
                                          / (xi * (R + X) * c))
        I1 = -ratio * xi / (c * (R + d)) - s / c * I5
        I3 = ratio * (y / (c * (R + d)) - numpy.log(R + eta)) + s / c * I4
        angle = numpy.arctan(xi * eta / (q * R))
        with numpy.errstate(divide="ignore"):  # 1 / (R (R + xi)), without cancellation
            beyond = numpy.where(xi > 0, 1 / (R + xi), (R - xi) / (eta**2 + q**2)) / R
        return numpy.stack((q / R - I3 * s * c,
                            y * q * beyond + c * angle - I1 * s * c,
                            d * q * beyond + s * angle - I5 * s * c))

    return _of_corners(corner, x, strike, dip, width, length, top)


def vertical_strike_slip(x, strike, width, length, poisson, top=0.0):
    """(u_x, u_z, u_up) of unit slip on a vertical rectangle, placed as in `rectangle`; the side
    x > 0 moves along +z (Okada 1985, equations 25 and 29, strike slip)."""
    ratio = 1 - 2 * poisson  # G / (lambda + G)

    def corner(xi, eta, q):  # with dip 90: y = q, d = eta
        R = numpy.sqrt(xi**2 + eta**2 + q**2)
        I1 = -ratio / 2 * xi * q / (R + eta)**2
        I3 = ratio / 2 * (eta / (R + eta) + (q / (R + eta))**2 - numpy.log(R + eta))
        I2 = -ratio * numpy.log(R + eta) - I3
        I4 = -ratio * q / (R + eta)
        return numpy.stack((xi * q / (R * (R + eta)) + numpy.arctan(xi * eta / (q * R)) + I1,
                            q * q / (R * (R + eta)) + I2,
                            eta * q / (R * (R + eta)) + q / (R + eta) + I4))

    return _of_corners(corner, x, strike, math.pi / 2, width, length, top)


def _of_corners(corner, x, strike, dip, width, length, top):
    # Okada's x is along strike, his y horizontal and up dip, both from the lower edge
    s, c = math.sin(dip), math.cos(dip)
    across, depth = width * c - x, width * s
    p, q = across * c + depth * s, across * s - depth * c
    west, east = strike + length / 2, strike - length / 2
    down = width - top
    along, up_dip, up = -(corner(west, p, q) - corner(west, p - down, q)
                          - corner(east, p, q) + corner(east, p - down, q)) / (2 * math.pi)
    return numpy.stack((-up_dip, along, up))
