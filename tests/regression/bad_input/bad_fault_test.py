"""Bad input about faults between two bodies: one clear message and exit status 2, on 1 and 2 ranks.

Every case runs in a folder of its own, of which each file is compared afterwards.
"""

import pathlib
import unittest

import numpy

import bad_input_test
import mesh_files
from bad_input_test import DECK, Case, settings

LEVEL, UPRIGHT = "abs(y - 0.5) < 1e-6", "abs(x - 0.5) < 1e-6"
CONDITIONS = "Asperity / Boundary Conditions"
# The square of square.xml, cut through the middle.
TWO_SIDED = {"Mesh/Faults/main": LEVEL, "Boundary Conditions/Fault/Boundary": "main",
             "Boundary Conditions/Fault/Type": "Two-Sided Fault"}

OPENING = {**TWO_SIDED, "Boundary Conditions/Fault/Contact": "Unilateral",
           "Friction/Normal Stress Change": "Coupled"}

IN_TWO_PIECES = {**TWO_SIDED, "Mesh/Faults/main": f"{LEVEL} && x < 0.501",
                 "Mesh/Faults/rest": f"{LEVEL} && x > 0.499"}


def condition(name, boundary, type_name, **more):
    return {f"Boundary Conditions/{name}/{entry}": value
            for entry, value in {"Boundary": boundary, "Type": type_name, **more}.items()}


def without(name, changes):
    return {entry: value for entry, value in changes.items() if entry != name}


class FaultCase(Case):
    def arguments(self, changes):
        return [DECK, *settings(changes)]

    def refuse(self, changes, *pieces, on=(1, 2)):
        for ranks in on:
            with self.subTest(ranks=ranks):
                self.assert_refused(self.arguments(changes), *pieces, ranks=ranks)


class Conditions(FaultCase):
    def test_the_deck_itself_is_good(self):
        for ranks in (1, 2):
            self.assert_done(*self.arguments(TWO_SIDED), "--output", f"results_{ranks}",
                             ranks=ranks)

    def test_a_start_that_needs_slip(self):
        self.refuse({**TWO_SIDED, "Initial State/State": "Steady",
                     "Initial State/Velocity X": 1e-6},
                    "the initial slip rate is zero", "Give 'Slip Rate' a value there",
                    "the same on both sides")

    def test_on_the_surface_of_the_body(self):
        self.refuse({"Boundary Conditions/Fault/Type": "Two-Sided Fault"},
                    f"{CONDITIONS} / Fault / Boundary = 'bottom' is no fault inside the body",
                    "Mesh / Faults")
        self.refuse({**TWO_SIDED, **condition("Other", "right", "Two-Sided Fault")},
                    f"{CONDITIONS} / Other / Boundary = 'right' is no fault inside the body")
        self.refuse({**TWO_SIDED, **condition("Deep", "right", "Prescribed Slip Rate",
                                              **{"Slip Rate": 1e-6})},
                    f"{CONDITIONS} / Deep / Boundary = 'right' is no fault inside the body")

    def test_a_fault_that_may_open(self):
        for ranks in (1, 2):
            self.assert_done(*self.arguments(OPENING), "--output", f"open_{ranks}", ranks=ranks)
        why = "a fault has the Contact 'Unilateral'"
        for scheme in ({"Time Stepping/Scheme": "Generalised Alpha"},
                       {"Time Stepping/Scheme": "Newmark", "Time Stepping/Newmark/beta": 0.3}):
            self.refuse({**OPENING, **scheme}, why, scheme["Time Stepping/Scheme"],
                        "throw back", "'Newmark' with beta = 0.25")
        self.refuse(without("Friction/Normal Stress Change", OPENING), why,
                    "Normal Stress Change = Fixed", "Choose Coupled")
        self.refuse({**OPENING, "Friction/Normal Stress Floor": 1}, why,
                    "Normal Stress Floor = 1 Pa")
        self.refuse({**OPENING, "Friction/Cohesion": "if(x > 0.4, 5, 0)"}, why,
                    "Cohesion is 5 Pa at x = ")
        crossing = condition("Second", "second", "Two-Sided Fault")
        self.refuse({**OPENING, **crossing, "Mesh/Faults/second": UPRIGHT}, why,
                    "at x = (0.5, 0.5) it meets another fault")
        self.refuse({**OPENING, **crossing, "Mesh/Faults/second": f"{UPRIGHT} && y < 0.501"}, why,
                    "at x = (0.5, 0.5) it meets another fault")
        self.refuse({"Boundary Conditions/Fault/Contact": "Unilateral"},
                    f"{CONDITIONS} / Fault / Contact has no effect", "'Two-Sided Fault'")

    def test_two_that_act_on_the_same_facets(self):
        """'load' and 'rim' have the facet of 'right' under other names."""
        sides = {**bad_input_test.SIDES, "load": [[1, 2]], "rim": [[1, 2], [2, 3]]}
        mesh_files.write("mesh.h5", bad_input_test.CORNERS, ((0, 1, 2), (0, 2, 3)), sides)
        deck = settings({"Mesh/Type": "File", "Mesh/File/File Name": "mesh.h5"})
        pressed = condition("Pressed", "load", "Prescribed Traction", Pressure=1e3)
        pairs = [condition("Other", "right", "Prescribed Traction", Pressure=1e3),
                 condition("Other", "right", "Absorbing"),
                 condition("Other", "rim", "Free Surface")]
        for other in pairs:
            for ranks in (1, 2):
                with self.subTest(other, ranks=ranks):
                    self.assert_refused(
                        [DECK, *deck, *settings({**pressed, **other})],
                        f"{CONDITIONS} / Pressed (Prescribed Traction on 'load')",
                        f"{CONDITIONS} / Other", "have 1 facet in common, one at (1, 0.5) m",
                        ranks=ranks)
        for legal in ({**pressed, **condition("Other", "right", "Prescribed Velocity",
                                              Direction="{0, 1}")},
                      {**condition("One", "load", "Free Surface"),
                       **condition("Other", "rim", "Free Surface")},
                      {"Boundary Conditions/Drive/Velocity": 0,
                       **condition("One", "load", "Prescribed Velocity", Direction="{1, 0}"),
                       **condition("Other", "right", "Prescribed Velocity", Direction="{0, 1}")}):
            self.assert_done(DECK, *deck, *settings(legal), "--validate")

    def test_a_mirror_that_is_bent(self):
        bent = {"Mesh/Boundaries/corner": "min(x, y) < 1e-6",
                **condition("Fault", "corner", "Antisymmetric Fault"),
                "Boundary Conditions/Side/Boundary": "right"}
        self.refuse(bent, f"{CONDITIONS} / Fault (Antisymmetric Fault): it mirrors the body",
                    "'corner' is not in one plane: the normal of 8 facets")
        self.refuse({**condition("Fault", "bottom", "Antisymmetric Fault"),
                     **condition("Deep", "right", "Prescribed Slip Rate", **{"Slip Rate": 1e-6})},
                    "'bottom' is not in one plane: the normal of 4 facets")

    def test_on_bodies_that_touch(self):
        """The square in two halves, above and below y = 0.5, each with vertices of its own."""
        vertices = [(x, y) for y in (0, 0.5) for x in (0, 0.5, 1)]
        cells = [(0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4)]
        vertices += [(x, y + 0.5) for x, y in vertices]
        upper = [tuple(vertex + 6 for vertex in cell) for cell in cells]
        mesh_files.write("touch.h5", vertices, cells + upper,
                         {"bottom": [(0, 1), (1, 2)], "left": [(3, 0), (9, 6)],
                          "right": [(2, 5), (8, 11)], "top": [(11, 10), (10, 9)],
                          "main": [(5, 4), (4, 3)]},
                         region_of_cells=[0] * 4 + [1] * 4, regions=(b"below", b"above"))
        changes = {**without("Mesh/Faults/main", TWO_SIDED), "Mesh/Type": "File",
                   "Mesh/File/File Name": str(pathlib.Path("touch.h5").absolute())}
        self.refuse(changes, "Fault / Boundary = 'main' is no fault inside the body",
                    "2 facets of region 'below' lie on facets of region 'above' without sharing "
                    "vertices", "on boundary 'main'")

    def test_no_condition_on_a_fault(self):
        self.refuse({"Mesh/Faults/main": LEVEL}, CONDITIONS,
                    "nothing is said about the fault 'main'")
        self.refuse(IN_TWO_PIECES, CONDITIONS, "nothing is said about the fault 'rest'")

    def test_a_type_that_is_not_for_faults(self):
        for type_name in ("Antisymmetric Fault", "Bilateral Contact"):
            self.refuse({**TWO_SIDED, "Boundary Conditions/Fault/Type": type_name},
                        f"{CONDITIONS} / Fault / Boundary = 'main' is a fault inside the body",
                        f"'{type_name}'", "'Two-Sided Fault'")
        for type_name in ("Fixed", "Free Surface", "Absorbing", "Prescribed Velocity",
                          "Sliding Wall"):
            self.refuse({**IN_TWO_PIECES, **condition("Rest", "rest", type_name)},
                        f"{CONDITIONS} / Rest / Boundary = 'rest' is a fault inside the body",
                        f"'{type_name}'", "'Two-Sided Fault'", on=(1,))
        self.refuse({**TWO_SIDED, "Boundary Conditions/Fault/Type": "Fixed"}, CONDITIONS,
                    "has no condition of Type", "'Two-Sided Fault'", on=(1,))

    def test_two_types_on_one_fault(self):
        self.refuse({**TWO_SIDED, **condition("Deep", "main", "Prescribed Slip Rate",
                                              **{"Slip Rate": 1e-6})},
                    f"{CONDITIONS} / Deep", "contradicts", f"{CONDITIONS} / Fault", "'main'")

    def test_slip_prescribed_alone_on_the_outer_boundary(self):
        changes = condition("Fault", "bottom", "Prescribed Slip Rate", **{"Slip Rate": 1e-6})
        self.refuse(changes, f"{CONDITIONS} / Fault", "is no fault inside the body",
                    "'Two-Sided Fault'")

    def test_beside_friction_on_the_surface(self):
        for other in ("Antisymmetric Fault", "Bilateral Contact"):
            self.refuse({**TWO_SIDED, **condition("Other", "bottom", other)},
                        f"{CONDITIONS} / Other")

    def test_a_condition_on_one_side_alone(self):
        upright = {**TWO_SIDED, "Mesh/Faults/main": UPRIGHT,
                   "Mesh/Boundaries/half": "y > 0.999 && x < 0.5",
                   "Boundary Conditions/Drive/Boundary": "half"}
        self.refuse(upright, f"{CONDITIONS} / Drive", "one side of a fault alone", "(0.5, 1)")


class Meshes(FaultCase):
    def setUp(self):
        super().setUp()
        self.from_file = {**without("Mesh/Faults/main", TWO_SIDED), "Mesh/Type": "File",
                          "Mesh/File/File Name": "mesh.h5"}

    @staticmethod
    def write(**faults):
        """A square of 16 vertices, numbered row by row, two triangles in each of its 9 squares."""
        lower_left = numpy.array([4 * j + i for j in range(3) for i in range(3)])
        cells = numpy.concatenate([lower_left[:, None] + corners
                                   for corners in ([0, 1, 5], [0, 5, 4])])
        sides = {"bottom": [[0, 1], [1, 2], [2, 3]], "top": [[12, 13], [13, 14], [14, 15]],
                 "left": [[0, 4], [4, 8], [8, 12]], "right": [[3, 7], [7, 11], [11, 15]]}
        for name, facets in faults.items():
            sides[name] = sides.get(name, []) + facets
        vertices = [[i / 3, j / 3] for j in range(4) for i in range(4)]
        mesh_files.write("mesh.h5", vertices, cells, sides)

    def test_a_good_file(self):
        self.write(main=[[4, 5], [5, 6], [6, 7]])
        for ranks in (1, 2):
            self.assert_done(*self.arguments(self.from_file), "--output", f"results_{ranks}",
                             ranks=ranks)

    def test_a_side_without_cells(self):
        """It goes on along the surface of the body, where there is nothing on its other side."""
        self.write(main=[[4, 5], [5, 6], [6, 7], [7, 11]])
        self.refuse(self.from_file, "Mesh file '", "mesh.h5'",
                    "boundary 'main' has facets inside the body",
                    "and on its surface, one at (1, 0.5)")
        self.write(right=[[4, 5], [5, 6], [6, 7]])
        self.refuse({**self.from_file, "Boundary Conditions/Fault/Boundary": "right"},
                    "boundary 'right' has facets inside the body", "on its surface")

    def test_facets_that_no_cell_has(self):
        self.write(main=[[4, 5], [5, 8]])
        self.refuse(self.from_file, "mesh.h5", "'main'")
        self.write(main=[[6, 9]])
        self.refuse(self.from_file, "mesh.h5", "'main'")

    def test_three_faults_that_cross(self):
        self.write(main=[[4, 5], [5, 6], [6, 7]], dyke=[[1, 5], [5, 9], [9, 13]],
                   third=[[0, 5], [5, 10]])
        self.refuse({**self.from_file, **condition("Dyke", "dyke", "Two-Sided Fault"),
                     **condition("Third", "third", "Two-Sided Fault")},
                    "faults 'dyke', 'main' and 'third' cross at (0.3333333333, 0.3333333333)")

    def test_one_facet_in_two_faults(self):
        self.write(main=[[4, 5], [5, 6], [6, 7]], other=[[6, 7]])
        self.refuse({**self.from_file, **condition("Other", "other", "Two-Sided Fault")},
                    "'main'", "'other'")

    def test_a_fault_that_forks_under_one_name(self):
        self.write(main=[[4, 5], [5, 6], [6, 7], [6, 10], [10, 14]])
        self.refuse(self.from_file, "'main' meet at", "give a branch a name of its own")

    def test_a_fault_that_cuts_no_facet(self):
        for place in ("abs(y - 0.4) < 1e-6", "y > 2"):
            self.refuse({**TWO_SIDED, "Mesh/Faults/main": place},
                        "Asperity / Mesh / Faults / main: the fault has no facet")

    def test_names(self):
        self.refuse({**TWO_SIDED, "Boundary Conditions/Fault/Boundary": "mian"},
                    f"{CONDITIONS} / Fault / Boundary = 'mian'", "Did you mean 'main'?")


if __name__ == "__main__":
    unittest.main()
