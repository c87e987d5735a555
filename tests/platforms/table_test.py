"""What table.py reads from logs and writes into a page."""

import json
import pathlib
import unittest

import table

VERSION = """Asperity 0.1.0 on Serial, 1 rank.
Kokkos 3.4.1, Trilinos 13.2, Open MPI v5.0.7.
Built from an archive, GNU 14.2.0, Release, HDF5 1.14.5, Eigen 3.4.0.
"""
TESTS = """      Start 1: unit.a
99% tests passed, 1 tests failed out of 218

Label Time Summary:
unit    = 1.00 sec*proc (200 tests)

The following tests did not run:
\t 11 - style.format (Disabled)
\t 12 - unit.io.Xdmf (Skipped)

The following tests FAILED:
\t199 - unit.x_MPI_2 (Failed)
Errors while running CTest
"""
PAGE = """# Platforms

| release | compiler |
|---|---|
| Debian sid | old |
| Debian 12 (bookworm) | old |

Text.
"""


class Table(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path("trixie")
        self.folder.mkdir(exist_ok=True)
        for path in self.folder.iterdir():
            path.unlink()

    def row(self, cached=False, **logs):
        for name, text in logs.items():
            (self.folder / f"{name}.log").write_text(text)
        table.write_row(self.folder, 300, 900, cached)
        return json.loads((self.folder / "row.json").read_text())

    def test_a_row(self):
        row = self.row(version=VERSION, test=TESTS)
        self.assertEqual(row, {
            "suite": "trixie", "compiler": "GNU 14.2.0", "trilinos": "13.2", "kokkos": "3.4.1",
            "mpi": "5.0.7", "hdf5": "1.14.5", "passed": 216, "of": 218,
            "others": {"style.format": "Disabled", "unit.io.Xdmf": "Skipped",
                       "unit.x_MPI_2": "Failed"},
            "run_seconds": 300, "test_seconds": 900})
        self.assertEqual(table.line_of(row), "| Debian 13 (trixie) | g++ 14.2.0 | 13.2 | 3.4.1 | "
                         "Open MPI 5.0.7 | 1.14.5 | 216 of 218 | `style.format` (disabled), "
                         "`unit.io.Xdmf` (skipped), `unit.x_MPI_2` (failed) | 300 | 900 |")

    def test_the_last_summary_counts(self):
        inner = TESTS.replace("out of 218", "out of 11").replace("unit.x_MPI_2", "unit.y_MPI_1")
        self.assertEqual(table.test_row(inner + TESTS), table.test_row(TESTS))

    def test_a_tree_that_does_not_know_its_commit(self):
        row = self.row(version=VERSION.replace("an archive, ", ""))
        self.assertEqual(row["compiler"], "GNU 14.2.0")

    def test_a_row_of_what_was_not_built(self):
        row = self.row(run="CMake Error")
        self.assertIn("| ? | ? | ? |", table.line_of(row))
        self.assertIn("| not built |", table.line_of(row))

    def test_seconds_with_a_cache_are_left_out(self):
        row = self.row(version=VERSION, test=TESTS, cached=True)
        self.assertNotIn("run_seconds", row)
        self.assertTrue(table.line_of(row).endswith("|  |  |"))

    def test_a_page(self):
        rows = [self.row(version=VERSION, test=TESTS),
                {**self.row(version=VERSION), "suite": "sid"}]
        lines = table.page_with(PAGE, rows).splitlines()
        self.assertEqual(lines[:4] + lines[7:], PAGE.splitlines()[:4] + ["", "Text."])
        self.assertEqual(lines[4], "| Debian 12 (bookworm) | old |")
        self.assertEqual(lines[5], table.line_of(rows[0]))
        self.assertEqual(lines[6], table.line_of(rows[1]))
        self.assertEqual(table.page_with(table.page_with(PAGE, rows), rows),
                         table.page_with(PAGE, rows))


if __name__ == "__main__":
    unittest.main()
