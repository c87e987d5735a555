"""The stress of rock that yields in the block of ../flow/cell.xml, which is strained at a constant
rate and then held: the same in all cells, to rounding, however long the steps.

With the shear stress t = sqrt(s : s / 2), t_el if the rock were elastic, and the yield stress t_y,
    t = t_el until t_y, then t_y + (t_el - t_y) H / (G + H)  with hardening H
    t = t_el - G gamma, p = p_el - K sin(psi) gamma          with dilation, p the mean stress
    t_y = c cos(phi) - mean stress sin(phi), at least 0      of Drucker and Prager
    t1 = t_y + (t - t_y) exp(-tau / T) in a step tau         with relaxation
    c = c0 (1 - (1 - share) min(gamma / gamma_s, 1))         with softening; gamma of the past step
"""

import math
import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).parents[1] / "flow" / "cell.xml"
SHEAR, POISSON = 1e6, 0.25
BULK = 2 * SHEAR * (1 + POISSON) / (3 * (1 - 2 * POISSON))
RATE, STOP = 1e-3, 8.0  # 1/s until then, s
TOLERANCE = 1e-10       # of the largest stress
ORDER = 0.9, 1.1        # of softening in the length of steps
SHARE_OF_YIELDING = 0.01  # of the displacement, at least
# All vertices of two cells are held or driven: in more of them the strain would not stay the same.
TWO_CELLS = {"Mesh/Rectangle/Cells X": 1, "Mesh/Rectangle/Cells Y": 1}
UNIAXIAL = {"Bulk/Model": "Plane Strain", "Bulk/Poisson's Ratio": POISSON,
            "Boundary Conditions/Top/Direction": "{0, 1}",
            **{f"Boundary Conditions/{side}/{key}": value for side in ("left", "right")
               for key, value in {"Boundary": side, "Type": "Sliding Wall"}.items()}}


def stress(law, of_rock, others=None):
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {f"Bulk/{key}": value for key, value in {"Law": law, **of_rock}.items()}, others or {}))
    history = asperity_run.series(folder / "receivers.h5")
    return history["time"], history["off_fault/fields/stress"][:, 0]


def verdict(what, found, expected):
    error = numpy.abs(found - expected).max() / numpy.abs(expected).max()
    fine = len(found) > 10 and error < TOLERANCE
    print(f"{what}: {error:.1e}{'' if fine else ' NO'}")
    return fine


def strain(t):
    return RATE * numpy.minimum(t, STOP)


def hardened(elastic, strength, hardening):
    over = numpy.maximum(elastic - strength, 0)
    return elastic - over * SHEAR / (SHEAR + hardening)


def sheared():
    k, H = 5e3, 2e5
    t, sigma = stress("Von Mises", {"Shear Strength": k, "Hardening": H})
    return verdict("Von Mises, sheared", sigma[:, 1], hardened(SHEAR * strain(t), k, H))


def relaxing():
    k, T = 3e3, 2.0
    t, sigma = stress("Von Mises", {"Shear Strength": k, "Yield Relaxation Time": T})
    expected, before = [0.0], 0.0
    for step, end in zip(numpy.diff(t), t[1:]):
        trial = expected[-1] + SHEAR * (strain(end) - before)
        before = strain(end)
        over = max(trial - k, 0)
        expected.append(trial - over + over * math.exp(-step / T))
    return verdict("Von Mises with relaxation", sigma[:, 1], numpy.array(expected))


def isochoric(shear_stress):
    """shear_stress(t_el, mean stress)"""
    return lambda t: (shear_stress(2 * SHEAR * strain(t) / math.sqrt(3), BULK * strain(t)),
                      BULK * strain(t))


def uniaxial(what, law, of_rock, shear_and_mean):
    t, sigma = stress(law, of_rock, UNIAXIAL)
    shear, mean = shear_and_mean(t)
    size = shear / math.sqrt(3)
    expected = numpy.stack([mean - size, 0 * t, mean + 2 * size, mean - size], axis=1)
    return verdict(what, sigma, expected)


def drucker_prager(cohesion, degrees):
    phi = math.radians(degrees)
    return isochoric(lambda elastic, mean: numpy.clip(
        cohesion * math.cos(phi) - mean * math.sin(phi), 0, elastic))


def dilating(what, cohesion, degrees, of_dilation):
    """The deviatoric stress keeps its direction, so that steps can be as long as they like."""
    phi, psi = math.radians(degrees), math.radians(of_dilation)

    def expected(t):
        shear, mean = 2 * SHEAR * strain(t) / math.sqrt(3), BULK * strain(t)
        gamma = numpy.maximum(
            shear - cohesion * math.cos(phi) + mean * math.sin(phi), 0) / (
                SHEAR + BULK * math.sin(phi) * math.sin(psi))
        open_ = SHEAR * gamma > shear
        return (numpy.where(open_, 0, shear - SHEAR * gamma),
                numpy.where(open_, cohesion / math.tan(phi), mean - BULK * math.sin(psi) * gamma))

    return uniaxial(what, "Drucker-Prager", {"Cohesion": cohesion, "Friction Angle": degrees,
                                             "Dilation Angle": of_dilation}, expected)


def under_pressure():
    """Antiplane: the pressure and a part of the shear stress are there from the start."""
    cohesion, degrees, pressure, initial = 1e3, 20, 2e4, 1.5e3
    t, sigma = stress("Drucker-Prager", {
        "Cohesion": cohesion, "Friction Angle": degrees, "Initial Stress/YZ": initial,
        **{f"Initial Stress/{name}": -pressure for name in ("XX", "YY", "ZZ")}})
    phi = math.radians(degrees)
    bound = cohesion * math.cos(phi) + pressure * math.sin(phi) - initial
    return verdict("Drucker-Prager under pressure", sigma[:, 1],
                   numpy.minimum(SHEAR * strain(t), bound))


def softening(what, law, of_rock, yield_stress):
    """yield_stress(gamma)"""
    t, sigma = stress(law, of_rock, TWO_CELLS)
    expected, gamma = [0.0], 0.0
    for elastic in SHEAR * strain(t[1:]):
        trial = elastic - SHEAR * gamma
        expected.append(min(trial, yield_stress(gamma)))
        gamma += (trial - expected[-1]) / SHEAR
    return verdict(what, sigma[:, 1], numpy.array(expected))


def softened(cohesion, share, shear):
    """The entries, and what is left of the cohesion after the inelastic shear gamma."""
    return ({"Residual Share": share, "Softening Shear": shear},
            lambda gamma: cohesion * (1 - (1 - share) * min(gamma / shear, 1)))


def softened_cohesion():
    cohesion, degrees, pressure = 5e3, 20, 3e3
    phi = math.radians(degrees)
    entries, left = softened(cohesion, 0.8, 1.5e-3)
    return softening(
        "Drucker-Prager, softening", "Drucker-Prager",
        {"Cohesion": cohesion, "Friction Angle": degrees, **entries,
         **{f"Initial Stress/{name}": -pressure for name in ("XX", "YY", "ZZ")}},
        lambda gamma: left(gamma) * math.cos(phi) + pressure * math.sin(phi))


def order_of_softening():
    """On the way the stress is k - S gamma = G (strain - gamma), with the slope S.

    The slope and the number of cells were chosen after a first run: more cells localise.
    """
    k, share, shear = 3e3, 0.2, 8e-3
    slope = k * (1 - share) / shear
    exact = k - slope * (SHEAR * strain(STOP) - k) / (SHEAR - slope)
    errors = []
    for step in (0.25, 0.125, 0.0625):
        _, sigma = stress("Von Mises", {"Shear Strength": k, **softened(k, share, shear)[0]}, {
            **TWO_CELLS, "Time Stepping/Largest Step": step, "Time Stepping/Smallest Step": step,
            "Time Stepping/Prescribed/Levels": "{0}", "Time Stepping/Final Time": STOP})
        errors.append(sigma[-1, 1] - exact)
    orders = numpy.log2(numpy.abs(errors[:-1]) / numpy.abs(errors[1:]))
    fine = ORDER[0] < orders.min() and orders.max() < ORDER[1]
    print(f"Softening, order {orders[0]:.2f}, {orders[1]:.2f}{'' if fine else ' NO'}")
    return fine


def split_of_displacement(ranks):
    """Of a block whose strength differs from place to place: without what the inelastic strain
    moves, the displacement is that of the elastic block, which is sheared evenly."""
    place = 0.3, 0.4
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings({
        "Mesh/Rectangle/Cells X": 8, "Mesh/Rectangle/Cells Y": 8, "Bulk/Law": "Von Mises",
        "Bulk/Shear Strength": "2e3 + 8e3 * x * y", "Coupling/Tolerance": 1e-12,
        "Output/Receivers/Body Fields": "{displacement, inelastic_displacement}"}), ranks=ranks)
    history = asperity_run.series(folder / "receivers.h5")
    u, of_yielding = (history[f"off_fault/fields/{name}"].reshape(len(history["time"]), -1)[:, 0]
                      for name in ("displacement", "inelastic_displacement"))
    found = numpy.abs(of_yielding).max() / numpy.abs(u).max()
    print(f"  on {ranks} ranks the inelastic strain moves {found:.1%}")
    return verdict("displacement without it", u - of_yielding,
                   place[1] * strain(history["time"])) and found > SHARE_OF_YIELDING


def refused():
    """Rock that yields before anything moves, or that has no strength."""
    weak = {"Bulk/Law": "Von Mises", "Bulk/Shear Strength": 5e3}
    beyond = {f"Bulk/Initial Stress/{name}": value for name, value in (("XZ", 3e3), ("YZ", 6e3))}
    return [asperity_run.refuses(DECK, {**weak, **beyond}, message)
            for message in ("bears a shear stress of 6708.2", "yields at 5000 Pa")] + [
                asperity_run.refuses(DECK, {**weak, "Bulk/Shear Strength": 0}, "Shear Strength"),
            asperity_run.refuses(DECK, {
                "Bulk/Law": "Drucker-Prager", "Bulk/Cohesion": 1e3, "Bulk/Friction Angle": 20,
                "Bulk/Dilation Angle": 30}, "Dilation Angle = 30 degrees is larger")]


def main():
    passed = [
        *refused(), sheared(), relaxing(), under_pressure(), softened_cohesion(),
        softening("Von Mises, softening", "Von Mises",
                  {"Shear Strength": 5e3, **softened(5e3, 0.6, 4e-3)[0]},
                  softened(5e3, 0.6, 4e-3)[1]),
        order_of_softening(), split_of_displacement(1), split_of_displacement(2),
        uniaxial("Von Mises, uniaxial", "Von Mises", {"Shear Strength": 4e3, "Hardening": 1e5},
                 isochoric(lambda elastic, mean: hardened(elastic, 4e3, 1e5))),
        uniaxial("Drucker-Prager, uniaxial", "Drucker-Prager",
                 {"Cohesion": 8e3, "Friction Angle": 30}, drucker_prager(8e3, 30)),
        uniaxial("Drucker-Prager, to the apex", "Drucker-Prager",
                 {"Cohesion": 6e3, "Friction Angle": 30}, drucker_prager(6e3, 30)),
        dilating("Drucker-Prager, associated", 8e3, 30, 30),
        dilating("Drucker-Prager, dilating", 8e3, 30, 10),
        dilating("Drucker-Prager, associated, to the apex", 2e3, 30, 30)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
