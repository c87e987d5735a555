"""Slip that is prescribed on a dipping fault in a half space: how its surface moves.

Slip is 1 from the trace down and falls to 0 linearly along the lower part of the fault, in space
towards its ends along strike, too: edge dislocations, or Okada's rectangles one on the other, all
of the same share. The fault goes on below without slip, which friction holds; or there is no other
fault than that whose slip is known, and no friction.
"""

import math
import sys

import asperity_run
import bodies
import half_space
import meshes
import numpy

WIDTH, LENGTH, TAPER = 1.0, 2.0, 0.5  # of the fault, in units of its width
POISSON = 0.25
TOLERANCE = 2e-2
NEAR = 0.5  # distance from the trace up to which displacements are compared
SHARES = (numpy.arange(64) + 0.5) / 64


def mesh(dip, cells, far, space, friction):
    """Sectors around the trace; `cells` along the width of the fault, and beyond it up to the
    distance `far` cells as long as wide, or in space, where strike is z, longer ones. Up is y."""
    sectors = max(5, round(cells * dip / 2))
    ratio = 1.4 if space else 1 + dip / sectors
    below = round(sectors * (math.pi / dip - 1))
    around = numpy.concatenate((numpy.linspace(dip - math.pi, 0, below, endpoint=False),
                                numpy.linspace(0, dip, sectors + 1)))
    step = WIDTH / cells
    axes = [meshes.graded(WIDTH + 2 * step, cells + 2, ratio, far), around]
    if space:
        axes.append(meshes.graded(LENGTH / 2, round(LENGTH / 2 / step), ratio, far))

    def between(begin, end):
        return lambda x: (meshes.on_the_fault(x) & (x[:, 0] > begin - meshes.CLOSE)
                          & (x[:, 0] < end + meshes.CLOSE)
                          & (not space or x[:, -1] < LENGTH / 2 + meshes.CLOSE))

    def on_top(x):
        ends = numpy.minimum(numpy.abs(x[:, 1] - around[0]), numpy.abs(x[:, 1] - around[-1]))
        return (ends < meshes.CLOSE) | (x[:, 0] < meshes.CLOSE)

    def place(x):
        angle = x[:, 1] - dip
        return numpy.stack((x[:, 0] * numpy.cos(angle), x[:, 0] * numpy.sin(angle), *x.T[2:]), 1)

    boundaries = {"slipping": between(0, WIDTH), "surface": on_top}
    if friction:
        boundaries["fault"] = between(WIDTH, WIDTH + 2 * step)
    names = ((None, "far"), (None, None), ("middle", "end"))
    cells = meshes.collapsed(*meshes.grid(*axes))
    return meshes.with_sides(*cells, boundaries, names).mapped(place)


def settings(dip, space, friction):
    """For a second at 1 m/s; stresses are far below the strength of what is held."""
    rate = f"max(0, min(1, ({WIDTH} - sqrt(x^2 + y^2)) / {TAPER}))"
    if space:
        rate = f"min({rate}, max(0, ({LENGTH / 2} - z) / {TAPER}))"
    slip = {"Type": "Prescribed Slip Rate", "Slip Rate": rate if space else f"-{rate}"}
    given = {"Bulk/Model": "Solid" if space else "Plane Strain", "Bulk/Dynamics": "Quasi-dynamic",
             "Bulk/Shear Modulus": 1, "Bulk/Density": 1, "Bulk/Poisson's Ratio": POISSON,
             "Time Stepping/Largest Step": 0.5, "Time Stepping/Smallest Step": 0.5,
             "Output/Surface History/Precision": "Double",
             "Output/Surface History/Every n Steps": 1}
    if friction:
        given.update({"Friction/Normal Stress": 1e9, "Friction/Shear Traction": 0,
                      "Initial State/alpha": 0, "Initial State/Slip Rate": 0})
    else:
        given["Output/Fault History/Fields"] = "{slip}"
    sides = {"far": {"Type": "Fixed"}}
    if space:
        up_dip = bodies.array((-math.cos(dip), math.sin(dip), 0))
        slip["Direction"] = up_dip
        if friction:
            given["Friction/Slip Direction"] = up_dip
        # displacements to a thousandth will do
        given.update({"TNNMG/Relative Tolerance": 1e-6, "Time Stepping/Largest Step": 1,
                      "Time Stepping/Smallest Step": 1, "Coupling/Tolerance": 1e-6})
        sides.update(middle={"Type": "Sliding Wall"}, end={"Type": "Fixed"})
    if friction:
        sides["fault"] = {"Type": "Two-Sided Fault"}
    return {**given, **bodies.conditions(slipping=slip, surface={"Type": "Free Surface"}, **sides)}


def expected(x, strike, dip, space):
    """(num_points, 3): displacements along x, up and along strike."""
    total = numpy.zeros((3, len(x)))
    for cut in TAPER * SHARES:
        if space:
            u_x, u_strike, u_up = half_space.rectangle(x, strike, dip, WIDTH - cut,
                                                       LENGTH - 2 * cut, POISSON)
            total += numpy.stack((u_x, u_up, u_strike)) / len(SHARES)
        else:
            total[:2] += half_space.edge_dislocation(
                x, dip, (WIDTH - cut) * math.sin(dip)) / len(SHARES)
    return total.T


def check(degrees, cells, far, space=False, friction=True):
    dip = math.radians(degrees)
    removed = () if friction else ("Friction", "Initial State/alpha")
    folder = bodies.run("slip", mesh(dip, cells, far, space, friction),
                        settings(dip, space, friction), removed=removed)
    surface = asperity_run.series(folder / "surface.h5")
    where, moved = surface["geometry/coordinates"], surface["fields/displacement"][-1]
    near = numpy.abs(where[:, 0]) < NEAR
    if space:  # beside the part that slips, and a quarter of its length beyond its end
        near &= where[:, 2] < 0.75 * LENGTH
    where, moved = where[near], moved[near]
    # At the trace there are both sides; of a thrust the hanging wall is the one that moves left.
    x = where[:, 0] + 1e-9 * numpy.where(moved[:, 0] < 0, 1, -1)
    strike = where[:, 2] + 1e-7 if space else 0 * x  # not along the edge of a dislocation
    known = expected(x, strike, dip, space)[:, :moved.shape[1]]
    errors = numpy.linalg.norm(moved - known, axis=1)
    sizes = numpy.linalg.norm(known, axis=1)
    at_trace = (numpy.abs(where[:, 0]) < meshes.CLOSE) & (strike < LENGTH / 2 - TAPER)
    error, local = errors.max() / sizes.max(), (errors / sizes)[at_trace].max()
    fine = max(error, local) < TOLERANCE
    kind = ("3D" if space else "2D") + ("" if friction else ", no friction")
    print(f"{kind}, dip {degrees}, {cells} cells down dip, far sides at {far:g} "
          f"widths: {error:.2%} of the largest displacement at {near.sum()} points, {local:.2%} of "
          f"the local one at the trace{'' if fine else ' NO'}", flush=True)
    return fine


def reference():
    """The formulas: Okada's checklist (table 2, case 2, dip slip), and both for a long fault."""
    dip = math.radians(70)
    lower = 4 / math.sin(dip)
    found = half_space.rectangle(lower * math.cos(dip) - 3, 0.5, dip, lower, 3, 0.25, lower - 2)
    checklist = numpy.abs(found - (3.527e-2, -4.682e-3, -3.564e-2)).max()
    x = numpy.array([-3, -1, -0.1, 0.1, 0.5, 2])
    long = [half_space.rectangle(x, 0.1, math.radians(d), 1, 1e4, 0.3)[[0, 2]]
            - half_space.edge_dislocation(x, math.radians(d), math.sin(math.radians(d)))
            for d in (30, 60)]
    between = numpy.abs(long).max()
    fine = checklist < 1e-5 and between < 2e-5
    print(f"formulas: {checklist:.1e} from Okada's table, {between:.1e} between both"
          f"{'' if fine else ' NO'}", flush=True)
    return fine


def main():
    passed = [reference(), check(30, 32, 100), check(60, 32, 100), check(30, 14, 8, space=True),
              check(30, 32, 100, friction=False), check(30, 14, 8, space=True, friction=False)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
