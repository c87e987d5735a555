"""Two different bodies turned: the turned answer; where plus and minus change places, too."""

import dataclasses
import math
import sys

import asperity_run
import bodies
import comparisons
import meshes
import numpy

VP, PRESSED = 1e-4, 1e-3  # m/s
STEADY = "1e4 * 0.010 * asinh(1e-4 / 2e-6 * exp((0.6 + 0.015 * ln(1e-6 / 1e-4)) / 0.010))"
TOLERANCE = 1e-8  # of the largest value
SCALARS = ("slip_rate", "alpha", "normal_stress")
VECTORS = ("slip", "traction")


@dataclasses.dataclass(frozen=True)
class Turn:
    matrix: numpy.ndarray

    @property
    def dimension(self):
        return len(self.matrix)

    def coordinate(self, axis):
        """As an expression: that of the place before it was turned."""
        terms = zip(self.matrix[:, axis], "xyz")
        return "(" + " + ".join(f"({float(factor)!r}) * {name}" for factor, name in terms) + ")"

    def of(self, *vector):
        return self.matrix @ numpy.array(vector[:self.dimension])

    @property
    def side(self):
        """+1 if the body above the fault, at y > 0 before, is its plus side, otherwise -1. The plus
        side is the upper one, of a vertical fault that with larger x."""
        normal = self.of(0, 1, 0)
        if abs(normal[1]) < 1e-6:
            return 1 if normal[0] > 0 else -1
        return 1 if normal[1] > 0 else -1

    @property
    def along_tangent(self):
        """+1 if the tangent in the plane is what +x was. It points to the positive side of the
        first axis, and of the second if it is steeper than 66 degrees."""
        tangent = self.of(1, 0)
        steep = abs(tangent[0]) < math.cos(math.radians(66))
        return 1 if tangent[1 if steep else 0] > 0 else -1

    def slip_of_file(self, slip):
        """As a vector before the turn; of the upper body past the lower one."""
        if self.dimension == 2:
            return self.side * self.along_tangent * slip
        return self.side * slip @ self.matrix


def mesh_of(turn):
    if turn.dimension == 2:
        axes = numpy.linspace(0, 1, 13), numpy.linspace(-0.5, 0.5, 11)
    else:
        axes = numpy.linspace(0, 1, 5), numpy.linspace(-0.5, 0.5, 5), numpy.linspace(0, 0.5, 3)
    mesh = meshes.with_sides(*meshes.grid(*axes), {"fault": meshes.on_the_fault})
    return mesh.mapped(lambda x: x @ turn.matrix.T)


def settings(turn, dynamics):
    """The bodies are sheared and pressed together; the upper one is four times as stiff."""
    along, across = turn.of(1, 0, 0), turn.of(0, 1, 0)
    sign = turn.side * (turn.along_tangent if turn.dimension == 2 else 1)
    given = {
        "Bulk/Model": "Plane Strain" if turn.dimension == 2 else "Solid",
        "Bulk/Dynamics": dynamics,
        "Bulk/Shear Modulus": f"{turn.coordinate(1)} > 0 ? 2e6 : 0.5e6",
        "Friction/Normal Stress Change": "Coupled",
        "Initial State/alpha": f"ln(1e-6 / 1e-4) + 0.5 * cos(_pi * {turn.coordinate(0)})",
        "Initial State/Slip Rate": VP * (sign if turn.dimension == 2 else 1),
        "Friction/Shear Traction": f"{sign if turn.dimension == 2 else 1} * {STEADY}",
        "Output/Fault History/Fields": "{slip, slip_rate, alpha, traction, normal_stress}",
        "Output/Surface History/Every n Steps": 1,
        "Output/Surface History/Precision": "Double",
        **bodies.conditions(fault={"Type": "Two-Sided Fault"},
                          top=bodies.prescribed(VP / 2, *along),
                          bottom=bodies.prescribed(-VP / 2, *along),
                          right={"Type": "Free Surface"}),
        **bodies.condition("press", "top", bodies.prescribed(-PRESSED, *across)),
        **bodies.condition("rest", "bottom", bodies.prescribed(0, *across))}
    if turn.dimension == 3:
        given.update(bodies.conditions(front={"Type": "Sliding Wall"}))
        given.update({"Friction/Slip Direction": bodies.array(sign * along),
                      "Time Stepping/Final Time": 0.5})
    return given


def answer(folder, turn):
    """What the run in that folder gave, turned back."""
    fault, places = bodies.fields_by_place(folder, SCALARS + VECTORS,
                                           lambda x: x[:, :turn.dimension] @ turn.matrix)
    for name in VECTORS:
        fault[name] = turn.slip_of_file(fault[name])
    surface = asperity_run.series(folder / "surface.h5")
    where = surface["geometry/coordinates"][:, :turn.dimension] @ turn.matrix
    moved = surface["fields/displacement"] @ turn.matrix
    # both sides of the fault are there; the upper one has moved further along it
    order = numpy.lexsort((moved[-1, :, 0], *numpy.round(where, 9).T))
    return {**fault, "displacement": moved[:, order], "places": places, "surface": where[order]}


def check(name, turn, dynamics, expected):
    found = answer(bodies.run("turned", mesh_of(turn), settings(turn, dynamics)), turn)
    differences = {key: comparisons.largest_difference(found[key], values)
                   for key, values in expected.items()}
    fine = max(differences.values()) < TOLERANCE
    shown = " ".join(f"{key} {value:.1e}" for key, value in differences.items())
    sides = "plus above" if turn.side > 0 else "plus below"
    print(f"{dynamics}, {name}, {sides}: {shown}{'' if fine else ' NO'}", flush=True)
    return fine


def check_solver(expected, unturned, dynamics, ranks):
    """Multigrid gives what one rank got directly."""
    folder = bodies.run("multigrid", mesh_of(unturned),
                      {**settings(unturned, dynamics), "TNNMG/Linear Correction": "Multigrid"},
                      ranks=ranks)
    found = answer(folder, unturned)
    difference = max(comparisons.largest_difference(found[key], expected[key]) for key in expected)
    fine = difference < TOLERANCE and bodies.energy_increases(folder) == 0
    print(f"{dynamics}, multigrid, ranks {ranks}: {difference:.1e}{'' if fine else ' NO'}",
          flush=True)
    return fine


def compare(dynamics, turns, ranks=1):
    unturned = Turn(numpy.eye(turns[0][1].dimension))
    folder = bodies.run("unturned", mesh_of(unturned), settings(unturned, dynamics))
    expected = answer(folder, unturned)
    pressed = numpy.ptp(expected["normal_stress"]) / 1e4
    varied = numpy.ptp(expected["slip_rate"]) / VP
    rises = bodies.energy_increases(folder)
    fine = pressed > 2e-2 and varied > 0.5 and rises == 0
    print(f"{dynamics}, {unturned.dimension}D: slip rates vary by {varied:.1f} Vp, the normal "
          f"stress by {pressed:.1%}; J rose {rises:.0f} times{'' if fine else ' NO'}", flush=True)
    return [fine, check_solver(expected, unturned, dynamics, ranks),
            *(check(name, turn, dynamics, expected) for name, turn in turns)]


def main():
    plane = [(f"{degrees} degrees", Turn(meshes.rotation(math.radians(degrees))))
             for degrees in (20, -53, 90, 135, 180)]
    # about z, x and z again
    space = [(f"{angles} rad", Turn(meshes.rotation(*angles)))
             for angles in ((0.3, 0, 0), (0.2, 0.7, -0.4), (0.4, math.pi, 0.1))]
    passed = [*compare("Quasi-dynamic", plane), *compare("Inertial", plane[:2], 2),
              *compare("Quasi-dynamic", space)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
