"""The largest slip of cracks without friction, of radius or half length A, under the stress TAU:

    plane strain   2 (1 - nu) TAU A / G                    (Griffith)
    a circle       8 (1 - nu) TAU A / (pi (2 - nu) G)      (Eshelby 1957)

Cells hold back a share of it which falls with their size. As long as they do not lock, it is at no
ratio more than at 0.25 by over 2 % of the slip, and slip is nowhere larger than the closed form by
over 2 %. (That slip may come nearer to it than at 0.25 was seen in the first run.) Cells that keep
their volume each for itself lock, and the program warns of them. In the plane squares are cut all
alike: those that bisection cuts to and fro hardly lock.
"""

import math
import pathlib
import unittest

import asperity_run
import h5py
import mesh_files
import numpy

DECK = pathlib.Path(__file__).with_name("crack.xml")
A, TAU, G = 2., 1e6, 3e10
RATIOS = (0.4, 0.49, 0.499)
CLOSE = 0.02
WARNING = "keep their volume each for itself"
BOX_SIDES = ("left", "right", "bottom", "top", "front", "back")
CELLS, HALF = 64, 8.  # along a side of the square [-HALF, HALF]^2
SPACE = {"Mesh/Type": "Box", "Bulk/Model": "Solid",
         "Mesh/Box/Size": "{16, 16, 16}", "Mesh/Box/Lowest Corner": "{-8, -8, -8}",
         "Mesh/Box/Cells X": 8, "Mesh/Box/Cells Y": 8, "Mesh/Box/Cells Z": 8,
         "Mesh/Box/Cell Size": f"0.5 + 0.5 * max(0, sqrt(x^2 + y^2 + z^2) - {A})",
         "Mesh/Faults/crack": f"abs(z) < 1e-6 && x^2 + y^2 < {A}^2 + 1e-6",
         "Friction/Slip Direction": "{1, 0, 0}", "TNNMG/Relative Tolerance": 1e-8}


def squares_cut_alike(name):
    """Writes the mesh of the plane; boundary `far`, fault `crack`."""
    places = numpy.linspace(-HALF, HALF, CELLS + 1)
    vertices = numpy.stack(numpy.meshgrid(places, places), axis=-1).reshape(-1, 2)
    corner = (numpy.arange(CELLS)[:, None] * (CELLS + 1) + numpy.arange(CELLS)).ravel()
    right, up, across = corner + 1, corner + CELLS + 1, corner + CELLS + 2
    cells = numpy.concatenate([numpy.stack([corner, right, across], axis=1),
                               numpy.stack([corner, across, up], axis=1)])
    line = numpy.arange(CELLS)
    row = CELLS // 2 * (CELLS + 1) + line
    crack = row[numpy.abs(places[:-1] + HALF / CELLS) < A]
    top = CELLS * (CELLS + 1)
    far = numpy.concatenate([line, line + top, line * (CELLS + 1), line * (CELLS + 1) + CELLS])
    step = numpy.concatenate([numpy.ones(2 * CELLS, int), numpy.full(2 * CELLS, CELLS + 1)])
    mesh_files.write(name, vertices, cells,
                     {"crack": numpy.stack([crack, crack + 1], axis=1),
                      "far": numpy.stack([far, far + step], axis=1)})


def exact(nu, in_space):
    factor = 8 / (math.pi * (2 - nu)) if in_space else 2
    return factor * (1 - nu) * TAU * A / G


def share(nu, in_space, *more, ranks=1):
    """Slip found over slip of the closed form, and what the run printed."""
    name = f"{'circle' if in_space else 'line'}_{nu}_{len(more)}_{ranks}"
    fixed = {}
    for side in BOX_SIDES if in_space else ("far",):
        fixed[f"Boundary Conditions/{side}/Boundary"] = side
        fixed[f"Boundary Conditions/{side}/Type"] = "Fixed"
    mesh = pathlib.Path("squares.h5").absolute()
    if not in_space:
        squares_cut_alike(mesh)
    plane = {"Mesh/Type": "File", "Mesh/File/File Name": mesh}
    result = asperity_run.run(
        DECK, *asperity_run.settings(SPACE if in_space else plane, fixed, *more,
                                     {"Bulk/Poisson's Ratio": nu}),
        "--output", name, "--overwrite", ranks=ranks, timeout=200)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    with h5py.File(pathlib.Path(name) / "fault.h5") as file:
        slip = numpy.abs(file["fields/slip"][-1]).max()
    found = slip / exact(nu, in_space)
    print(name, found, flush=True)
    return found, result.stdout


class Cracks(unittest.TestCase):
    def keeps_its_share(self, in_space):
        expected, _ = share(0.25, in_space)
        self.assertGreater(expected, 0.5)
        self.assertLess(expected, 1 + CLOSE)
        for nu in RATIOS:
            found, printed = share(nu, in_space)
            self.assertGreater(found, (1 - CLOSE) * expected)
            self.assertLess(found, 1 + CLOSE)
            self.assertNotIn(WARNING, printed)

    def test_in_the_plane(self):
        self.keeps_its_share(False)

    def test_in_space(self):
        self.keeps_its_share(True)

    def test_cells_for_themselves_lock_and_the_program_says_so(self):
        alone = "Bulk/Volumetric Strain=Cell"
        found, printed = share(0.49, False, alone)
        self.assertLess(found, 0.9 * share(0.25, False)[0])
        self.assertIn(WARNING, printed)
        self.assertNotIn(WARNING, share(0.39, False, alone)[1])

    def test_any_number_of_ranks(self):
        for nu in (0.45, 0.499):
            expected, _ = share(nu, True)
            for ranks in (2, 3):
                found, printed = share(nu, True, ranks=ranks)
                self.assertAlmostEqual(found, expected, 6)
                self.assertNotIn(WARNING, printed)


if __name__ == "__main__":
    unittest.main()
