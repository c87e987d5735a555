"""How much a thick cylinder and the ground below a strip footing bear, rock of von Mises in plane
strain with the shear strength k. Cells are crossed squares, of four triangles each, or squares that
the program bisects. Where all squares are cut the same way they are too stiff for flow that keeps
the volume: the cylinder bears more, and what the footing bears has no limit.

The pressure p in a cylinder from a to b that has yielded to c, and the displacement of its outside
(Hill 1950, for Poisson's ratio 1/2; at 0.45 and c = b its t is 0.17 % above p's k):
    p = k (2 ln(c / a) + 1 - (c / b)^2),   u(b) = (1 - nu) k c^2 / (G b)
It bears 2 k ln(b / a). Rock of Mohr and Coulomb with cohesion c and friction angle phi bears, with
N = (1 + sin(phi)) / (1 - sin(phi)),
    p = c cot(phi) ((b / a)^(1 - 1 / N) - 1)
and so does Drucker and Prager's law in associated flow in plane strain, where (1952)
    sin(phi') = 3 tan(phi) / sqrt(9 + 12 tan(phi)^2),   c' cos(phi') = 3 c / sqrt(9 + 12 tan(phi)^2)
A strip footing bears (2 + pi) k (Prandtl 1920); in a mesh it is wider by half a cell, so that the
error is of first order.
"""

import math
import pathlib
import sys

import asperity_run
import mesh_files
import numpy

DECK = pathlib.Path(__file__).with_name("collapse.xml")
G, POISSON, K = 1e9, 0.45, 1e6  # Pa, -, Pa
A, B = 1.0, 2.0                 # m, of the cylinder
LIMIT = 0.03
ORDER = 0.8, 1.2                # of the footing in the size of cells
BISECTED_LIMIT = 0.125          # on 8 cells: their size; chosen after
CUT_ORDER = 1.5                 # of the cylinder of squares cut in two; chosen after: it is 1.9


def grid(x, y, crossed):
    """Vertices and cells of squares, each cut from its lower left corner or crossed; and the
    numbers of the vertices at the corners, (len(x), len(y))."""
    corners = numpy.stack(numpy.meshgrid(x, y, indexing="ij"), axis=-1)
    numbers = numpy.arange(len(x) * len(y)).reshape(len(x), len(y))
    at = [numbers[:-1, :-1], numbers[1:, :-1], numbers[1:, 1:], numbers[:-1, 1:]]
    at = [corner.ravel() for corner in at]
    vertices = corners.reshape(-1, 2)
    if not crossed:
        return vertices, numpy.concatenate([numpy.stack([at[0], at[1], at[2]], axis=1),
                                            numpy.stack([at[0], at[2], at[3]], axis=1)]), numbers
    middle = len(vertices) + numpy.arange(len(at[0]))
    vertices = numpy.concatenate([vertices, sum(vertices[corner] for corner in at) / 4])
    cells = [numpy.stack([at[i], at[(i + 1) % 4], middle], axis=1) for i in range(4)]
    return vertices, numpy.concatenate(cells), numbers


def facets(vertices):
    return numpy.stack([vertices[:-1], vertices[1:]], axis=1)


def moving(name, boundary, along, velocity):
    direction = "{1, 0}" if along == "x" else "{0, 1}"
    entries = {"Boundary": boundary, "Type": "Prescribed Velocity", "Direction": direction,
               "Velocity": velocity}
    return {f"Boundary Conditions/{name}/{key}": value for key, value in entries.items()}


def at_rest(name, boundary, kind):
    return {f"Boundary Conditions/{name}/Boundary": boundary,
            f"Boundary Conditions/{name}/Type": kind}


def pushed(receiver, *changes, removed=()):
    """The work at the boundary in each step [J/m], the displacement of a place along x [m] in the
    middle of it; prints what steps cost."""
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {"Output/Receivers/Off Fault/place": receiver}, *changes),
        *(word for entry in removed for word in ("--remove", entry)), timeout=300)
    rows = asperity_run.table(folder / "steps.csv")
    problems, steps = (sum(row[name] for row in rows)
                       for name in ("rate_problems", "coupled_steps"))
    print(f"  {problems / steps:.1f} rate problems a step", flush=True)
    work = numpy.array([0] + [row["boundary_work"] for row in rows])
    u = asperity_run.series(folder / "receivers.h5")["off_fault/fields/displacement"][:, 0, 0]
    return numpy.diff(work), (u[1:] + u[:-1]) / 2


def pressures(cells, crossed, *changes, removed=(), rate=1e-4):
    """In a cylinder that is pushed apart, and the displacement of its outside."""
    vertices, triangles, at = grid(numpy.linspace(A, B, cells + 1),
                                   numpy.linspace(0, math.pi / 2, 3 * cells // 2 + 1), crossed)
    radius, angle = vertices.T
    mesh_files.write("mesh.h5", numpy.stack(
        [radius * numpy.cos(angle), radius * numpy.sin(angle)], axis=1), triangles, {
            "axis": facets(at[:, 0]), "side": facets(at[:, -1]), "inside": facets(at[0])})
    work, u_outside = pushed(
        f"{{{B}, 0}}", at_rest("Side", "side", "Sliding Wall"),
        moving("x", "inside", "x", f"{rate} * x / {A}"),
        moving("y", "inside", "y", f"{rate} * y / {A}"), *changes, removed=removed)
    return work / (rate * math.pi / 2 * A), u_outside


def cylinder(cells, crossed):
    """The largest error of p(c), and that of the pressure that it bears at last."""
    pressure, u_outside = pressures(cells, crossed)
    c = numpy.sqrt(u_outside * G * B / ((1 - POISSON) * K))
    partly = (c > A) & (c < B)
    expected = K * (2 * numpy.log(c / A) + 1 - (c / B)**2)
    assert partly.sum() > 10 and c[-1] > B
    return (numpy.abs(pressure / expected - 1)[partly].max(),
            pressure[-1] / (2 * K * math.log(B / A)) - 1)


def cylinder_in_associated_flow(cells, degrees=20):
    """By how much it bears more, and how much this still grew in the last step."""
    phi = math.radians(degrees)
    size = math.sqrt(9 + 12 * math.tan(phi)**2)
    of_cone = math.asin(3 * math.tan(phi) / size)
    angle = f"{math.degrees(of_cone):.15g}"
    pressure, _ = pressures(cells, True, {
        "Bulk/Law": "Drucker-Prager", "Bulk/Cohesion": 3 * K / size / math.cos(of_cone),
        "Bulk/Friction Angle": angle, "Bulk/Dilation Angle": angle},
        removed=["Bulk/Shear Strength"])
    N = (1 + math.sin(phi)) / (1 - math.sin(phi))
    borne = pressure / (K / math.tan(phi) * ((B / A)**(1 - 1 / N) - 1))
    return borne[-1] - 1, borne[-1] - borne[-2]


def footing(*changes, rate=1e-3):
    """By how much half a rough footing of width 2 bears more than (2 + pi) k at last, and how much
    this still grew in the last step. The ground is a rectangle of 5 by 3; changes name its mesh."""
    work, _ = pushed("{1, -1}", at_rest("Side", "right", "Sliding Wall"),
                     at_rest("Below", "bottom", "Fixed"), moving("x", "footing", "x", 0),
                     moving("y", "footing", "y", -rate), "Boundary Conditions/Axis/Boundary=left",
                     "Time Stepping/Final Time=16", *changes)
    borne = work / rate / ((2 + math.pi) * K)
    return borne[-1] - 1, borne[-1] - borne[-2]


def on_squares(cells, crossed=True):
    vertices, triangles, at = grid(numpy.linspace(0, 5, 5 * cells + 1),
                                   numpy.linspace(-3, 0, 3 * cells + 1), crossed)
    mesh_files.write("mesh.h5", vertices, triangles, {
        "left": facets(at[0]), "right": facets(at[-1]), "bottom": facets(at[:, 0]),
        "footing": facets(at[:cells + 1, -1])})
    return footing()


def on_bisected(cells):
    """A mesh of the program, whose squares are cut along either diagonal."""
    shape = {"Width": 5, "Height": 3, "Lower Left": "{0, -3}", "Cells X": 5, "Cells Y": 3,
             "Cell Size": 1 / cells}
    return footing({f"Mesh/Rectangle/{name}": value for name, value in shape.items()},
                   {"Mesh/Type": "Rectangle",
                    "Mesh/Boundaries/footing": "y > -1e-9 && x < 1 + 1e-9"})


def verdict(what, fine):
    print(f"{what}{'' if fine else ' NO'}", flush=True)
    return fine


def cylinders():
    on_the_way, at_last = cylinder(8, True)
    cut = [cylinder(cells, False)[1] for cells in (8, 16)]
    order = math.log2(cut[0] / cut[1])
    associated, growth = cylinder_in_associated_flow(8)
    return [verdict(f"cylinder: {on_the_way:.2%} of p(c), {at_last:.2%} at last",
                    max(on_the_way, abs(at_last)) < LIMIT),
            verdict(f"of squares cut in two: {cut[0]:.2%}, {cut[1]:.2%}, order {order:.2f}",
                    order > CUT_ORDER),
            verdict(f"in associated flow: {associated:.2%}, in the last step {growth:.3%}",
                    abs(associated) < LIMIT and growth < 1e-3)]


def footings():
    cut, growth = on_squares(8, crossed=False)
    print(f"footing on squares cut in two: {cut:.2%}, in the last step {growth:.2%}")
    passed = []
    for what, on, cells, limit in (("crossed squares", on_squares, 16, LIMIT),
                                   ("bisected squares", on_bisected, 8, BISECTED_LIMIT)):
        (coarse, _), (fine, growth) = on(cells // 2), on(cells)
        order = math.log2(coarse / fine)
        passed.append(verdict(
            f"footing on {what}: {coarse:.2%}, {fine:.2%}, order {order:.2f}, in the last step "
            f"{growth:.3%}", abs(fine) < limit and ORDER[0] < order < ORDER[1]))
    return passed


def main():
    passed = [*cylinders(), *footings()]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
