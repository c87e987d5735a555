"""Whether a wedge of Coulomb's rock without cohesion slides as one when it is pushed from behind,
or deforms inside: at the critical taper (Dahlen 1984; the base is level, and the surface slopes by
alpha)
    alpha + psi_0 = psi_b,   psi_0 = 1/2 (asin(sin alpha / sin phi) - alpha),
                             psi_b = 1/2 (asin(sin phi_b / sin phi) - phi_b)
all of it is at failure while the base slips. A thinner one deforms inside, a thicker one slides.

Wedges start with this stress, of which that on planes along the surface, at the depth z, is
rho g z (cos alpha, -sin alpha), pressure and shear, and that across them makes the rock yield. The
friction of the base is another one than this stress asks for, unless the taper is critical. The toe
is cut off; what the rock there bore goes on.
"""

import math
import pathlib
import sys

import asperity_run
import collapse
import mesh_files
import numpy

DECK = pathlib.Path(__file__).with_name("taper.xml")
PHI, PHI_B = math.radians(30), math.radians(25)  # of the rock, of the base
WEIGHT = 1e4                  # Pa/m
TOE, LENGTH, ROWS = 200.0, 1000.0, 6
RATE = 1e-3                   # m/s, of the wall
WITHIN = 0.03                 # of the critical taper
SLIDES, RESTS = 0.95, 0.5     # slip of the toe over that of the wall, at least, at most


def critical_taper():
    psi = lambda sine, angle: (math.asin(sine / math.sin(PHI)) - angle) / 2
    low, high = 0.0, PHI_B
    for _ in range(60):
        alpha = (low + high) / 2
        below = alpha + psi(math.sin(alpha), alpha) < psi(math.sin(PHI_B), PHI_B)
        low, high = (alpha, high) if below else (low, alpha)
    return low


def stress_at_failure(alpha):
    """Over rho g z along the base and up, (2, 2), positive in compression."""
    pressure, shear, square = math.cos(alpha), -math.sin(alpha), math.sin(PHI)**2
    # the larger p along the surface of ((p - pressure) / 2)^2 + shear^2 = ((p + pressure) / 2)^2
    # sin^2 phi
    along = max(numpy.roots([(1 - square) / 4, -(1 + square) * pressure / 2,
                             (1 - square) * pressure**2 / 4 + shear**2]))
    axes = numpy.array([[math.cos(alpha), math.sin(alpha)], [math.sin(alpha), -math.cos(alpha)]])
    return axes.T @ numpy.array([[along, shear], [shear, pressure]]) @ axes


def write_mesh(alpha):
    """Crossed cells that grow with the distance from the tip."""
    columns = round(math.log(LENGTH / TOE) * ROWS / math.tan(alpha))
    vertices, triangles, at = collapse.grid(
        numpy.linspace(math.log(TOE), math.log(LENGTH), columns + 1),
        numpy.linspace(0, 1, ROWS + 1), True)
    x = numpy.exp(vertices[:, 0])
    mesh_files.write("mesh.h5", numpy.stack([x, vertices[:, 1] * x * math.tan(alpha)], axis=1),
                     triangles, {"base": collapse.facets(at[:, 0]),
                                 "wall": collapse.facets(at[-1])})


def slip_of_toe(share, rock=None):
    """In the last step, over that of the wall; of a wedge with this share of the critical taper."""
    alpha = share * critical_taper()
    write_mesh(alpha)
    (xx, xy), (_, yy) = (WEIGHT * stress_at_failure(alpha)).tolist()  # texts below are of floats
    depth = f"({math.sin(alpha)!r} * x - {math.cos(alpha)!r} * y)"
    at_start = {"XX": xx, "YY": yy, "XY": xy, "ZZ": (xx + yy) / 2}
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {f"Bulk/Initial Stress/{name}": f"-{value!r} * {depth}"
         for name, value in at_start.items()},
        {"Friction/Normal Stress": f"{yy * math.sin(alpha)!r} * x",
         "Friction/Shear Traction": f"-{xy * math.sin(alpha)!r} * x",
         "Friction/Reference Friction Coefficient": math.tan(PHI_B)}, rock or {}))
    history = asperity_run.series(folder / "fault.h5")
    slip, time = -history["fields/slip"], history["time"]
    return (slip[-1, 0] - slip[-2, 0]) / (RATE * (time[-1] - time[-2]))


def main():
    thick, thin = slip_of_toe(1 + WITHIN), slip_of_toe(1 - WITHIN)
    elastic = slip_of_toe(1 - WITHIN, {"Bulk/Cohesion": 1e9})
    print(f"critical taper {math.degrees(critical_taper()):.2f} degrees; of the wall's slip the "
          f"toe has {thick:.3f} in a thicker wedge, {thin:.3f} in a thinner one, {elastic:.3f} if "
          "the rock of that does not yield")
    return 0 if min(thick, elastic) > SLIDES and thin < RESTS else 1


if __name__ == "__main__":
    sys.exit(main())
