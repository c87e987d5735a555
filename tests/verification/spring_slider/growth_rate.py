"""How a small disturbance of steady sliding grows in slider.xml: the characteristic equation.

Every linear body on a fault obeys
    a sigma - b sigma (V/L) / (s + V/L) + K(s) V / s = 0,
here with K(s) = k + m s^2, k = G / H, and m = rho H / 3, the mass of a linear element at one end.
Both state laws and both friction laws have this linearisation.
"""

import pathlib
import sys

import asperity_run
import numpy

HERE = pathlib.Path(__file__).parent
A, B, L, SIGMA, V = 0.010, 0.015, 1e-5, 1e4, 1e-4
V_STAR, HEIGHT, DENSITY = 1e-6, 1.0, 1000.0
CRITICAL = (B - A) * SIGMA / L * HEIGHT  # shear modulus, without the mass
TOLERANCE = 3e-3  # of |s|; most cases meet 1e-4

# name: (shear modulus over CRITICAL, density, state law, further options)
TRUNCATED = ("--set", "Friction/Law=Truncated")
PLANE_STRAIN = ("--overlay", HERE / "plane_strain.xml")
CASES = {
    "soft": (0.5, DENSITY, "Ageing", ()),
    "stiff": (2, DENSITY, "Ageing", ()),
    "critical": (1, DENSITY, "Ageing", ()),
    "soft, slip law": (0.5, DENSITY, "Slip", ()),
    "stiff, slip law": (2, DENSITY, "Slip", ()),
    "critical, slip law": (1, DENSITY, "Slip", ()),
    "stiff, truncated law": (2, DENSITY, "Ageing", TRUNCATED),
    "soft, plane strain": (0.5, DENSITY, "Ageing", PLANE_STRAIN),
    "stiff, plane strain": (2, DENSITY, "Slip", PLANE_STRAIN),
    # Mass makes unstable what is neutral without it: the critical stiffness becomes 1.67 times it.
    "heavy": (1, 200 * DENSITY, "Ageing", ()),
}


def characteristic_rate(shear_modulus, density):
    """The root s in 1/s with the largest real part and a positive frequency."""
    k, m, r = shear_modulus / HEIGHT, density * HEIGHT / 3, V / L
    roots = numpy.roots([m * V, A * SIGMA + m * V * r, (A - B) * SIGMA * r + k * V, k * V * r])
    return max(roots, key=lambda s: (s.real, s.imag))


def fitted_rate(t, y):
    """s of y = Re(c exp(s t)): y obeys a recursion of two terms, fitted by least squares."""
    stride = max(1, int(0.05 / (t[1] - t[0])))
    rows = numpy.column_stack((y[stride:-stride], y[:-2 * stride]))
    (p, q), *_ = numpy.linalg.lstsq(rows, y[2 * stride:], rcond=None)
    factor = max(numpy.roots([1, -p, -q]), key=lambda z: z.imag)
    return numpy.log(factor) / (stride * (t[1] - t[0]))


def run(name, relative_modulus, density, law, options):
    folder = asperity_run.run_to_end(
        name.replace(", ", "_").replace(" ", "_"), HERE / "slider.xml", *options,
        *asperity_run.settings(f"Friction/State Evolution={law}", f"Bulk/Density={density}",
                               f"Bulk/Shear Modulus={relative_modulus * CRITICAL}"))
    history = asperity_run.series(folder / "fault.h5")
    t, alpha = history["time"], history["fields/alpha"].mean(axis=1)
    settled = t > 0.5  # what is quicker has died away
    return fitted_rate(t[settled], alpha[settled] - numpy.log(V_STAR / V))


def main():
    failed = 0
    for name, (relative_modulus, density, law, options) in CASES.items():
        expected = characteristic_rate(relative_modulus * CRITICAL, density)
        found = run(name, relative_modulus, density, law, options)
        error = abs(found - expected) / abs(expected)
        failed += not error <= TOLERANCE
        print(f"{name:22s} s = {found:.5f} 1/s, expected {expected:.5f}: {error:.3%}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
