"""Where a boundary that is driven in one direction meets a fault, the fault slips in the other one
as friction lets it.

Both walls of block.xml move along x at p, and a traction T along z acts on the base. Friction acts
against the whole slip rate S = sqrt(p^2 + w^2), so that with the radiation damping eta
    sigma_n mu(S) w / S + eta w = T,    mu = a asinh(S / (2 V*) exp(mu* / a))
once the strain along x has come to rest, and the whole block moves at (p, 0, w).

Without friction, walls that move apart stretch the block along x alone: sigma_xx = E times its
strain where it is elastic and 3 times the viscosity times the strain rate where it flows, all other
components being zero.
"""

import math
import sys
import pathlib

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("block.xml")
SIGMA, A, RATE, MU, ETA, TRACTION = 1e4, 0.015, 1e-6, 0.6, 1e8, 5e3
SHEAR, POISSON, LENGTH, APART = 1e6, 0.25, 2.0, 1e-9
VISCOSITY = 1e9          # relaxes within 1000 s
SMALL = 1e-8             # of the velocity: the strain along x decays by a factor in each step
ROUNDING = 1e-9          # of the stress: its strain is the same in all cells


def verdict(what, found, expected, limit):
    error = numpy.abs(found / expected - 1).max()
    fine = error < limit
    print(f"{what}: {numpy.min(found):.6g} to {numpy.max(found):.6g}, expected {expected:.6g}"
          f"{'' if fine else ' NO'}", flush=True)
    return fine


def run(changes, ranks=1):
    return asperity_run.run_to_end("out", DECK, *asperity_run.settings(changes), ranks=ranks)


def sideways(drive):
    """w for a drive at p, by bisection."""
    low, high = 0.0, TRACTION / ETA
    for _ in range(200):
        w = (low + high) / 2
        slip_rate = math.hypot(drive, w)
        friction = SIGMA * A * math.asinh(slip_rate / (2 * RATE) * math.exp(MU / A))
        low, high = (w, high) if friction * w / slip_rate + ETA * w < TRACTION else (low, w)
    return low


def slides(drive, ranks=1):
    folder = run({"Bulk/Quasi-dynamic/Radiation Damping": ETA, "Friction/Shear Traction": TRACTION,
                  "Boundary Conditions/Left/Velocity": drive,
                  "Boundary Conditions/Right/Velocity": drive}, ranks)
    velocity = asperity_run.series(folder / "fault.h5")["fields/slip_velocity"][-1]
    return (verdict(f"drive {drive}, along it", velocity[:, 0], drive, SMALL),
            verdict(f"drive {drive}, across it", velocity[:, 2], sideways(drive), SMALL))


def stretches(name, law, expected):
    """Without friction: half of the block beside a wall along x."""
    apart = {"Friction/Normal Stress": 0, "Friction/a": 0.01,
             "Boundary Conditions/Left/Velocity": 0, "Boundary Conditions/Right/Velocity": APART,
             "Boundary Conditions/Front/Boundary": "front",
             "Boundary Conditions/Front/Type": "Sliding Wall", "Initial State/Slip Rate": 0,
             "Bulk/Quasi-dynamic/Radiation Damping": 0}
    series = asperity_run.series(run({**apart, **law}) / "receivers.h5")
    return verdict(f"sigma_xx of {name} rock", series["off_fault/fields/stress"][-1, :, 0],
                   expected(series["time"][-1]), ROUNDING)


def main():
    young = 2 * SHEAR * (1 + POISSON)
    strain_rate = APART / LENGTH
    passed = [*slides(1e-6), *slides(1e-7), *slides(1e-6, ranks=2),
              stretches("elastic", {}, lambda t: young * strain_rate * t),
              stretches("flowing", {"Bulk/Law": "Maxwell", "Bulk/Viscosity": VISCOSITY},
                        lambda t: 3 * VISCOSITY * strain_rate)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
