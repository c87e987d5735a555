"""How a small disturbance of steady sliding grows in slider.xml where slip heats the fluid of the
fault: the characteristic equation, with the response of the pressure to heat.

The normal stress rises as the pressure p0(t) of steady sliding does, so that it stays steady:

    p0 = C tau V [sqrt(w^2 + 2 alpha_hy t) - sqrt(w^2 + 2 alpha_th t)] / (alpha_hy - alpha_th),
    C = Lambda / (rho c sqrt(2 pi)).

A disturbance e^(st) of the slip rate changes the pressure by G(s) times that of the heat tau V,

    G = Lambda / (rho c pi)
        int_0^inf e^(-(k w)^2 / 2) s dk / [(s + alpha_th k^2) (s + alpha_hy k^2)],

and with K(s) of growth_rate.py and tau = f sigma

    a sigma / V - b sigma / (L s + V) + K / s - f G (tau - V K / s) = 0.
"""

import math
import sys

import asperity_run
import numpy
from growth_rate import (A, B, CRITICAL, DENSITY, HEIGHT, HERE, L, SIGMA, V, V_STAR,
                         characteristic_rate, fitted_rate)

TOLERANCE = 0.01  # of |s|
TRACTION = SIGMA * A * math.asinh(V / (2 * V_STAR) * math.exp(
    (0.6 + B * math.log(V_STAR / V)) / A))
PER_HEAT = 1e5 / 2.7e6  # Lambda / (rho c), defaults of the deck
PROCESS = "Friction/Thermal Pressurisation"

# (shear modulus over CRITICAL, w [m], alpha_th, alpha_hy [m^2/s])
CASES = ((1, 1e-5, 1e-10, 1e-9), (1.5, 1e-5, 1e-10, 1e-9), (1, 3e-5, 1e-10, 4e-9))


def response(s, width, thermal, hydraulic):
    """G(s), by the trapezoidal rule in log k."""
    log_k = numpy.linspace(math.log(1e-8 / width), math.log(8 / width), 20001)
    k = numpy.exp(log_k)
    values = k * numpy.exp(-(k * width)**2 / 2) * s / (
        (s + thermal * k**2) * (s + hydraulic * k**2))
    return PER_HEAT / math.pi * (log_k[1] - log_k[0]) * values.sum()


def characteristic(s, relative_modulus, *zone):
    k = (relative_modulus * CRITICAL / HEIGHT + DENSITY * HEIGHT / 3 * s**2) / s
    return (A * SIGMA / V - B * SIGMA / (L * s + V) + k
            - TRACTION / SIGMA * response(s, *zone) * (TRACTION - V * k))


def expected_rate(*case):
    """By Newton's method; the root with the largest real part of those that are found."""
    roots = []
    for s in (0.1 + 3j, 1 + 10j, 3 + 1j, 10 + 0j, -1 + 8j):
        for _ in range(100):
            slope = (characteristic(s + 1e-6, *case) - characteristic(s - 1e-6, *case)) / 2e-6
            change = characteristic(s, *case) / slope
            s -= change
            if abs(change) < 1e-10 * abs(s):
                roots.append(s)
                break
    return max(roots, key=lambda s: (s.real, s.imag))


def run(relative_modulus, width, thermal, hydraulic):
    pressure = (f"{PER_HEAT * TRACTION * V / math.sqrt(2 * math.pi) / (hydraulic - thermal)!r} * "
                f"(sqrt({width**2!r} + {2 * hydraulic!r} * t)"
                f" - sqrt({width**2!r} + {2 * thermal!r} * t))")
    folder = asperity_run.run_to_end("heated", HERE / "slider.xml", *asperity_run.settings(
        {"Bulk/Shear Modulus": relative_modulus * CRITICAL,
         "Friction/Normal Stress": f"{SIGMA!r} + {pressure}",
         f"{PROCESS}/Enabled": "true", f"{PROCESS}/Shear Zone Half Width": width,
         f"{PROCESS}/Thermal Diffusivity": thermal, f"{PROCESS}/Hydraulic Diffusivity": hydraulic,
         f"{PROCESS}/Wavenumbers": 200,
         "Initial State/alpha": "ln(1e-6 / 1e-4) + 1e-7",
         "Initial State/Velocity Z": "1e-4 * exp(-1e-7 * 0.015 / 0.010)"}))
    history = asperity_run.series(folder / "fault.h5")
    t, alpha = history["time"], history["fields/alpha"].mean(axis=1)
    settled = t > 1.5  # what grows more slowly has been left behind
    return fitted_rate(t[settled], alpha[settled] - numpy.log(V_STAR / V))


def main():
    failed = 0
    for case in CASES:
        expected, found = expected_rate(*case), run(*case)
        without = characteristic_rate(case[0] * CRITICAL, DENSITY)
        error = abs(found - expected) / abs(expected)
        failed += not error <= TOLERANCE
        print(f"{case}: s = {found:.5f} 1/s, expected {expected:.5f}, {without:.5f} without heat: "
              f"{error:.3%}")
    return failed


if __name__ == "__main__":
    sys.exit(main())
