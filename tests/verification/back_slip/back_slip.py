"""Plates driven from outside and back slip: the same on a planar fault, but for a rigid motion."""

import pathlib
import sys

import asperity_run
import comparisons
import numpy

DECK = pathlib.Path(__file__).with_name("strip.xml")
VP = 1e-4
TOLERANCE = 1e-7  # of the largest value; the solvers' tolerances are 1e-11 and 1e-12
FIELDS = ("slip", "slip_rate", "alpha", "traction")


def run(folder, settings, **options):
    return asperity_run.run_to_end(folder, DECK, *asperity_run.settings(settings), **options)


def driven_from_outside(speed, axis, settings):
    return {**settings, "Boundary Conditions/Plate/Velocity": speed,
            f"Initial State/Velocity {axis}": speed}


def by_back_slip(settings):
    return {**settings, "Boundary Conditions/Fault/Plate Rate": VP}


def differences(one, other):
    """Largest differences of the fields on the fault, in units of the largest value."""
    histories = [asperity_run.series(folder / "fault.h5") for folder in (one, other)]
    found = {}
    for name in FIELDS:
        a, b = (history[f"fields/{name}"] for history in histories)
        found[name] = comparisons.largest_difference(a, b)
    varied = numpy.ptp(histories[0]["fields/slip_rate"]) / VP
    return found, varied


def energy_defect(folder):
    """Since the first step, in units of the work of friction: a quasi-dynamic start is not
    balanced, which leaves a defect there. And the last step."""
    steps = asperity_run.table(folder / "steps.csv")
    first = next(row for row in steps if row["step"] == 1)
    last = steps[-1]
    return abs(last["energy_defect"] - first["energy_defect"]) / last["friction_work"], last


def check(name, speed, axis, settings, ranks=1):
    outside = run("outside", driven_from_outside(speed, axis, settings), ranks=ranks)
    back = run("back", by_back_slip(settings), ranks=ranks)
    found, varied = differences(back, outside)
    # What plates do is work of loads under back slip, and work of the boundary from outside.
    defect, last = energy_defect(back)
    _, other = energy_defect(outside)
    dissipated = [(last[key] / other[key] if other[key] else 1)
                  for key in ("friction_work", "viscous_work")]
    fine = (max(found.values()) < TOLERANCE and varied > 0.5 and defect < 1e-9
            and max(abs(x - 1) for x in dissipated) < 1e-6)
    shown = " ".join(f"{key} {value:.1e}" for key, value in found.items())
    print(f"{name:40s} differences: {shown}; slip rates vary by {varied:.1f} Vp; energy defect "
          f"{defect:.1e}; dissipated by friction, damping {dissipated}{'' if fine else ' NO'}",
          flush=True)
    return fine


def locked():
    """A fault whose slip rate is lost beside the plate rate: what it bears is the force that strain
    needs."""
    settings = {**SOLID, "Boundary Conditions/Fault/Type": "Bilateral Contact",
                "Bulk/Dynamics": "Inertial", "Friction/a": 0.004, "Initial State/State": "Given",
                "Initial State/alpha": 30}
    outside = run("locked_outside", driven_from_outside(VP, "X", settings))
    back = run("locked_back", by_back_slip(settings))
    one, other = (asperity_run.series(folder / "fault.h5")["fields/traction"]
                  for folder in (back, outside))
    difference = comparisons.largest_difference(one, other)
    from_outside, by_plates = (asperity_run.table(folder / "steps.csv")[-1]
                               for folder in (outside, back))
    works = from_outside["boundary_work"], by_plates["load_work"]
    defect = max(abs(from_outside["energy_defect"] / works[0]),
                 abs(by_plates["energy_defect"] / works[1]))
    fine = difference < TOLERANCE and defect < 1e-9
    print(f"locked: tractions differ by {difference:.1e}; works {works}; energy defect "
          f"{defect:.1e} of them{'' if fine else ' NO'}", flush=True)
    return fine


def restarted():
    """Stopped half way and continued: the bytes of a run that was not."""
    settings = by_back_slip({"Output/Checkpoint Every n Steps": 100})
    whole = run("whole", settings)
    half = run("half", {**settings, "Time Stepping/Final Time": 2})
    asperity_run.go_on(half, DECK, *asperity_run.settings(settings))
    comparisons.assert_same_results(whole, half, ["fault.h5"], ["steps.csv", "global.csv"])
    print("restart: the same", flush=True)


def refused():
    """Back slip that could not be meant."""
    cases = [({"Boundary Conditions/Deep/Plate Rate": 1e-4}, "Deep / Plate Rate has no effect"),
             ({"Boundary Conditions/Fault/Plate Rate": "1e-4 * t"}, "Plate Rate"),
             ({"Boundary Conditions/Fault/Direction": "{1, 0}"},
              "Direction has no effect without a Plate Rate"),
             ({**SOLID, "Boundary Conditions/Fault/Plate Rate": 1e-4,
               "Boundary Conditions/Deep/Direction": "{1, 0, 1}"},
              "its continuation slips in the same direction")]
    return [asperity_run.refuses(DECK, settings, message) for settings, message in cases]


# The same strip with a depth, coarse.
SOLID = {"Bulk/Model": "Solid", "Mesh/Type": "Box", "Mesh/Box/Size": "{1, 0.5, 0.4}",
         "Mesh/Box/Cells X": 8, "Mesh/Box/Cells Y": 4, "Mesh/Box/Cells Z": 3,
         "Boundary Conditions/Wall/Boundary": "front",
         "Boundary Conditions/Wall/Type": "Sliding Wall",
         "Time Stepping/Final Time": 1, "Coupling/Tolerance": 1e-9,
         "TNNMG/Absolute Tolerance": 1e-10, "TNNMG/Relative Tolerance": 1e-10}


def main():
    plane = {"Bulk/Model": "Plane Strain"}
    contact = {"Boundary Conditions/Fault/Type": "Bilateral Contact"}
    passed = [
        check("antiplane, quasi-dynamic", VP / 2, "Z", {}),
        check("antiplane, inertia", VP / 2, "Z", {"Bulk/Dynamics": "Inertial"}),
        check("plane strain, quasi-dynamic, contact", VP, "X", {**plane, **contact}),
        check("plane strain, inertia, contact", VP, "X",
              {**plane, **contact, "Bulk/Dynamics": "Inertial"}),
        check("solid, quasi-dynamic, contact, 2 ranks", VP, "X", {**SOLID, **contact}, ranks=2),
        check("solid, inertia, contact", VP, "X",
              {**SOLID, **contact, "Bulk/Dynamics": "Inertial"}),
        locked(), *refused()]
    restarted()
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
