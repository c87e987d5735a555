"""A fault of half length 1 in a body that rests far from it, which the pressure of a fluid opens.

Above the normal stress by T everywhere, it is a line crack: with a shear stress TAU, both in plane
strain (Griffith),

    opening  2 (1 - nu) T sqrt(1 - x^2) / G        slip  2 (1 - nu) TAU sqrt(1 - x^2) / G

With the pressure P on |x| < B alone it opens up to |x| = A, where its sides close smoothly: no
stress is singular there if the integral of (p - S) / sqrt(A^2 - x^2) over it vanishes,

    P arcsin(B / A) = S pi / 2
"""

import math
import pathlib
import unittest

import asperity_run
import crack_mesh
import numpy

DECK = pathlib.Path(__file__).parent.parent / "incompressible" / "crack.xml"
G, NU = 3e10, 0.25
S, T, TAU = 1e6, 1e6, 0.5e6
P, B = 2.5e6, 0.5 + 1 / 32  # between two nodes
A = B / math.sin(math.pi * S / (2 * P))
CRACK = "Boundary Conditions/Crack"


class Cracks(unittest.TestCase):
    def opened(self, name, size, pressure, *more, ranks=1):
        """Fields at the end, along the fault, and the weights."""
        crack_mesh.write(f"{name}.h5", size, second=False)
        fluid = {"Enabled": "true", "Permeability": 1e-30, "Storage": 1e-9, "Width": 1,
                 "Initial Pressure": pressure}
        folder = asperity_run.run_to_end(
            name, DECK, *asperity_run.settings(
                {"Mesh/File/File Name": pathlib.Path(f"{name}.h5").absolute(),
                 f"{CRACK}/Boundary": "level", f"{CRACK}/Contact": "Unilateral",
                 "Boundary Conditions/Far/Boundary": "far",
                 "Boundary Conditions/Far/Type": "Fixed",
                 "Friction/Normal Stress": S, "Friction/Normal Stress Change": "Coupled",
                 "Friction/Shear Traction": TAU,
                 "Time Stepping/Final Time": 0.4,  # four steps: at rest
                 "TNNMG/Relative Tolerance": 1e-11,
                 "Output/Fault History/Fields":
                     "{slip, opening, normal_stress, effective_normal_stress}"},
                {f"Friction/Pore Pressure/{entry}": value for entry, value in fluid.items()},
                *more),
            ranks=ranks, timeout=300)
        history = asperity_run.series(folder / "fault.h5")
        rows = asperity_run.table(folder / "steps.csv")
        self.assertEqual(sum(row["energy_increases"] for row in rows), 0)
        x = history["geometry/coordinates"][:, 0]
        order = numpy.argsort(x)
        found = {name: history[f"fields/{name}"][-1].ravel()[order]
                 for name in ("slip", "opening", "normal_stress", "effective_normal_stress")}
        found.update(x=x[order], weights=history["geometry/weights"][order], last=rows[-1])
        return found

    def test_line_crack(self):
        """Errors of cells of 1/8 and of 1/16 are of first order, as those of a crack that slips."""
        factor = 2 * (1 - NU) / G
        for field, load in (("opening", T), ("slip", TAU)):
            found = []
            for size in (1 / 8, 1 / 16):
                crack = self.opened(f"line_{field}", size, S + T)
                values = numpy.array([crack["weights"] @ crack[field],
                                      crack[field][numpy.argmin(abs(crack["x"]))]])
                found.append(values / (factor * load * numpy.array([math.pi / 2, 1])))
                self.assertAlmostEqual(crack["last"]["share_open"], 1, delta=1.01 * size)
            print(field, found, flush=True)
            coarse, fine = abs(1 - found[0]), abs(1 - found[1])
            self.assertLess(coarse.max(), 0.16)
            self.assertLess((fine / coarse).max(), 0.6)
            self.assertLess(abs(2 * found[1] - found[0] - 1).max(), 0.015)

    def test_pressure_on_a_part(self):
        crack = self.opened("part", 1 / 16, f"if(abs(x) < {B}, {P}, 0)")
        opening, stress = crack["opening"], crack["effective_normal_stress"]
        is_open = opening > 1e-9 * opening.max()
        self.assertGreaterEqual(opening.min(), -1e-12 * opening.max())
        numpy.testing.assert_allclose(stress[is_open], 0, atol=1e-6 * S)
        self.assertGreater(stress[~is_open].min(), 0)
        edge = abs(crack["x"][is_open]).max()
        print("opens up to", edge, "for", A, flush=True)
        self.assertLess(abs(edge - A), 1.5 / 16)

    def test_ranks_and_solvers(self):
        pressure = f"if(abs(x) < {B}, {P}, 0)"
        one = self.opened("one_rank", 1 / 8, pressure)
        multigrid = "TNNMG/Linear Correction=Multigrid"
        for name, ranks, more in (("two", 2, ()), ("three", 3, ()), ("multigrid", 1, (multigrid,))):
            other = self.opened(name, 1 / 8, pressure, *more, ranks=ranks)
            for field in ("slip", "opening"):
                numpy.testing.assert_allclose(other[field], one[field], rtol=0,
                                              atol=1e-6 * one[field].max())


if __name__ == "__main__":
    unittest.main()
