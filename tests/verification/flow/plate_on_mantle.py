"""How the surface moves after an earthquake, and through cycles of earthquakes, where an elastic
plate of thickness H lies on a Maxwell half space of the same shear modulus.

Nur and Mavko (1974), Savage and Prescott (1978): images of the slip from the surface to the depth
D, F_0 = atan(D / x) / pi, F_n = (atan((D + 2nH) / x) + atan((D - 2nH) / x)) / pi. By the time t
A_n(t) = 1 - exp(-t/t0) sum of (t/t0)^k / k! for k < n of the n-th has come, t0 = 2 eta / G.
One slip b moves x > 0 by b (F_0 + sum of A_n F_n). In cycles of length T at the plate rate Vp, the
plate slipping at Vp between D and H, the velocity at the time t after an earthquake is
    Vp (1/2 - F_0 + sum of F_n (T sum of A_n'(t + m T) - 1)),   m = 0, 1, ...
"""

import math
import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("savage_prescott.xml")
D, H, CELL = 15e3, 20e3, 1000.0          # m
T = 200 * 31557600.0                     # s
PLATE_RATE, SLIP = 0.030 / 31557600, 1.0  # m/s, m
STEPS = 256                              # of a cycle
IMAGES, PAST = 400, 400
TOLERANCE = 0.02  # of half the slip, of half the plate rate
CHANGE = 1e-6     # of the elastic response to slip that stays, over the slip
BETWEEN = 0.25 * H, 5 * H


def image(n, x):
    return (numpy.arctan((D + 2 * n * H) / x) + numpy.arctan((D - 2 * n * H) / x)) / math.pi


def erlang(n, s):
    """t0 times A_n' at t = s t0."""
    return numpy.exp((n - 1) * numpy.log(s) - s - math.lgamma(n))


def arrived(n, s):
    """A_n at t = s t0."""
    k = numpy.arange(n)
    return 1 - numpy.exp(k * math.log(s) - s - [math.lgamma(i + 1) for i in k]).sum()


def after_one(x, s):
    w = numpy.arctan(D / x) / math.pi
    return w + sum(arrived(n, s) * image(n, x) for n in range(1, IMAGES))


def in_cycles(x, s, ratio):
    """Over Vp; the cycle is `ratio` times t0."""
    v = 0.5 - numpy.arctan(D / x) / math.pi
    past = s + ratio * numpy.arange(PAST)
    for n in range(1, IMAGES):
        # Images that are far come at the mean rate.
        ripple = ratio * erlang(n, past).sum() - 1 if n < ratio * PAST / 4 else 0
        v = v + image(n, x) * ripple
    return v


def surface(name, settings):
    """Times, places along the surface and the fields there, of a run with coarse cells."""
    folder = asperity_run.run_to_end(name, DECK, *asperity_run.settings(
        {"Names/cell": CELL, "Output/Surface History/Every n Steps": 1,
         "Output/Surface History/Fields": "{displacement, velocity, viscous_displacement}",
         **settings}), timeout=300)
    history = asperity_run.series(folder / "surface.h5")
    x = history["geometry/coordinates"][:, 0]
    near = (x > BETWEEN[0]) & (x < BETWEEN[1])
    of_nodes = {field: history[f"fields/{field}"].reshape(len(history["time"]), -1)[:, near]
                for field in ("displacement", "velocity", "viscous_displacement")}
    return history["time"], x[near], of_nodes


def verdict(what, errors):
    fine = bool(errors) and max(errors) < TOLERANCE
    print(f"{what}: {' '.join(f'{error:.2%}' for error in errors)}{'' if fine else ' NO'}",
          flush=True)
    return fine


def one_earthquake(ratio=5):
    """At 0.5, 1, 2 and 4 t0."""
    once = f"t < 1.5 * step ? {SLIP} / step : 0"
    t, x, of_nodes = surface("one", {
        "Boundary Conditions/Fault/Slip Rate": f"above * ({once})",
        "Boundary Conditions/Plate/Velocity": 0,
        "Time Stepping/Prescribed/Levels": "{10}", "Time Stepping/Final Time": "cycle"})
    errors = []
    for s in (0.5, 1, 2, 4):
        since = (s / ratio + 0.5 / STEPS) * T  # it is spread over the first step
        w = numpy.array([numpy.interp(since, t, of_node)
                         for of_node in of_nodes["displacement"].T])
        errors.append(numpy.abs(w - SLIP * after_one(x, s)).max() / (SLIP / 2))
    # What the mantle does not move is the elastic response to the slip and stays.
    elastic = of_nodes["displacement"] - of_nodes["viscous_displacement"]
    changes = numpy.abs(elastic[2:] - elastic[1]).max() / SLIP
    moved = numpy.abs(of_nodes["viscous_displacement"]).max() / SLIP
    fine = changes < CHANGE < moved
    print(f"  elastic response: changes by {changes:.1e}; the mantle moves {moved:.1%}"
          f"{'' if fine else ' NO'}")
    return verdict("one earthquake", errors) and fine


def cycles(ratio):
    """In the last cycle; velocities of steps are means over them, as is the earthquake's time."""
    t, x, of_nodes = surface(f"ratio_{ratio}", {
        "Bulk/Regions/mantle/Viscosity": f"3e10 * cycle / {2 * ratio}"})
    errors = []
    for share in (1 / 16, 1 / 4, 1 / 2, 15 / 16):
        row = numpy.argmin(numpy.abs(t - (t[-1] - T + share * T)))
        expected = PLATE_RATE * in_cycles(x, share * ratio, ratio)
        errors.append(numpy.abs(of_nodes["velocity"][row] - expected).max() / (PLATE_RATE / 2))
    return verdict(f"cycles of {ratio} t0", errors)


def main():
    passed = [one_earthquake(), cycles(1), cycles(5)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
