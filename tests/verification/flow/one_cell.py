"""The stress in cell.xml is that of springs and dashpots, to rounding, however long the steps.

Per unit of shear modulus and strain, with the fluidities f = G / eta:
    Maxwell  s' = e' - f s
    Burgers  s' = e' - f s - k',  k' = (s - g k) f2    (strain k of the Kelvin element, g = G2 / G)
"""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("cell.xml")
SHEAR, POISSON = 1e6, 0.25
RATE, STOP = 1e-3, 8.0  # 1/s until then, s
TOLERANCE = 1e-10  # of the largest stress

# law: its entries, and the matrix of d/dt of the stress and what it hangs on
LAWS = {
    "Maxwell": ({"Viscosity": 5e6}, [[-0.2]]),
    "Maxwell, short": ({"Viscosity": 2e4}, [[-50.0]]),
    "Burgers": ({"Viscosity": 2e7, "Transient Viscosity": 1e6, "Transient Shear Modulus": 5e5},
                [[-0.05 - 1, 0.5], [1, -0.5]]),
}


def relaxed(matrix, t):
    """(num_times) per unit of 2 G or G: of a unit strain rate until STOP."""
    rates, vectors = numpy.linalg.eig(numpy.array(matrix))
    weights = vectors[0] * numpy.linalg.solve(vectors, numpy.eye(len(rates))[0])
    during = numpy.minimum(t, STOP)[:, None]
    after = numpy.maximum(t - STOP, 0)[:, None]
    return (weights / rates * numpy.expm1(rates * during) * numpy.exp(rates * after)).sum(axis=1)


def stress(name, settings):
    law, (entries, _) = name.split(",")[0], LAWS[name]
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {f"Bulk/{key}": value for key, value in {"Law": law, **entries}.items()}, settings))
    history = asperity_run.series(folder / "receivers.h5")
    return history["time"], history["off_fault/fields/stress"][:, 0]


def verdict(name, what, found, expected):
    error = numpy.abs(found - expected).max() / numpy.abs(expected).max()
    fine = len(found) > 10 and error < TOLERANCE
    print(f"{name}, {what}: {error:.1e}{'' if fine else ' NO'}")
    return fine


def check(name):
    matrix = LAWS[name][1]
    t, sigma = stress(name, {})
    sheared = verdict(name, "shear", sigma[:, 1], SHEAR * RATE * relaxed(matrix, t))

    # Uniaxial: the volume is elastic, and the deviator of the strain is (-1, 2, -1) / 3.
    t, sigma = stress(name, {
        "Bulk/Model": "Plane Strain", "Bulk/Poisson's Ratio": POISSON,
        "Boundary Conditions/Top/Direction": "{0, 1}",
        **{f"Boundary Conditions/{side}/{key}": value for side in ("left", "right")
           for key, value in {"Boundary": side, "Type": "Sliding Wall"}.items()}})
    bulk = 2 * SHEAR * (1 + POISSON) / (3 * (1 - 2 * POISSON))
    pressure = bulk * RATE * numpy.minimum(t, STOP)
    deviator = 2 * SHEAR * RATE * relaxed(matrix, t)
    expected = numpy.stack([pressure - deviator / 3, 0 * t, pressure + deviator * 2 / 3,
                            pressure - deviator / 3], axis=1)
    return sheared, verdict(name, "uniaxial", sigma, expected)


def main():
    passed = [fine for name in LAWS for fine in check(name)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
