"""asperity-bench stiffness: the condensed stiffness of a deck's mesh against that of squares."""

import math
import subprocess
import unittest

import asperity_run
import time_limits

PROGRAM = asperity_run.PROGRAM.parent / "asperity-bench"
DECKS = asperity_run.SOURCE / "xml"
CELL = 200.  # m
SHEAR_MODULUS = 2670 * 3464. ** 2  # Pa


def stiffness(*arguments):
    return subprocess.run([str(PROGRAM), "stiffness", *map(str, arguments)], capture_output=True,
                          text=True, timeout=time_limits.seconds(100), check=False)


def error_of_squares(cells):
    """Of slip cos(kx) under a Gaussian of width 5/k, by the symbol of the five-point stencil:
    G/h sin(kh/2) sqrt(1 + sin(kh/2)^2) where G k/2 is exact; h = 1."""
    k = 2 * math.pi / cells
    found = exact = 0.
    for i in range(-500, 501):
        wavenumber = k * (1 + i / 600)
        share = math.exp(-((wavenumber / k - 1) * 5) ** 2)
        s = math.sin(wavenumber / 2)
        found += share * 2 * s * math.sqrt(1 + s * s)
        exact += share * wavenumber
    return found / exact - 1


def errors_of_waves(*arguments):
    """Of bp1_qd.xml with what is set: by the number of cells in a wavelength."""
    result = stiffness(DECKS / "bp1_qd.xml", *arguments)
    if result.returncode != 0:
        raise AssertionError(result.stdout + result.stderr)
    lines = [line.strip("| ").split(" | ") for line in result.stdout.splitlines()]
    return {int(cells[0]): float(cells[2]) for cells in lines
            if len(cells) == 3 and cells[0].isdigit()}


class Columns(unittest.TestCase):
    def test_those_of_bp1_make_the_fault_as_stiff_as_it_is(self):
        """Columns of 1/sqrt(3) of the rows have no error of second order; they are of 4/7."""
        for cells, error in errors_of_waves("--set", "Mesh/Rectangle/Cell Size Factor=2").items():
            self.assertLess(abs(error), 0.1 * error_of_squares(cells))


class Squares(unittest.TestCase):
    """BP1 with cells of 200 m, squares beside the fault."""

    @classmethod
    def setUpClass(cls):
        cls.errors = errors_of_waves(
            "--set", "Mesh/Rectangle/Cells X=32", "--set",
            f"Mesh/Rectangle/Cell Size={CELL} + 0.035*sqrt(x^2 + max(0,-y-40e3)^2)",
            "--output", "stiffness.txt")
        with open("stiffness.txt") as file:
            cls.rows = [[float(number) for number in line.split()]
                        for line in file if not line.startswith("#")]

    def test_waves_have_the_error_of_the_five_point_stencil(self):
        self.assertEqual(sorted(self.errors), [12, 24])
        for cells, error in self.errors.items():
            self.assertAlmostEqual(error / error_of_squares(cells), 1, delta=0.02)

    def test_that_error_is_a_twelfth_of_kh_squared(self):
        for cells in (12, 24):
            small = (2 * math.pi / cells) ** 2 / 12
            self.assertAlmostEqual(error_of_squares(cells) / small, 1, delta=0.1)

    def test_the_file_has_the_matrix(self):
        size = len(self.rows)
        self.assertEqual({len(row) for row in self.rows}, {2 + size})
        positions, weights = [row[0] for row in self.rows], [row[1] for row in self.rows]
        self.assertEqual(positions[0], 0)
        self.assertAlmostEqual(positions[1], CELL)
        self.assertAlmostEqual(weights[size // 2], CELL)
        middle = size // 2
        matrix = [row[2:] for row in self.rows]
        self.assertLess(matrix[middle][middle], 0)
        for i in (0, 5, middle):
            for j in (1, 7, middle + 3):
                self.assertAlmostEqual(weights[i] * matrix[i][j] / (weights[j] * matrix[j][i]), 1,
                                       places=6)

    def test_neighbours_are_loaded_as_by_the_stencil(self):
        # The symbol's Fourier coefficients, of a node's slip at itself and beside it.
        middle = len(self.rows) // 2
        for distance in (0, 1, 2):
            coefficient, samples = 0., 20000
            for i in range(samples):
                theta = 2 * math.pi * (i + 0.5) / samples
                s = abs(math.sin(theta / 2))
                coefficient += 2 * s * math.sqrt(1 + s * s) * math.cos(distance * theta) / samples
            expected = -SHEAR_MODULUS / (2 * CELL) * coefficient
            found = self.rows[middle][2 + middle + distance]
            self.assertAlmostEqual(found / expected, 1, delta=1e-3)


class Refusals(unittest.TestCase):
    def refuses(self, word, *arguments):
        result = stiffness(*arguments)
        self.assertEqual(result.returncode, 2, result.stdout + result.stderr)
        self.assertIn(word, result.stderr)

    def test_a_fault_too_small_for_waves(self):
        self.refuses("do not fit", DECKS / "bp5_qd.xml",
                     "--set", "Mesh/Box/Cell Size Factor=8")

    def test_a_rigid_foundation(self):
        self.refuses("rigid foundation", DECKS / "spring_slider.xml")

    def test_steps(self):
        self.refuses("and --output", DECKS / "bp1_qd.xml", "--steps", "3")


if __name__ == "__main__":
    unittest.main()
