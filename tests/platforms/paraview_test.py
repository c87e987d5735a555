"""ParaView's readers of XDMF, and meshio, show what the .h5 files of a run hold: in the plane and
in space, on the fault and in the body, on two ranks, and after a restart.

Exit status 77 without pvpython."""

import pathlib
import pickle
import shutil
import subprocess
import sys
import unittest

import asperity_run
import numpy

TESTS = asperity_run.SOURCE / "tests"
STRESS = TESTS / "verification" / "stress"
SINGLE = "Output/Volume Snapshots/Precision=Single"
WEDGE = (asperity_run.SOURCE / "xml" / "wedge_2d.xml", *asperity_run.settings(
    "Mesh/Wedge/Cell Size=0.006", "Time Stepping/Final Time=0.02",
    "Output/Volume Snapshots/Enabled=true", "Output/Volume Snapshots/Every n Steps=2",
    "Output/Surface History/Every n Steps=2", "Output/Fault History/Every n Steps=2"))
EVERY = asperity_run.settings("Output/Fault History/Every n Steps=1")


def end_early(deck, folder, time):
    asperity_run.run_to_end(folder, *deck, "--set", f"Time Stepping/Final Time={time}")


def runs():
    """The folders of the runs."""
    strip, box = ((STRESS / name, *EVERY) for name in ("strip.xml", "box.xml"))
    folders = [asperity_run.run_to_end("antiplane", *strip),
               asperity_run.run_to_end("plane", *WEDGE),
               asperity_run.run_to_end("plane_on_two", *WEDGE, ranks=2),
               asperity_run.run_to_end("space", *box),
               asperity_run.run_to_end("space_on_two", *box, "--set", SINGLE, ranks=2)]
    for name, deck in (("plane_restarted", WEDGE), ("space_restarted", box)):
        folder = pathlib.Path(name)
        end_early(deck, folder, {"plane_restarted": 0.01, "space_restarted": 0.2}[name])
        asperity_run.go_on(folder, *deck)
        folders.append(folder)
    return folders


def shown(field, names):
    """The arrays that a program is to show of a field (rows, points[, components])."""
    if field.ndim == 2:
        return {"": field}
    components = field.shape[2]
    if not names and components == 2:
        return {"": numpy.concatenate([field, numpy.zeros_like(field[:, :, :1])], axis=2)}
    if not names and components == 3:
        return {"": field}
    if components == 6:
        xx, xy, xz, yy, yz, zz = numpy.moveaxis(field, 2, 0)
        return {"": numpy.stack([xx, xy, xz, xy, yy, yz, xz, yz, zz], axis=2)}
    return {"_" + name: field[:, :, i] for i, name in enumerate(names)}


class Files:
    """What a history holds, as it should be shown."""

    def __init__(self, path):
        with asperity_run.h5py.File(path) as file:
            self.times = file["time"][()]
            self.points = file["geometry/coordinates"][()]
            whole = "geometry/whole_elements"
            self.cells = file[whole if whole in file else "geometry/connectivity"][()]
            self.fields = {"nodes": {}, "elements": {}}
            for name, field in file["fields"].items():
                names = field.attrs.get("components", "").split()
                for suffix, values in shown(field[()], names).items():
                    of_elements = field.attrs.get("centring") == "elements"
                    if of_elements:
                        values = values[:, :len(self.cells)]
                    self.fields["elements" if of_elements else "nodes"][name + suffix] = values


class EachReader(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.paths = [str(path) for folder in runs() for path in sorted(folder.glob("*.xdmf"))]
        result = subprocess.run(
            ["pvpython", "--no-mpi", str(pathlib.Path(__file__).parent / "paraview_reader.py"),
             "found.pickle", *cls.paths], capture_output=True, text=True, check=False)
        if result.returncode != 0:
            raise AssertionError(f"pvpython: {result.returncode}\n{result.stdout}{result.stderr}")
        cls.found = pickle.loads(pathlib.Path("found.pickle").read_bytes())

    def test_there_are_files_of_all_kinds(self):
        names = {pathlib.Path(path).name for path in self.paths}
        self.assertEqual(names, {"fault.xdmf", "surface.xdmf", "volume.xdmf"})
        self.assertGreaterEqual(len(self.paths), 20)
        for path in self.paths:
            self.assertGreater(len(Files(path.replace(".xdmf", ".h5")).times), 1, path)

    def test_shows_times_places_and_fields(self):
        for path, readers in self.found.items():
            expected = Files(path.replace(".xdmf", ".h5"))
            self.assertEqual(len(readers), 4)
            for reader, rows in readers.items():
                with self.subTest(path=path, reader=reader):
                    self.compare(expected, rows)

    def compare(self, expected, rows):
        self.assertEqual([time for time, _ in rows], expected.times.tolist())
        dimension = expected.points.shape[1]
        for row, (_, data) in enumerate(rows):
            numpy.testing.assert_array_equal(data["points"][:, :dimension], expected.points)
            self.assertFalse(data["points"][:, dimension:].any())
            self.assertEqual(data["cells"], expected.cells.tolist())
            for place, fields in expected.fields.items():
                self.assertEqual(set(data[place]), set(fields))
                for name, values in fields.items():
                    numpy.testing.assert_array_equal(data[place][name], values[row], err_msg=name)

    def test_meshio(self):
        try:
            import meshio
        except ImportError:
            self.skipTest("no meshio (Debian: python3-meshio)")
        for path in self.paths:
            expected = Files(path.replace(".xdmf", ".h5"))
            with meshio.xdmf.TimeSeriesReader(path) as reader:
                points, cells = reader.read_points_cells()
                numpy.testing.assert_array_equal(points, expected.points)
                numpy.testing.assert_array_equal(cells[0].data, expected.cells)
                self.assertEqual(reader.num_steps, len(expected.times))
                for row in range(reader.num_steps):
                    time, nodes, elements = reader.read_data(row)
                    self.assertEqual(time, expected.times[row])
                    found = {"nodes": nodes,
                             "elements": {name: values[0] for name, values in elements.items()}}
                    for place, fields in expected.fields.items():
                        self.assertEqual(set(found[place]), set(fields))
                        for name, values in fields.items():
                            numpy.testing.assert_array_equal(found[place][name], values[row])


if __name__ == "__main__":
    if shutil.which("pvpython") is None:
        print("skipped: there is no pvpython (Debian: paraview, python3-paraview)")
        sys.exit(77)
    unittest.main(verbosity=2)
