"""Two faults that meet along a line in space, xml/meshes/conjugate_3d.geo with large cells: what
holds however they meet. `right_lateral` goes on, and `left_lateral` has the smaller depth."""

import pathlib
import re
import unittest

import asperity_run
import h5py
import numpy
from asperity_run import settings
from comparisons import assert_same_results
from mesh_files import mesh_tool

DECK = pathlib.Path(__file__).with_name("crossing_3d.xml")
GEOMETRY = asperity_run.SOURCE / "xml" / "meshes" / "conjugate_3d.geo"
RIGHT_DEPTH, LEFT_DEPTH = 15e3, 12e3  # m
SIZES = {"h": 3e3, "growth": 0.6, "largest": 20e3, "right_west": 20e3, "right_east": 20e3,
         "right_depth": RIGHT_DEPTH, "left_west": 15e3, "left_east": 15e3,
         "left_depth": LEFT_DEPTH}
WHOLE, ALONE = (settings({"Mesh/File/File Name": pathlib.Path(name).absolute()})
                for name in ("whole.h5", "alone.h5"))
SECOND = "Boundary Conditions/Left-lateral"
BOTH = settings({f"{SECOND}/Boundary": "left_lateral", f"{SECOND}/Type": "Two-Sided Fault"})
LOCKED = settings({f"{SECOND}/Boundary": "left_lateral",
                   f"{SECOND}/Type": "Prescribed Slip Rate", f"{SECOND}/Slip Rate": 0})
INERTIA = settings({"Bulk/Dynamics": "Inertial", "Time Stepping/Final Time": 2,
                    "Time Stepping/Largest Step": 0.25, "Time Stepping/Smallest Step": 0.25})


class Slip:
    """Slip at the end (nodes, 3), of one fault after the other."""

    def __init__(self, folder):
        history = asperity_run.series(folder / "fault.h5")
        self.places, self.vector = history["geometry/coordinates"], history["fields/slip"][-1]
        self.size = numpy.linalg.norm(self.vector, axis=1)
        self.vertices = history["geometry/vertex_ids"]
        elements = history["geometry/connectivity"]
        if "geometry/boundary_names" in history:
            fault = history["geometry/element_boundaries"]
            self.nodes = {name.decode(): numpy.unique(elements[fault == number])
                          for number, name in enumerate(history["geometry/boundary_names"])}
        else:
            self.nodes = {"right_lateral": numpy.unique(elements)}  # the only one with friction

    def on(self, fault):
        """Of one fault: places and slip, nodes in an order that other runs have, too."""
        nodes = self.nodes[fault]
        nodes = nodes[numpy.lexsort(self.places[nodes].round(3).T)]
        return self.places[nodes], self.vector[nodes]


class TwoFaults(unittest.TestCase):
    SIZES = {}    # of the geometry, in place of SIZES above
    CHANGES = []  # of the deck

    @classmethod
    def setUpClass(cls):
        sizes = [word for name, value in {**SIZES, **cls.SIZES}.items()
                 for word in ("--set", f"{name}={value}")]
        mesh_tool("convert", GEOMETRY, "whole.h5", "--overwrite", *sizes)
        mesh_tool("convert", GEOMETRY, "alone.h5", "--overwrite", *sizes, "--without",
                  "left_lateral")

    def run_deck(self, name, *arguments, mesh=WHOLE, ranks=1):
        """The folder; J falls in every step, and the energy balance closes in each of them."""
        folder = asperity_run.run_to_end(name, DECK, *mesh, *self.CHANGES, *arguments, ranks=ranks)
        rows = asperity_run.table(folder / "steps.csv")
        self.assertEqual([row["energy_increases"] for row in rows], [0] * len(rows))
        friction = rows[-1]["friction_work"]
        self.assertGreater(friction, 0)
        for row in rows:
            self.assertLess(abs(row["energy_defect"]), 1e-9 * friction)
        return folder

    def assert_same(self, expected, found):
        numpy.testing.assert_array_equal(found.places, expected.places)
        self.assertGreater(expected.size.max(), 0.1)
        numpy.testing.assert_allclose(found.vector, expected.vector, rtol=0,
                                      atol=1e-7 * expected.size.max())

    def test_ranks(self):
        for more in ((), INERTIA):
            expected = Slip(self.run_deck("one_rank", *BOTH, *more))
            self.assert_same(expected, Slip(self.run_deck("two_ranks", *BOTH, *more, ranks=2)))

    def test_solvers(self):
        expected = Slip(self.run_deck("auto", *BOTH))
        for correction in ("Direct", "Multigrid"):
            self.assert_same(expected, Slip(self.run_deck("other", *BOTH, *settings(
                {"TNNMG/Linear Correction": correction}))))

    def test_restart(self):
        """On the same ranks to the last digit, on others up to the tolerance of the solver."""
        for more in ((), INERTIA):
            whole = {ranks: self.run_deck(f"whole_{ranks}", *BOTH, *more, ranks=ranks)
                     for ranks in (1, 2)}
            for before, after in ((1, 1), (2, 2), (1, 2)):
                folder = self.run_deck("parts", *BOTH, *more, *settings(
                    {"Time Stepping/Final Time": 1}), ranks=before)
                asperity_run.go_on(folder, DECK, *WHOLE, *self.CHANGES, *BOTH, *more, ranks=after)
                if before == after:
                    assert_same_results(whole[after], folder)
                else:
                    self.assert_same(Slip(whole[after]), Slip(folder))

    def test_the_other_one_locked(self):
        """By its condition, or by strength that no stress reaches: the fault alone."""
        for more in ((), INERTIA):
            places, alone = Slip(self.run_deck("alone", *more, mesh=ALONE)).on("right_lateral")
            size = abs(alone).max()
            both = Slip(self.run_deck("both", *BOTH, *more))
            self.assertGreater(abs(both.on("right_lateral")[1] - alone).max(), 0.01 * size)
            strength = settings({"Friction/Cohesion": strength_of(both, "left_lateral")})
            for locked in (LOCKED, [*BOTH, *strength]):
                found = Slip(self.run_deck("locked", *locked, *more))
                if locked is not LOCKED:
                    self.assertLess(abs(found.on("left_lateral")[1]).max(), 1e-12)
                numpy.testing.assert_allclose(found.on("right_lateral")[0], places, atol=1e-6)
                numpy.testing.assert_allclose(found.on("right_lateral")[1], alone, rtol=0,
                                              atol=1e-8 * size)


def strength_of(slip, fault):
    """A dataset of cohesion that holds one of the faults. It goes by the numbers of vertices,
    since the nodes of both on the line lie at one place."""
    cohesion = numpy.zeros(int(re.search("^vertices +([0-9]+)", mesh_tool("info", "whole.h5"),
                                         re.MULTILINE)[1]))
    cohesion[slip.vertices[slip.nodes[fault]]] = 1e9
    with h5py.File("strength.h5", "w") as file:
        file["cohesion"] = cohesion
    return f"{pathlib.Path('strength.h5').absolute()}:/cohesion"
