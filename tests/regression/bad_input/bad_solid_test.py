"""Bad input in space ends with one clear message and exit status 2, on two ranks, without a hang.

Every case runs in a folder of its own, of which each file is compared afterwards.
"""

import pathlib
import shutil
import unittest

import h5py
import numpy

from bad_input_test import Case, settings
from mesh_files import mesh_tool

HERE = pathlib.Path(__file__).parent
DECK = HERE / "cube.xml"
BRICKS = ("--cells-x", 2, "--cells-y", 2, "--cells-z", 2)
WHOLE, PARTS = "cube.h5", "parts.h5"


def make_mesh(name, *options):
    mesh_tool("box", name, *BRICKS, *options)


def partition(name, output, parts=2):
    mesh_tool("partition", name, "--parts", parts, "--output", output, "--boundary", "bottom")


def run_of(name):
    return [DECK, *settings(f"Mesh/File/File Name={name}")]


def change_rows(name, dataset, change):
    with h5py.File(name, "r+") as file:
        file[dataset][...] = change(file[dataset][()])


def swap_two_vertices(cells, cell=7):
    cells[cell, 1:3] = cells[cell, 2:0:-1]
    return cells


class SolidCase(Case):
    def setUp(self):
        super().setUp()
        make_mesh(WHOLE)
        partition(WHOLE, PARTS)

    def refuse(self, name, *pieces, changes=()):
        """With the mesh of that file, on two ranks."""
        self.assert_refused([*run_of(name), *settings(*changes)], *pieces, ranks=2)


class Meshes(SolidCase):
    def test_good_files(self):
        for name in (WHOLE, PARTS):
            self.assert_done(*run_of(name), "--output", f"results_{name}", ranks=2)

    def test_tetrahedron_turned_over(self):
        change_rows(WHOLE, "cells", swap_two_vertices)
        self.refuse(WHOLE, WHOLE, "cell 7 ", "inverted")
        change_rows(PARTS, "cells/values", swap_two_vertices)
        self.refuse(PARTS, PARTS, "'/cells'")

    def test_fault_facet_inside_the_body(self):
        inside = self.facet_inside()

        def put_inside(facets):
            facets[3] = inside
            return facets
        change_rows(WHOLE, "boundaries/bottom/facets", put_inside)
        self.refuse(WHOLE, WHOLE, "'bottom'", "inside the body")
        change_rows(PARTS, "boundaries/bottom/facets/values", put_inside)
        self.refuse(PARTS, PARTS, "bottom/facets'")

    @staticmethod
    def facet_inside():
        """Vertices of the first facet that two cells share."""
        with h5py.File(WHOLE) as file:
            cells = numpy.sort(file["cells"][()], axis=1)
        facets = numpy.concatenate([numpy.delete(cells, corner, axis=1) for corner in range(4)])
        facets, counts = numpy.unique(facets, axis=0, return_counts=True)
        return facets[counts == 2][0]

    def test_cell_of_a_vertex_that_is_not_there(self):
        def beyond(cells):
            cells[-1, -1] = 27
            return cells
        change_rows(WHOLE, "cells", beyond)
        self.refuse(WHOLE, WHOLE, "cell 47 ", "27")

    def test_in_the_plane(self):
        mesh_tool("rectangle", "square.h5", "--cells-x", 3, "--cells-y", 3)
        self.refuse("square.h5", "Asperity / Bulk / Model")
        self.refuse(WHOLE, "Asperity / Bulk / Model", changes=["Bulk/Model=Plane Strain"])


class PartitionedMeshes(SolidCase):
    def test_for_another_number_of_ranks(self):
        partition(WHOLE, "three.h5", parts=3)
        self.refuse("three.h5", "for 3 ranks", "asperity-mesh partition ", "three.h5 --parts 2 ")
        self.assert_refused(run_of("three.h5"), "for 3 ranks", "--parts 1 ")

    def test_an_array_of_another_mesh(self):
        make_mesh("other.h5", "--width", 2)
        partition("other.h5", "other_parts.h5")
        for array in ("vertices", "cells", "global_ids", "boundaries/bottom/facets", "num_owned"):
            with self.subTest(array):
                shutil.copy(PARTS, "mixed.h5")
                with h5py.File("mixed.h5", "r+") as mixed, h5py.File("other_parts.h5") as other:
                    del mixed[array]
                    other.copy(array, mixed[array.rpartition("/")[0] or "/"],
                               name=array.rpartition("/")[2])
                self.refuse("mixed.h5", "mixed.h5", f"'/{array}'", "Partition the mesh again")

    def test_an_array_that_is_not_there(self):
        with h5py.File(PARTS, "r+") as file:
            del file["boundaries/bottom/facets"]
        self.refuse(PARTS, PARTS, "boundaries/bottom/facets")

    def test_parts_in_another_order(self):
        def turn_round(rows):
            return rows[::-1]
        change_rows(PARTS, "cells/checksums", turn_round)
        self.refuse(PARTS, PARTS, "'/cells'")


class Faults(SolidCase):
    def test_a_tip_on_the_boundary(self):
        triangle = "abs(x - 0.5) < 1e-6 && y < 0.6 && z > 0.4 && z - y < 0.6"
        self.refuse(WHOLE, "Asperity / Mesh: a tip of fault 'main' lies on the boundary",
                    changes=[f"Mesh/Faults/main={triangle}"])

    def test_of_a_partitioned_mesh(self):
        self.refuse(PARTS, "Asperity / Mesh / Faults / main", PARTS, "is partitioned",
                    changes=["Mesh/Faults/main=abs(x - 0.5) < 1e-6"])

    def test_parts_of_the_version_before(self):
        with h5py.File(PARTS, "r+") as file:
            file.attrs["version"] = 1
        self.refuse(PARTS, PARTS, "version 1", "asperity-mesh partition MESH.h5 --parts 2")


class TruncatedFiles(SolidCase):
    def test_truncated(self):
        for name in (WHOLE, PARTS):
            content = pathlib.Path(name).read_bytes()
            for size in (0, 40, len(content) // 4, len(content) // 2, len(content) - 1):
                with self.subTest(name, size=size):
                    pathlib.Path("damaged.h5").write_bytes(content[:size])
                    self.refuse("damaged.h5", "damaged.h5")

    def test_missing(self):
        self.refuse("none.h5", "none.h5", "not exist")


class Conditions(SolidCase):
    def test_unknown_boundary(self):
        for name in (WHOLE, PARTS):
            with self.subTest(name):
                self.refuse(name, "Asperity / Boundary Conditions / Fault / Boundary = 'botom'",
                            "Did you mean 'bottom'?",
                            changes=["Boundary Conditions/Fault/Boundary=botom"])

    def test_condition_that_holds_nowhere(self):
        for name in (WHOLE, PARTS):
            with self.subTest(name):
                self.refuse(name, "Asperity / Mesh / Boundaries / patch",
                            changes=["Mesh/Boundaries/patch=x > 2"])

    def test_contradiction_at_an_edge(self):
        for name in (WHOLE, PARTS):
            with self.subTest(name):
                self.refuse(name, "Asperity / Boundary Conditions", "contradicts", "Drive", "Wall",
                            changes=["Boundary Conditions/Drive/Direction={0, 0, 1}"])

    def test_receiver_outside_the_body(self):
        receivers = "Output/Receivers/On Fault/"
        for name in (WHOLE, PARTS):
            with self.subTest(name):
                self.refuse(name, "Asperity / Output / Receivers / On Fault / middle",
                            changes=[receivers + "middle={0.5, 0, 1.5}"])
                self.refuse(name, "Asperity / Output / Receivers / On Fault / middle",
                            changes=[receivers + "middle={0.5, 0.5, 0.5}"])


if __name__ == "__main__":
    unittest.main()
