"""A body in equilibrium, condensed to its fault: the same as with all its unknowns."""

import sys

import asperity_run
import bodies
import comparisons
import meshes
import mirror
import numpy

VP = mirror.VP
TOLERANCE = 1e-9  # of the largest value; the solvers' tolerances are 1e-11 and 1e-12
# Away from zero, so that differences of large numbers do not count: (column, measured by)
ENERGIES = (("elastic_energy", "elastic_energy"), ("boundary_work", "friction_work"),
            ("load_work", "friction_work"), ("friction_work", "friction_work"),
            ("viscous_work", "viscous_work"))
CONDENSED = "is condensed to its fault"
OUTPUTS = {"Output/Volume Snapshots/Enabled": "true",
           "Output/Volume Snapshots/Every n Steps": 10,
           "Output/Volume Snapshots/Fields": "{displacement, velocity}",
           "Output/Volume Snapshots/Precision": "Double"}


def outside_in(model):
    """The half body on its mirror, which the far side drives."""
    return "half", mirror.of_the_half(model, "Quasi-dynamic"), ("slip", "slip_rate", "traction")


def between_two_bodies(model):
    """Unlike bodies, so that slip changes the normal stress, driven from both sides."""
    settings = {**mirror.of_both(model, "Quasi-dynamic"),
                "Bulk/Shear Modulus": "y > 0 ? 0.5e6 : 0.8e6",
                "Friction/Normal Stress Change": "Coupled",
                "Output/Fault History/Fields":
                    "{slip, slip_rate, alpha, traction, normal_stress}"}
    return "both", settings, ("slip", "slip_rate", "traction", "normal_stress")


def back_slip(model):
    """The plates move along the fault, and all that is far away rests."""
    settings = mirror.of_both(model, "Quasi-dynamic")
    for name in [name for name in settings if "Velocity" in name and "Type" not in name]:
        del settings[name]
    del settings["Initial State/Slip Rate"]
    return "both", {**settings, "Boundary Conditions/fault/Plate Rate": VP}, ("slip", "traction")


def mesh_of(model, sides):
    vertices, cells = mirror.half(model)
    fault = {"fault": meshes.on_the_fault}
    if sides == "both":
        return meshes.with_sides(*meshes.mirrored(vertices, cells), fault)
    places = (meshes.SIDES[0], (None, "top"), meshes.SIDES[2])
    return meshes.with_sides(vertices, cells, fault, places)


def fault_fields(folder, names):
    history = asperity_run.series(folder / "fault.h5")
    return {name: history[f"fields/{name}"] for name in names}


def volume_fields(folder):
    history = asperity_run.series(folder / "volume.h5")
    return {name: history[f"fields/{name}"] for name in ("displacement", "velocity")}


def energies(folder):
    """{column: (values, what they are measured by)} from the first step on: the start of a
    quasi-dynamic body is not balanced."""
    rows = asperity_run.table(folder / "steps.csv")
    columns = {name: numpy.array([row[name] for row in rows]) for name in rows[0]}
    return {name: (columns[name], numpy.abs(columns[by]).max()) for name, by in ENERGIES}


def differences(condensed, whole, names):
    found = {}
    for fields in (lambda folder: fault_fields(folder, names), volume_fields):
        ours, theirs = fields(condensed), fields(whole)
        for name, values in theirs.items():
            found[name] = comparisons.largest_difference(ours[name], values)
    ours = energies(condensed)
    for name, (values, scale) in energies(whole).items():
        found[name] = numpy.abs(ours[name][0] - values).max() / scale
    return found


def is_condensed(folder):
    return CONDENSED in (folder / "run.log").read_text()


def check(model, case):
    sides, settings, names = case(model)
    mesh = mesh_of(model, sides)
    settings = {**settings, **OUTPUTS, "TNNMG/Linear Correction": "Direct"}
    condensed = bodies.run("condensed", mesh, settings)
    whole = bodies.run("whole", mesh, {**settings, "TNNMG/Static Condensation": "Off"})
    found = differences(condensed, whole, names)
    varied = numpy.ptp(fault_fields(whole, ["slip_rate"])["slip_rate"]) / VP
    passed = (max(found.values()) < TOLERANCE and varied > 0.5
              and bodies.energy_increases(condensed) == 0
              and is_condensed(condensed) and not is_condensed(whole))
    shown = " ".join(f"{name} {value:.1e}" for name, value in found.items())
    print(f"{model}, {case.__name__}: {shown}; slip rates vary by {varied:.1f} Vp"
          f"{'' if passed else ' NO'}", flush=True)
    return passed


def stays_whole(what, change):
    """Where the body is not in equilibrium with its fault alone, nothing is condensed."""
    sides, settings, _ = outside_in("Antiplane")
    folder = bodies.run("stays_whole", mesh_of("Antiplane", sides),
                      {**settings, "TNNMG/Linear Correction": "Direct",
                       "Time Stepping/Final Time": 0.1, **change})
    passed = not is_condensed(folder)
    print(f"{what}: {'not condensed' if passed else 'condensed NO'}", flush=True)
    return passed


def main():
    passed = [
        check("Antiplane", outside_in), check("Plane Strain", outside_in),
        check("Plane Strain", between_two_bodies), check("Plane Strain", back_slip),
        check("Solid", between_two_bodies),
        stays_whole("inertia", {"Bulk/Dynamics": "Inertial"}),
        stays_whole("viscosity", {"Bulk/Shear Viscosity": 1e3}),
        stays_whole("a velocity that depends on time",
                    {"Boundary Conditions/top/Velocity": f"{VP / 2} * (1 + 1e-3 * t)"}),
        stays_whole("a ramp", {"Boundary Conditions/top/Ramp Duration": 0.5})]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
