"""What growth_rate.py compares with, where the answer is known otherwise."""

import math
import sys

import numpy
from linear_body import Antiplane, PlaneStrain
from steady_sliding import Fault, rates

G, NU, THICK = 3e10, 0.25, 3  # of waves 1 m long
Q = 2 * math.pi
FAULT = Fault(a=0.010, b=0.015, L=1e-5, sigma=1e4, V=1e-4)


def bodies():
    """(what, K, its known value, a scale)"""
    def layer(s, height, density):  # of shear waves that run across it
        c = math.sqrt(G / density)
        return G * s / c / numpy.tanh(s * height / c)

    s = numpy.array([700 + 900j])
    long = {"q": 1e-4, "height": 2.0, "shear_modulus": G, "density": 2700.0}
    half = {"q": Q, "height": THICK, "shear_modulus": G}
    # Rayleigh's waves are free of traction; their speed is c sqrt(2 - 2/sqrt(3)) for nu = 1/4.
    rayleigh = 1j * Q * math.sqrt(G / 2700 * (2 - 2 / math.sqrt(3)))
    yield "half space, antiplane", Antiplane(**half).stiffness(0), G * Q, G * Q
    yield ("half space, free across", PlaneStrain(**half).stiffness(0), G * Q / (1 - NU), G * Q)
    yield ("half space, held across", PlaneStrain(**half, free_normal=False).stiffness(0),
           4 * G * (1 - NU) * Q / (3 - 4 * NU), G * Q)
    yield ("Rayleigh wave", PlaneStrain(**half, density=2700.0).stiffness(rayleigh), 0, G * Q)
    K = layer(s, 2.0, 2700.0)
    yield "long waves, antiplane", Antiplane(**long).stiffness(s), K, abs(K)
    yield "long waves, free across", PlaneStrain(**long).stiffness(s), K, abs(K)
    yield "long waves, held across", PlaneStrain(**long, free_normal=False).stiffness(s), K, abs(K)


def springs():
    """The same for the leading rate with a spring, a mass and a dashpot."""
    r, per_area = FAULT.V / FAULT.L, FAULT.a * FAULT.sigma
    for over_critical, mass, damping in ((0.5, 0, 0), (2, 0, 0), (1, 3e4, 0), (1.5, 0, 2e5)):
        k = over_critical * FAULT.critical_stiffness()
        # m V s^3 + (a sigma + eta V + m V r) s^2 + ((a - b) sigma r + k V + eta V r) s + k V r
        known = numpy.roots([mass * FAULT.V,
                             per_area + damping * FAULT.V + mass * FAULT.V * r,
                             (FAULT.a - FAULT.b) * FAULT.sigma * r + k * FAULT.V
                             + damping * FAULT.V * r,
                             k * FAULT.V * r])
        leading = max(known, key=lambda s: (s.real, s.imag))
        found = rates(FAULT, lambda s: k + mass * s**2 + damping * s)[0]
        what = f"spring {over_critical:g} k_c, {mass:g} kg/m^2, {damping:g} Pa s/m"
        yield what, found, leading, r
    k = FAULT.critical_stiffness()
    yield ("frequency at the critical stiffness", rates(FAULT, lambda s: k + 0 * s)[0],
           1j * r * math.sqrt((FAULT.b - FAULT.a) / FAULT.a), r)


def main():
    failed = 0
    for what, found, known, scale in (*bodies(), *springs()):
        error = numpy.max(numpy.abs(found - known) / scale)
        failed += not error < 1e-5
        print(f"{what:45s}{error:.1e}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
