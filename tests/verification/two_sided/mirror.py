"""Two bodies that mirror each other: the same as one of them on an antisymmetric fault."""

import sys

import asperity_run
import bodies
import comparisons
import meshes
import numpy

sys.path.insert(0, str(asperity_run.SOURCE / "python"))
from asperity.run import Run  # noqa: E402 pylint: disable=wrong-import-position
from asperity_plot import mirror  # noqa: E402 pylint: disable=wrong-import-position

VP = 1e-4
TOLERANCE = 1e-9  # of the largest value; the solvers' tolerances are 1e-11 and 1e-12
# so small that these meshes have several levels
COARSEST = {"TNNMG/Multigrid/MueLu/coarse: max size": 50}
FIELDS = ("slip", "slip_rate", "alpha", "traction")
COMPONENT = {"Antiplane": "Z", "Plane Strain": "X", "Solid": "X"}


def half(model):
    if model == "Solid":
        axes = numpy.linspace(0, 1, 7), numpy.linspace(0, 0.5, 4), numpy.linspace(0, 0.5, 4)
    else:
        axes = numpy.linspace(0, 1, 21), numpy.linspace(0, 0.5, 9)
    return meshes.grid(*axes)


def settings(model, dynamics):
    """Both plates move by half the plate rate; the sides let the fault slip past them."""
    result = {"Bulk/Model": model, "Bulk/Dynamics": dynamics, "Initial State/Slip Rate": VP}
    if model != "Antiplane":
        across = (0, 1) if model == "Plane Strain" else (0, 1, 0)
        result.update(bodies.conditions(left=bodies.prescribed(0, *across),
                                      right=bodies.prescribed(0, *across)))
    if model == "Solid":
        result.update(bodies.conditions(front={"Type": "Sliding Wall"},
                                        back={"Type": "Free Surface"}))
        result["Output/Surface History/Precision"] = "Double"
        # what solvers in space reach in the rounding of their numbers
        result.update({"Coupling/Tolerance": 1e-10, "Time Stepping/Final Time": 0.5})
    return result


def of_the_half(model, dynamics):
    given = settings(model, dynamics)
    del given["Initial State/Slip Rate"]
    return {**given, **bodies.conditions(fault={"Type": "Antisymmetric Fault"},
                                       top=bodies.prescribed(VP / 2)),
            **initial_velocity(model, VP / 2)}


def of_both(model, dynamics):
    given = settings(model, dynamics)
    return {**given, **bodies.conditions(fault={"Type": "Two-Sided Fault"},
                                       top=bodies.prescribed(VP / 2),
                                       bottom=bodies.prescribed(-VP / 2)),
            **initial_velocity(model, f"y > 0 ? {VP / 2} : (y < 0 ? -{VP / 2} : 0)")}


def initial_velocity(model, value):
    return {f"Initial State/Velocity {COMPONENT[model]}": value}


def by_place(places, values):
    """Values (nodes, 3) off the fault, ordered by their places, and these."""
    off = numpy.abs(places[:, 1]) > meshes.CLOSE
    order = numpy.lexsort(numpy.round(places[off], 9).T)
    return values[off][order], places[off][order]


def image_difference(alone, both):
    """By how much the surface of the half and its image, as figures draw them, differ from that of
    both bodies, as part of the largest displacement."""
    half_run, whole = Run(alone), Run(both).surface
    image = mirror.of(half_run, numpy.array([0.0, 0.0, 1.0]))
    own = half_run.surface
    moved = own["displacement"][-1]
    drawn, places = by_place(numpy.concatenate((own.coordinates, image.places(own.coordinates))),
                             numpy.concatenate((moved, image.displacement(moved))))
    expected, same_places = by_place(whole.coordinates, whole["displacement"][-1])
    assert numpy.allclose(places, same_places)
    assert (numpy.abs(expected).max(axis=0) > 1e-3 * numpy.abs(expected).max()).all()
    return comparisons.largest_difference(drawn, expected)


def check(model, dynamics, solvers, change="Fixed"):
    """`solvers`: (linear correction, number of ranks) of the runs with both bodies; `change`: of
    the normal stress in them, which by symmetry is none."""
    vertices, cells = half(model)
    fault = {"fault": meshes.on_the_fault}
    sides = (meshes.SIDES[0], (None, "top"), meshes.SIDES[2])  # the fault is at the bottom
    alone = bodies.run("half", meshes.with_sides(vertices, cells, fault, sides),
                     of_the_half(model, dynamics))
    expected, places = bodies.fields_by_place(alone, FIELDS)
    varied = numpy.ptp(expected["slip_rate"]) / VP
    passed = []
    for correction, ranks in solvers:
        both = bodies.run("both", meshes.with_sides(*meshes.mirrored(vertices, cells), fault),
                        {**of_both(model, dynamics), "TNNMG/Linear Correction": correction,
                         "Friction/Normal Stress Change": change, **COARSEST}, ranks=ranks)
        found, same_places = bodies.fields_by_place(both, FIELDS)
        differences = {name: comparisons.largest_difference(found[name], expected[name])
                       for name in FIELDS}
        if model == "Solid":
            differences["image of the surface"] = image_difference(alone, both)
        fine = (max(differences.values()) < TOLERANCE and varied > 0.5
                and bodies.energy_increases(both) == 0 and numpy.allclose(places, same_places))
        shown = " ".join(f"{name} {value:.1e}" for name, value in differences.items())
        print(f"{model}, {dynamics}, {change} normal stress, {correction}, "
              f"{ranks} ranks: {shown}; slip rates vary by "
              f"{varied:.1f} Vp{'' if fine else ' NO'}", flush=True)
        passed.append(fine)
    return passed


def main():
    every = (("Direct", 1), ("Multigrid", 1), ("Multigrid", 2))
    passed = [
        *check("Antiplane", "Quasi-dynamic", every),
        *check("Antiplane", "Inertial", every[:1]),
        *check("Plane Strain", "Quasi-dynamic", every[:1]),
        *check("Plane Strain", "Quasi-dynamic", every[:1], "Coupled"),
        *check("Plane Strain", "Inertial", every),
        *check("Solid", "Quasi-dynamic", (every[0], every[2])),
        *check("Solid", "Inertial", every[:1], "Coupled")]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
