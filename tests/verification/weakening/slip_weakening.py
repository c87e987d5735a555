"""A quasi-dynamic spring-slider under slip weakening: rest, weakening, steady sliding.

With the stiffness k, the slip s, the loads k V_p t and tau_0, and radiation damping eta,
    eta s' + k s = tau_0 + k V_p t - [mu_s - (mu_s - mu_d) min(s / d_c, 1)] sigma_n
once the right side is positive at s = 0; before that the fault rests. All pieces are linear.
"""

import math
import sys

import asperity_run
import numpy

DECK = asperity_run.SOURCE / "tests" / "verification" / "spring_slider" / "slider.xml"
STIFFNESS, DENSITY, RATE, INITIAL = 1e6, 1000, 1e-3, 600  # Pa/m, kg/m^3, m/s, Pa
STATIC, DYNAMIC, DISTANCE, SIGMA = 0.7, 0.3, 1e-3, 1e3
DAMPING = math.sqrt(STIFFNESS * DENSITY)  # of a layer of 1 m on a rigid foundation [Pa s/m]
STEP, FINAL_TIME = 2e-3, 2.0
LIMIT = 2e-3  # of d_c, at this step
CHANGES = {
    "Bulk/Dynamics": "Quasi-dynamic", "Bulk/Density": DENSITY, "Bulk/Shear Modulus": STIFFNESS,
    "Friction/Law": "Slip Weakening", "Friction/State Evolution": "Slip Weakening",
    "Friction/Static Friction Coefficient": STATIC, "Friction/Normal Stress": SIGMA,
    "Friction/Dynamic Friction Coefficient": DYNAMIC, "Friction/Shear Traction": INITIAL,
    "Friction/Slip-Weakening Distance": DISTANCE, "Initial State/Velocity Z": 0,
    "Initial State/alpha": 0, "Boundary Conditions/Drive/Velocity": RATE,
    "Time Stepping/Final Time": FINAL_TIME}
UNUSED = [word for entry in ("a", "b", "L", "Reference Slip Rate",
                             "Reference Friction Coefficient")
          for word in ("--remove", f"Friction/{entry}")]


def relaxation(t, start, force, rate, stiffness):
    """s of eta s' + stiffness s = force + rate t, s(0) = start."""
    late = (force - rate * DAMPING / stiffness) / stiffness
    return late + rate / stiffness * t + (start - late) * numpy.exp(-stiffness / DAMPING * t)


def exact(t):
    """Slip at the times t, and the time at which it is d_c."""
    drop, drive = (STATIC - DYNAMIC) * SIGMA, STIFFNESS * RATE
    onset = (STATIC * SIGMA - INITIAL) / drive

    def weakening(at):
        return relaxation(at - onset, 0, 0, drive, STIFFNESS - drop / DISTANCE)

    low, high = onset, FINAL_TIME
    for _ in range(80):
        middle = (low + high) / 2
        low, high = (low, middle) if weakening(middle) > DISTANCE else (middle, high)
    sliding = relaxation(t - high, DISTANCE, INITIAL + drive * high - DYNAMIC * SIGMA, drive,
                         STIFFNESS)
    return numpy.where(t < onset, 0, numpy.where(t < high, weakening(t), sliding)), high


def solve(name, step, changes=None):
    sizes = {f"Time Stepping/{size} Step": step for size in ("Largest", "Smallest")}
    folder = asperity_run.run_to_end(
        name, DECK, *asperity_run.settings({**CHANGES, **sizes, **(changes or {})}), *UNUSED)
    history = asperity_run.series(folder / "fault.h5")
    return folder, history["time"], history["fields/slip"][:, 0].ravel()


def error(name, step):
    _, t, slip = solve(name, step)
    return numpy.abs(slip - exact(t)[0]).max() / DISTANCE


def verdict(what, fine):
    print(f"{what}{'' if fine else ' NO'}")
    return fine


def slips():
    coarse, fine = error("coarse", STEP), error("fine", STEP / 4)
    return [verdict(f"slip off by {coarse:.1e} d_c with steps of {STEP} s", coarse < LIMIT),
            verdict(f"{fine:.1e} d_c with a quarter of them", fine < coarse / 3)]


def rests_and_dissipates():
    """Nothing moves below the static strength; friction does the work of its strength."""
    folder, t, slip = solve("energy", STEP)
    onset = (STATIC * SIGMA - INITIAL) / (STIFFNESS * RATE)
    rows = asperity_run.table(folder / "steps.csv")
    expected = 0.01 * SIGMA * ((STATIC - DYNAMIC) / 2 * DISTANCE + DYNAMIC * slip[-1])
    work = rows[-1]["friction_work"]
    defect = abs(rows[-1]["energy_defect"]) / work
    return [verdict("no slip before the static strength", (slip[t < onset] == 0).all()),
            verdict(f"friction work {work:.6g} J/m of {expected:.6g}",
                    abs(work / expected - 1) < LIMIT),
            verdict(f"energy closes to {defect:.1e} of it", defect < 1e-9)]


def forced():
    """Friction falls within 0.1 s from 0.2 s on, below a constant load that it bears at first."""
    start, duration = 0.2, 0.1
    _, t, slip = solve("forced", STEP, {
        "Boundary Conditions/Drive/Velocity": 0, "Friction/Forced Rupture/Enabled": "true",
        "Friction/Forced Rupture/Time": start, "Friction/Forced Rupture/Duration": duration})
    drop = (STATIC - DYNAMIC) * SIGMA
    onset = start + (STATIC * SIGMA - INITIAL) / drop * duration
    end = start + duration

    def falling(at):
        return relaxation(at - onset, 0, 0, drop / duration, STIFFNESS)

    expected = numpy.where(t < onset, 0, numpy.where(
        t < end, falling(t),
        relaxation(t - end, falling(end), INITIAL - DYNAMIC * SIGMA, 0, STIFFNESS)))
    worst = numpy.abs(slip - expected).max() / expected[-1]
    return verdict(f"forced rupture: slip off by {worst:.1e} of the last", worst < 5e-3)


def refused():
    """A state of another kind, and a rupture that cannot be forced."""
    changes = {**CHANGES, "Friction/State Evolution": "Ageing"}
    del changes["Friction/Slip-Weakening Distance"]
    result = asperity_run.run(DECK, *asperity_run.settings(changes), "--validate",
                              *UNUSED[:4], *UNUSED[-2:])
    return [verdict("a state that does not weaken with slip is refused",
                    result.returncode == 2
                    and "depends on the share of slip weakening" in result.stderr),
            asperity_run.refuses(DECK, {"Friction/Forced Rupture/Enabled": "true"},
                                 "changes the share of slip weakening")]


def main():
    return [*refused(), forced(), *slips(), *rests_and_dissipates()].count(False)


if __name__ == "__main__":
    sys.exit(main())
