"""TPV103 in antiplane shear on cells of 50 m, where slip is across the mesh: when the rupture
arrives and how much has slipped after 6 s, against the same rupture by boundary integrals."""

import math
import sys

import asperity_run
import boundary_integral
import numpy

ROCK = (32038120320., 3464.)  # G [Pa], c_s [m/s]
SIGMA, TRACTION, B, L, MU, V0 = 120e6, 40e6, 0.014, 0.4, 0.6, 1e-6
WEAKENED, SLOW = 0.2, 1e-16   # friction coefficient, slip rate at the start [m/s]
ANTIPLANE = ("--remove", "Boundary Conditions/Symmetry", "--remove", "Initial State/Velocity X",
             *asperity_run.settings("Bulk/Model=Antiplane", "Initial State/Velocity Z=0.5e-16"))
PLACES = (0, 2500, 5000, 7500, 9000, 12000)  # m
# As in plane strain.
OF_ARRIVALS, OF_SLIP = 0.015, 0.02


def inside(x):
    """1 to 15 km, 0 from 18 km on."""
    x = numpy.clip(numpy.abs(x), 15e3 + 1, 18e3 - 1)
    return 0.5 * (1 + numpy.tanh(3e3 / (x - 18e3) + 3e3 / (x - 15e3)))


def nucleation(t):
    return 0 if t < 1e-6 else 1 if t >= 1 else math.exp((t - 1)**2 / (t * (t - 2)))


def reference(final_time, num_nodes=2048):
    def stress(x, t):
        near = numpy.minimum(x**2, 8.9999e6)
        return TRACTION + 45e6 * nucleation(t) * numpy.where(
            x**2 < 8.9999e6, numpy.exp(near / (near - 9e6)), 0)

    rupture = boundary_integral.Rupture(102.4e3, num_nodes, ROCK, stress)
    weak = inside(rupture.x)
    a, weakening_rate = 0.01 + 0.01 * (1 - weak), 0.1 + 0.9 * (1 - weak)

    def steady(rate):
        slow = MU - (B - a) * numpy.log(rate / V0)
        friction = WEAKENED + (slow - WEAKENED) / (1 + (rate / weakening_rate)**8)**0.125
        y = friction / a  # psi = a log[2 V0 / V sinh y]
        return a * (numpy.log(V0 / rate) + y + numpy.log1p(-numpy.exp(-2 * y)))

    y = TRACTION / (a * SIGMA)
    psi = a * (math.log(V0 / SLOW) + y + numpy.log1p(-numpy.exp(-2 * y)))
    rupture.friction = boundary_integral.RateAndState(a, SIGMA, V0, L, steady, psi)
    return rupture.run(final_time)


def main():
    expected = reference(6)
    folder = asperity_run.run_to_end(
        "out", asperity_run.SOURCE / "xml" / "tpv103_2d.xml", *ANTIPLANE,
        "--set", "Mesh/Rectangle/Cell Size Factor=0.5", timeout=3500)
    return 0 if boundary_integral.meets(expected, folder, PLACES, OF_ARRIVALS, OF_SLIP) else 1


if __name__ == "__main__":
    sys.exit(main())
