"""The figure of a mesh file: a map and a section through cells and faults."""

import unittest
from itertools import permutations
from pathlib import Path

import h5py
import numpy as np

from asperity.errors import InputError
from asperity_plot import cli, mesh
from folders import SharedFolderCase, told

NUM_X, NUM_Y, NUM_Z = 6, 4, 3
FAULT_DEPTH = 2.0


def write_box(path: Path, up: int = 2) -> None:
    """[0, 6] x [0, 4] x [-3, 0] km of unit cubes, each cut into six cells; the fault is at x = 3
    km, for y from 1 to 3 km, down to a depth of 2 km."""
    def number(i: int, j: int, k: int) -> int:
        return (i * (NUM_Y + 1) + j) * (NUM_Z + 1) + k

    nodes = [(i, j, k) for i in range(NUM_X + 1) for j in range(NUM_Y + 1)
             for k in range(NUM_Z + 1)]
    cells = []
    for corner in np.ndindex(NUM_X, NUM_Y, NUM_Z):
        for order in permutations(range(3)):
            path_of_cell = [np.array(corner)]
            for axis in order:
                path_of_cell.append(path_of_cell[-1] + np.eye(3, dtype=int)[axis])
            cells.append([number(*place) for place in path_of_cell])
    places = 1e3 * np.array(nodes, dtype=float) - [0.0, 0.0, 3e3]
    grid, cells = np.array(nodes), np.array(cells)
    faces = np.unique(np.sort(np.concatenate([cells[:, f] for f in mesh.FACES]), axis=1), axis=0)
    of_fault = faces[np.all((grid[faces][:, :, 0] == 3) & (abs(grid[faces][:, :, 1] - 2) <= 1)
                            & (grid[faces][:, :, 2] >= NUM_Z - FAULT_DEPTH), axis=1)]
    ground = faces[np.all(grid[faces][:, :, 2] == NUM_Z, axis=1)]
    bottom = faces[np.all(grid[faces][:, :, 2] == 0, axis=1)]
    if up == 1:
        places = places[:, [0, 2, 1]] * [1.0, 1.0, -1.0]
    with h5py.File(path, "w") as file:
        file.attrs["format"] = "asperity-mesh"
        file["vertices"], file["cells"] = places, cells
        for name, facets in (("rift", of_fault), ("top", ground), ("bottom", bottom)):
            file[f"boundaries/{name}/facets"] = facets


def lines(panel, label: str) -> np.ndarray:
    """(lines, 2, 2) of all collections with this label; '' for those without one."""
    found = [np.array(each.get_segments()) for each in panel.collections
             if each.get_label() == label or (not label and each.get_label().startswith("_"))]
    return np.concatenate(found)


def total(segments: np.ndarray) -> float:
    return float(np.linalg.norm(segments[:, 1] - segments[:, 0], axis=1).sum())


class MeshFigure(SharedFolderCase):
    def test_section_across_the_fault(self):
        for up in ("z", "y"):
            path = self.folder / f"box_{up}.h5"
            write_box(path, "xyz".index(up))
            chart, cut = mesh.draw(path, up).axes
            # The fault is cut down to its depth, at one distance along the section, which is x.
            fault = lines(cut, "rift")
            self.assertAlmostEqual(total(fault), FAULT_DEPTH, 6)
            self.assertLess(np.ptp(fault[:, :, 0]), 1e-9)
            self.assertAlmostEqual(fault[:, :, 1].min(), -FAULT_DEPTH, 6)
            # The body is cut from wall to wall and from the bottom to the ground.
            self.assertAlmostEqual(float(np.ptp(lines(cut, "")[:, :, 0])), NUM_X, 6)
            self.assertAlmostEqual(float(np.ptp(lines(cut, "")[:, :, 1])), NUM_Z, 6)
            self.assertIn("azimuth 90", cut.get_title())
            # On the map the border of an upright fault is its trace, there and back.
            self.assertAlmostEqual(np.ptp(lines(chart, "rift")[:, :, 1]), 2.0, 6)
            self.assertAlmostEqual(np.ptp(lines(chart, "rift")[:, :, 0]), 0.0, 6)

    def test_file_beside_the_mesh(self):
        write_box(self.folder / "shown.h5")
        status, out, err = told(cli.main, str(self.folder / "shown.h5"), "--dpi", "40")
        self.assertEqual((status, err), (0, ""))
        picture = self.folder / "shown.png"
        self.assertEqual(out.strip(), str(picture))
        self.assertTrue(picture.read_bytes().startswith(b"\x89PNG"))

    def test_other_files_are_refused(self):
        with h5py.File(self.folder / "parts.h5", "w") as file:
            file.attrs["format"] = "asperity-partition"
        with self.assertRaisesRegex(InputError, "before it was divided"):
            mesh.draw(self.folder / "parts.h5")
        with h5py.File(self.folder / "plane.h5", "w") as file:
            file.attrs["format"] = "asperity-mesh"
            file["cells"] = [[0, 1, 2]]
        with self.assertRaisesRegex(InputError, "in the plane"):
            mesh.draw(self.folder / "plane.h5")


if __name__ == "__main__":
    unittest.main()
