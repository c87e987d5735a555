"""Two faults that cross along a line in space: ranks, restart, other solvers, inertia, energy, and
one of them alone where the other one is locked.

The line goes from the surface to the lower edge of the second fault, inside the first one."""

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
COARSE = [word for size in (
    "h=3e3", "growth=0.6", "largest=20e3", "right_west=20e3", "right_east=20e3", "right_depth=15e3",
    "left_west=15e3", "left_east=15e3", "left_depth=12e3") for word in ("--set", size)]
MESH = settings({"Mesh/File/File Name": pathlib.Path("crossing.h5").absolute()})
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


class Crossing(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        mesh_tool("convert", GEOMETRY, "crossing.h5", "--overwrite", *COARSE)
        mesh_tool("convert", GEOMETRY, "alone.h5", "--overwrite", *COARSE, "--without",
                  "left_lateral")

    def run_deck(self, name, *arguments, mesh=MESH, ranks=1):
        """The folder; J falls in every step, and the energy balance closes in each of them."""
        folder = asperity_run.run_to_end(name, DECK, *mesh, *arguments, ranks=ranks)
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

    def test_both_slip_through_the_crossing(self):
        """At each vertex of the line both faults have a node, which slips about as much as those
        beside it; at tips nothing slips."""
        printed = mesh_tool("info", "crossing.h5")
        of_line = int(re.search("left_lateral and right_lateral at ([0-9]+) ", printed)[1])
        self.assertGreater(of_line, 3)
        slip = Slip(self.run_deck("both", *BOTH))
        for fault, depth, ends, across in (
                ("right_lateral", 15e3, 20e3, (-0.5, 3**0.5 / 2)),
                ("left_lateral", 12e3, 15e3, (0.5, 3**0.5 / 2))):
            places, vector = slip.on(fault)
            numpy.testing.assert_allclose(places[:, :2] @ across, 0, atol=1e-6)
            numpy.testing.assert_allclose(vector[:, :2] @ across, 0, atol=1e-12)
            self.assertGreater(vector[:, 1].min(), -1e-12)  # the senses of conjugate faults
            size, from_line = numpy.linalg.norm(vector, axis=1), numpy.hypot(*places[:, :2].T)
            on_line = (from_line < 1) & (places[:, 2] > -12e3 + 1)
            self.assertEqual(on_line.sum(), of_line)
            beside = (from_line > 1) & (from_line < 5e3)
            for place, value in zip(places[on_line], size[on_line]):
                near = size[beside & (abs(places[:, 2] - place[2]) < 2e3)]
                self.assertGreater(value, 0.5 * near.min())
                self.assertLess(value, 2 * near.max())
            at_tip = (places[:, 2] < 1 - depth) | (from_line > ends - 1)
            self.assertGreater(at_tip.sum(), 15)
            self.assertEqual(size[at_tip].max(), 0)

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
                asperity_run.go_on(folder, DECK, *MESH, *BOTH, *more, ranks=after)
                if before == after:
                    assert_same_results(whole[after], folder)
                else:
                    self.assert_same(Slip(whole[after]), Slip(folder))

    def test_the_other_one_locked(self):
        """By its condition, or by strength that no stress reaches: the fault alone."""
        alone_mesh = settings({"Mesh/File/File Name": pathlib.Path("alone.h5").absolute()})
        for more in ((), INERTIA):
            places, alone = Slip(self.run_deck("alone", *more, mesh=alone_mesh)).on(
                "right_lateral")
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


class SameDepth(unittest.TestCase):
    def test_a_direction_between_two_faults(self):
        """Where faults at right angles end at the same depth, they have a tip in common, whose
        normal lies between theirs: there a direction that both have a part of may have none."""
        result = asperity_run.run(
            asperity_run.SOURCE / "xml" / "step_over_3d.xml", "--validate", *settings({
                "Mesh/Box/Cell Size": 5e3,
                "Mesh/Faults/near": "abs(z) < 1 && abs(x) < 20.001e3 && y > -20.001e3",
                "Mesh/Faults/far": "abs(x) < 1 && abs(z) < 20.001e3 && y > -20.001e3",
                "Names/sense": 1, "Friction/Slip Direction": "{1, 0, 1}"}))
        self.assertEqual((result.returncode, result.stderr), (0, ""))


def strength_of(slip, fault):
    """A dataset of cohesion that holds one of the faults. It goes by the numbers of vertices,
    since the nodes of both at the crossing lie at one place."""
    cohesion = numpy.zeros(int(re.search("^vertices +([0-9]+)", mesh_tool("info", "crossing.h5"),
                                         re.MULTILINE)[1]))
    cohesion[slip.vertices[slip.nodes[fault]]] = 1e9
    with h5py.File("strength.h5", "w") as file:
        file["cohesion"] = cohesion
    return f"{pathlib.Path('strength.h5').absolute()}:/cohesion"


if __name__ == "__main__":
    unittest.main()
