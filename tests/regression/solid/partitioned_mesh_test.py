"""A mesh in space that is partitioned for 8 ranks, then for 2 by one command, and run on them."""

import pathlib
import unittest

import asperity_run
import runs
import wedge_runs
from comparisons import largest_errors
from mesh_files import mesh_tool

WEDGE = ("--cell-size", 0.03, "--growth-factor", 1.5, "--depth", 0.06, "--layers", 3, "--periodic")
RUN = [*wedge_runs.RUPTURE, *wedge_runs.PERIODIC,
       *wedge_runs.settings("Time Stepping/Final Time=0.03")]
PIECES = ["--overlay", wedge_runs.HERE / "pieces_of_base.xml"]


class PartitionedMesh(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        mesh_tool("wedge", "whole.h5", *WEDGE, "--overwrite")
        mesh_tool("partition", "whole.h5", "--parts", 8, "--boundary", "base", "--output",
                  "eight.h5", "--overwrite")
        mesh_tool("partition", "eight.h5", "--parts", 2, "--output", "two.h5", "--overwrite")

    def run_file(self, name, *changes, ranks=1):
        return wedge_runs.run_deck(f"run_of_{name}", *RUN, *wedge_runs.from_file(f"{name}.h5"),
                                   *changes, ranks=ranks)

    def assert_same_fields(self, expected, found):
        for field, error in largest_errors(expected, found).items():
            self.assertLess(error, 1e-8, field)

    def test_runs_as_the_whole_mesh(self):
        whole = self.run_file("whole")
        rate = asperity_run.series(whole / "fault.h5")["fields/slip_rate"]
        self.assertGreater(rate.max(), 1e-3)
        self.assert_same_fields(whole, self.run_file("two", ranks=2))

    def test_pieces_of_the_boundary(self):
        whole = self.run_file("whole", *PIECES)
        places = asperity_run.series(whole / "fault.h5")["geometry/coordinates"]
        self.assertLess(places[:, 0].max(), 0.8)  # the base goes on to 1.04
        self.assert_same_fields(whole, self.run_file("two", *PIECES, ranks=2))

    def test_eight_parts_on_two_ranks_are_refused(self):
        result = asperity_run.run(wedge_runs.DECK, *RUN, *wedge_runs.from_file("eight.h5"),
                                  "--output", "refused", ranks=2)
        message = runs.assert_one_message(self, result, runs.INPUT)
        command = message.partition("asperity-mesh ")[2].split()
        mesh = str(pathlib.Path("eight.h5").resolve())
        self.assertEqual(command[:4], ["partition", mesh, "--parts", "2"])
        mesh_tool(*command, "--overwrite")
        self.assertEqual(asperity_run.run(wedge_runs.DECK, *RUN, "--validate", ranks=2,
                                          *wedge_runs.from_file(command[-1])).returncode, 0)


if __name__ == "__main__":
    unittest.main()
