"""How standing waves decay in rock that flows. At the rate p the wave number q asks for
    rho p^2 + q^2 M(p) = 0,   M = G(p) for shear waves, K + 4/3 G(p) for pressure waves.
A body without stress that starts with the velocity v0 has rho (p V - v0) + q^2 M(p) V / p = 0, so
that its velocity is the sum over these rates of the residues of V(p) exp(p t).
"""

import math
import pathlib
import sys

import asperity_run
import numpy
from numpy.polynomial import Polynomial

DECK = pathlib.Path(__file__).with_name("wave.xml")
SHEAR, BULK, DENSITY = 1e9, 5e9 / 3, 1e3  # Pa, Pa, kg/m^3
LENGTH, START = 1000.0, 1e-3              # m, m/s
TOLERANCE = 5e-3  # of START; cells raise frequencies by 4e-4, steps lower them by 2 to 6e-4
DAMPED = 0.5      # of START in the last period, at most

P = Polynomial([0, 1])
# law: its entries in units of the shear modulus, numerator and denominator of G(p) / G
LAWS = {
    "Maxwell": ({"Viscosity": 0.4}, P, P + 2.5),
    "Burgers": ({"Viscosity": 2, "Transient Viscosity": 0.2, "Transient Shear Modulus": 1},
                P * (1 + 0.2 * P), P * (1 + 0.2 * P) + (1 + 0.2 * P) / 2 + P),
}


def elastic_and_relaxing(wave):
    return (0, SHEAR) if wave == "S" else (BULK, 4 / 3 * SHEAR)


def velocity(law, wave, t):
    """Over START."""
    _, numerator, denominator = LAWS[law]
    elastic, relaxing = elastic_and_relaxing(wave)
    square = (2 * math.pi / LENGTH)**2 / DENSITY
    above = P * denominator
    below = P**2 * denominator + square * (elastic * denominator + relaxing * numerator)
    rates = below.roots()
    residues = above(rates) / below.deriv()(rates)
    return (residues[:, None] * numpy.exp(numpy.outer(rates, t))).sum(axis=0).real


def settings(law, wave):
    entries = {f"Bulk/{name}": value * SHEAR for name, value in LAWS[law][0].items()}
    if wave == "S":
        return {**entries, "Initial State/Velocity Z": f"{START} * cos(2 * _pi * x / {LENGTH})",
                "Output/Receivers/Off Fault/place": "{0, 20}"}
    walls = {f"Boundary Conditions/{side}/{key}": value for side in ("left", "right", "top")
             for key, value in {"Boundary": side, "Type": "Sliding Wall"}.items()}
    return {**entries, **walls, "Bulk/Model": "Plane Strain", "Bulk/Bulk Modulus": BULK,
            "Initial State/Velocity X": f"{START} * sin(2 * _pi * x / {LENGTH})",
            "Output/Receivers/Off Fault/place": f"{{{LENGTH / 4}, 20}}"}


def check(law, wave):
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {"Bulk/Law": law}, settings(law, wave)))
    history = asperity_run.series(folder / "receivers.h5")
    t = history["time"]
    found = history["off_fault/fields/velocity"].reshape(len(t), -1)[:, 0] / START
    expected = velocity(law, wave, t)
    error = numpy.abs(found - expected).max()
    last = numpy.abs(expected[-128:]).max()
    fine = len(found) > 100 and found[0] > 0.99 and error < TOLERANCE and last < DAMPED
    print(f"{law}, {wave} wave: {error:.2%} of the velocity at the start, of which {last:.1%} is "
          f"left in the last period{'' if fine else ' NO'}", flush=True)
    return fine


def main():
    passed = [check(law, wave) for law in LAWS for wave in "SP"]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
