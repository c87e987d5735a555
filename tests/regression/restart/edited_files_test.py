"""A run does not go on with a mesh or a dataset that was edited since its checkpoint."""

import pathlib
import shutil
import unittest

import h5py
import numpy

import asperity_run
import mesh_files
import runs
from asperity_run import settings

DECK = pathlib.Path(__file__).parent.parent / "bad_input" / "square.xml"
CELLS = 4  # along each side of the square
MESH = "Mesh/File/File Name"
LONGER = settings("Time Stepping/Final Time=0.6")


def vertex(i, j):
    return j * (CELLS + 1) + i


def write_mesh(name):
    steps = numpy.linspace(0, 1, CELLS + 1)
    sides = range(CELLS)
    cells = []
    for i in sides:
        for j in sides:
            low, high = vertex(i, j), vertex(i + 1, j + 1)
            cells += [[low, vertex(i + 1, j), high], [low, high, vertex(i, j + 1)]]
    facets = {"bottom": [[vertex(i, 0), vertex(i + 1, 0)] for i in sides],
              "right": [[vertex(CELLS, j), vertex(CELLS, j + 1)] for j in sides],
              "top": [[vertex(i + 1, CELLS), vertex(i, CELLS)] for i in sides],
              "left": [[vertex(0, j + 1), vertex(0, j)] for j in sides]}
    mesh_files.write(name, [[x, y] for y in steps for x in steps], cells, facets)


def write_dataset(name):
    with h5py.File(name, "w") as file:
        file["b"] = numpy.linspace(0.01, 0.012, (CELLS + 1) ** 2)


class EditedFiles(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.id().rpartition(".")[2])
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.mkdir()
        self.mesh, self.fields = self.folder / "mesh.h5", self.folder / "fields.h5"
        write_mesh(self.mesh)
        write_dataset(self.fields)

    def deck(self, mesh=None, fields=None):
        return [DECK, *settings("Mesh/Type=File", f"{MESH}={mesh or self.mesh}",
                                f"Friction/b={fields or self.fields}:/b")]

    def begin(self, ranks=1):
        asperity_run.run_to_end(self.folder / "results", *self.deck(), ranks=ranks)

    def go_on(self, deck):
        asperity_run.go_on(self.folder / "results", *deck, *LONGER)

    def assert_refused(self, *pieces, ranks=1):
        before = asperity_run.checksums(self.folder)
        results = self.folder / "results"
        result = asperity_run.run(*self.deck(), *LONGER, "--restart", results / "checkpoint.h5",
                                  "--output", results, ranks=ranks)
        runs.assert_one_message(self, result, runs.INPUT, "checkpoint.h5 belongs to another deck",
                                "has changed since then", *pieces)
        self.assertEqual(asperity_run.checksums(self.folder), before)

    def move_a_vertex(self):
        with h5py.File(self.mesh, "r+") as file:
            file["vertices"][vertex(2, 2), 0] += 1e-9

    def test_the_same_files(self):
        self.begin()
        self.go_on(self.deck())

    def test_copies_and_files_made_anew(self):
        self.begin()
        mesh = shutil.copy(self.mesh, self.folder / "copy.h5")
        fields = self.folder / "made_anew.h5"
        write_dataset(fields)
        self.go_on(self.deck(mesh, fields))

    def test_an_edited_mesh(self):
        self.begin()
        self.move_a_vertex()
        self.assert_refused(f"mesh file '{self.mesh.absolute()}'",
                            "Asperity / Mesh / File / File Name")

    def test_an_edited_mesh_on_two_ranks(self):
        self.begin(ranks=2)
        self.move_a_vertex()
        self.assert_refused(f"mesh file '{self.mesh.absolute()}'", ranks=2)

    def test_an_edited_dataset(self):
        self.begin()
        with h5py.File(self.fields, "r+") as file:
            file["b"][3] += 1e-12
        self.assert_refused(f"dataset '{self.fields.absolute()}:/b'", "Asperity / Friction / b")


if __name__ == "__main__":
    unittest.main()
