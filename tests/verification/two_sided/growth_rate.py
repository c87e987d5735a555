"""How a disturbance of steady sliding between two different half planes grows, and where it runs.

A packet of waves is laid on the state of a long fault. While it does not reach the ends, each of
its Fourier coefficients, here that of e^(ikx), k > 0, is a sum of two e^(pt), p the roots of

    a sigma p (p + r) - b sigma r p + K V (p + r) = 0,   r = V / L,

with the complex stiffness K = S + mu C of half_planes.py, S for the shear traction and C for the
compression: e^(ikx + pt) runs to the right where Im p < 0. Where friction follows the compression
with k_pc = V / L_pc + 1 / T_pc (Prakash and Clifton), K = S + mu C k_pc / (p + k_pc), and a third
root is lost soon.
"""

import math
import pathlib
import sys

import asperity_run
import numpy
from half_planes import Body, per_slip

HERE = pathlib.Path(__file__).parent
sys.path.append(str(HERE.parent / "stability"))

import modes  # noqa: E402
import steady_sliding  # noqa: E402

FAULT = steady_sliding.Fault(a=0.010, b=0.015, L=1e-5, sigma=1e4, V=1e-4)
STEADY_ALPHA = math.log(1e-6 / FAULT.V)
FRICTION = FAULT.a * math.asinh(FAULT.V / 2e-6 * math.exp((0.6 + FAULT.b * STEADY_ALPHA) / FAULT.a))
K = 2 * math.pi  # wavenumber
TOLERANCE = 1e-2


def roots(shear, compression, rate):
    """p of what runs to the right and to the left; `rate` is k_pc."""
    r = FAULT.V / FAULT.L

    def polynomial(K):
        return numpy.array([FAULT.a * FAULT.sigma,
                            (FAULT.a - FAULT.b) * FAULT.sigma * r + K * FAULT.V,
                            K * FAULT.V * r])

    if math.isinf(rate):
        found = numpy.roots(polynomial(shear + FRICTION * compression))
    else:
        of_friction = FAULT.V * FRICTION * compression * rate * numpy.array([0, 0, 1, r])
        found = numpy.roots(numpy.convolve(polynomial(shear), [1, rate]) + of_friction)
    return sorted(sorted(found, key=lambda p: -p.real)[:2], key=lambda p: p.imag)


def scaled(upper, lower, over_critical):
    """Bodies with the same contrast whose stiffness is that multiple of the critical one."""
    factor = (over_critical * FAULT.critical_stiffness()
              / per_slip(upper, lower, K)[0].real)
    return [Body(factor * body.shear_modulus, body.poissons_ratio) for body in (upper, lower)]


def settings(upper, lower):
    """Of half_planes.xml."""
    return asperity_run.settings(
        f"Bulk/Shear Modulus=y > 0 ? {upper.shear_modulus} : {lower.shear_modulus}",
        f"Bulk/Poisson's Ratio=y > 0 ? {upper.poissons_ratio} : {lower.poissons_ratio}")


def amplitude(history):
    """Of e^(ikx) in alpha, at all times."""
    x = history["geometry/coordinates"][:, 0]
    return (history["fields/alpha"] - STEADY_ALPHA) @ (
        history["geometry/weights"] * numpy.exp(-1j * K * x))


def check(name, upper, lower, over_critical, rate=math.inf):
    upper, lower = scaled(upper, lower, over_critical)
    expected = roots(*per_slip(upper, lower, K), rate)
    regularised = [] if math.isinf(rate) else asperity_run.settings({
        "Friction/Normal Stress Change": "Prakash-Clifton",  # half by slip, half by time
        "Friction/Prakash-Clifton/Slip Distance": 2 * FAULT.V / rate,
        "Friction/Prakash-Clifton/Time": 2 / rate})
    folder = asperity_run.run_to_end(
        name.replace(" ", "_"), HERE / "bodies.xml", "--overlay", HERE / "half_planes.xml",
        *settings(upper, lower), *regularised, timeout=240)
    history = asperity_run.series(folder / "fault.h5")
    t, y = history["time"], amplitude(history)
    settled = t > t[-1] / 8
    order = 3 if regularised else 2
    found = modes.exponentials(t[settled], y[settled], order, 1)[0]
    found = sorted(sorted(found, key=lambda p: -p.real)[:2], key=lambda p: p.imag)
    rises = sum(row["energy_increases"] for row in asperity_run.table(folder / "steps.csv"))
    fine = rises == 0
    for way, p, known in zip(("right", "left"), found, expected):
        errors = p.real / known.real - 1, p.imag / known.imag - 1
        fine = fine and max(map(abs, errors)) < TOLERANCE
        print(f"{name}, to the {way}: p = {p:.4f} / s, expected {known:.4f}: {errors[0]:+.2%} of "
              f"the growth rate, {errors[1]:+.2%} of the frequency", flush=True)
    # what runs the way in which the softer body moves grows faster
    softer_above = per_slip(upper, lower, K)[1].imag > 0
    fine = fine and (found[0].real > found[1].real) == softer_above
    print(f"{name}: J rose {rises:.0f} times{'' if fine else ' NO'}", flush=True)
    return fine


def main():
    passed = [check("softer above", Body(1, 0.25), Body(4, 0.25), 0.5),
              check("softer below", Body(2, 0.3), Body(1, 0.1), 0.4),
              check("softer above regularised", Body(1, 0.25), Body(4, 0.25), 0.5, rate=5)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
