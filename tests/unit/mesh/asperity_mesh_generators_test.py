"""asperity-mesh, given as the first argument: makes wedges, rectangles, boxes and describes them.

The files it makes are read with h5py, which knows nothing of the program that wrote them.
"""

import pathlib
import unittest

import h5py
import numpy

import mesh_tool


class PlaneMeshes(mesh_tool.Case):
    def test_wedge(self):
        self.assert_done("wedge", "wedge.h5")
        info = self.assert_done("info", "wedge.h5")
        self.assertIn("area             0.135 m^2\n", info)
        self.assertIn("cell diameters   0.0010115", info)
        self.assertRegex(info, r"boundary +base: 261 facets, 262 vertices")
        self.assertRegex(info, r"region +lower: \d+ cells")

    def test_wedge_options(self):
        self.assert_done("wedge", "small.h5", "--cell-size", "0.05", "--viscous-thickness", "0")
        with h5py.File("small.h5") as file:
            self.assertLess(len(file["vertices"]), 150)
            self.assertEqual(list(file["region_names"].asstr()), ["upper"])
        self.assert_refused(["wedge", "a.h5", "--cell-size", "-1"], "Cell Size = -1")
        self.assert_refused(["wedge", "a.h5", "--cell-size", "two"], "--cell-size", "'two'")
        self.assert_refused(["wedge", "a.h5", "--cell-size"], "needs a value")
        self.assert_refused(["wedge", "a.h5", "--cell-sise", "1"], "Did you mean '--cell-size'?")
        self.assert_refused(["wedge"], "OUT.h5 is missing")
        self.assertFalse(pathlib.Path("a.h5").exists())

    def test_rectangle(self):
        self.assertIn("6 vertices, 4 cells",
                      self.assert_done("rectangle", "plain.h5", "--cells-x", "2"))
        self.assert_done("rectangle", "graded.h5", "--width", "1600", "--height", "3200",
                         "--cells-y", "2", "--left", "-800", "--bottom", "-3200",
                         "--cell-size", "100 + 0.2 * (x + 800)")
        info = self.assert_done("info", "graded.h5")
        self.assertIn("bounding box     [-800, 800] x [-3200, 0] m\n", info)
        self.assertRegex(info, r"smallest angle   45 degrees at \(.*\) m\n")
        self.assertRegex(info, r"shortest edge    [0-9.]+ m at \(-[0-9.]+, .*\) m\n")
        self.assertIn("left: 32 facets, 33 vertices, shortest edge 100 m\n", info)
        self.assertIn("right: 8 facets, 9 vertices, shortest edge 400 m\n", info)

    def test_bricks_keep_their_proportions(self):
        """As in a deck, where the cell size is that of the longest side."""
        flat = ["--width", "4", "--height", "1", "--cells-x", "2", "--cells-y", "2",
                "--cell-size", "0.25"]
        self.assertIn(f"{17**2} vertices", self.assert_done("rectangle", "flat.h5", *flat))
        self.assertIn(f"{17**3} vertices", self.assert_done("box", "box.h5", *flat, "--depth", "4",
                                                            "--cells-z", "2"))

    def test_rectangle_refuses(self):
        for options, pieces in ((["--width", "0"], ["Width = 0"]),
                                (["--cells-x", "2.5"], ["--cells-x", "'2.5'", "whole number"]),
                                (["--cell-size", "t + 1"], ["--cell-size depends on t"]),
                                (["--cell-size", "x - 0.5"], ["--cell-size is -0.5 at", "(0, 0)"]),
                                (["--cell-size", "x +"], ["--cell-size", "no valid expression"])):
            self.assert_refused(["rectangle", "a.h5", *options], *pieces)
        self.assertFalse(pathlib.Path("a.h5").exists())

    def test_faults(self):
        self.assert_done("rectangle", "split.h5", "--width", "4", "--height", "4", "--cells-x", "4",
                         "--cells-y", "4", "--fault", "main=abs(y - 2) < 1e-6 && x < 3.5",
                         "--fault", "splay=x == 1 && y > 1.5")
        info = self.assert_done("info", "split.h5")
        self.assertIn("vertices         32, 7 of them copies at faults\n", info)
        self.assertIn("fault            main: 3 facets, 4 vertices, 1 tip, ", info)
        self.assertIn("fault            splay: 2 facets, 3 vertices, 1 tip, ", info)
        for option, kind in (([], 1), (["--antiplane"], 2)):  # the end of the splay: a tip, a joint
            self.assert_done("partition", "split.h5", "--parts", "2", "--output", "two.h5",
                             "--overwrite", *option)
            with h5py.File("two.h5") as file:
                kinds = file["splits/values"][:, 2]
            self.assertEqual(set(kinds.tolist()), {0, 1, kind})
        self.assert_refused(["partition", "two.h5", "--parts", "1", "--output", "one.h5",
                             "--antiplane"], "--antiplane needs a whole mesh", "'two.h5'")
        self.assert_done("box", "split_box.h5", "--cells-x", "2", "--cells-y", "2",
                         "--cells-z", "2", "--fault", "main=abs(z - 0.5) < 1e-6")
        info = self.assert_done("info", "split_box.h5")
        self.assertIn("fault            main: 8 facets, 9 vertices, 0 tips, ", info)

    def test_faults_that_are_refused(self):
        def refused(condition, *pieces):
            self.assert_refused(["rectangle", "a.h5", "--cells-x", "2", "--cells-y", "2",
                                 "--fault", condition], *pieces)
            self.assertFalse(pathlib.Path("a.h5").exists())
        refused("main=x == 0.3", "Option --fault / main: the fault has no facet")
        refused("net=1", "Option --fault", "facets of fault 'net' meet at")
        refused("top=x == 0.5", "Option --fault / top: a boundary on the surface")
        refused("main=x == 0.5 && t > 1", "Option --fault main depends on t")
        refused("main=x ==", "Option --fault main")
        refused("x == 0.5", "Option --fault x", "single =")
        refused("0.5", "not of the form NAME=CONDITION")

    def test_info_of_bad_files(self):
        self.assert_refused(["info", "none.h5"], "'none.h5' does not exist")
        pathlib.Path("text.h5").write_text("This is no HDF5 file.")
        self.assert_refused(["info", "text.h5"], "cannot be opened as an HDF5 file")


class SolidMeshes(mesh_tool.Case):
    def test_box(self):
        self.assertIn("12 vertices, 12 cells",
                      self.assert_done("box", "plain.h5", "--cells-x", "2"))
        self.assert_done("box", "graded.h5", "--width", "1600", "--height", "3200", "--depth",
                         "1600", "--cells-y", "2", "--left", "-800", "--bottom", "-3200",
                         "--cell-size", "100 + 0.4 * (x + 800)")
        info = self.assert_done("info", "graded.h5")
        self.assertIn("bounding box     [-800, 800] x [-3200, 0] x [0, 1600] m\n", info)
        self.assertIn("volume           8.192e+09 m^3\n", info)
        self.assertRegex(info, r"smallest angle   45 degrees at \(.*\) m\n")
        self.assertIn("left: 1024 facets, 561 vertices, shortest edge 100 m\n", info)

    def test_periodic_box(self):
        self.assert_done("box", "box.h5", "--cells-x", "3", "--cells-z", "4", "--depth", "2",
                         "--periodic", "x, z", "--cell-size", "0.2 + y")
        with h5py.File("box.h5") as file:
            self.assertEqual(list(file.attrs["period"]), [1, 0, 2])
            self.assertEqual(set(file["boundaries"]), {"bottom", "top"})
            vertices = file["vertices"][:]
        self.assertLess(vertices[:, 0].max(), 1)
        self.assertLess(vertices[:, 2].max(), 2)
        info = self.assert_done("info", "box.h5")
        self.assertIn("period along z   2 m\n", info)
        self.assertIn("volume           2 m^3\n", info)

    def test_box_refuses(self):
        for options, pieces in ((["--depth", "0"], ["Depth = 0"]),
                                (["--cells-z", "-1"], ["Cells Z = -1"]),
                                (["--periodic", "y"], ["'bottom' and 'top'", "At least 3 cells"]),
                                (["--periodic", "u"], ["--periodic", "'u' is not x, y or z"]),
                                (["--cell-size", "z - 0.5"], ["(x, y, z) = (0, 0, 0)"])):
            self.assert_refused(["box", "a.h5", *options], *pieces)
        self.assertFalse(pathlib.Path("a.h5").exists())

    def test_wedge_with_depth(self):
        wedge = ["--cell-size", "0.03", "--depth", "0.6"]
        sizes = {}
        for name, options in {"whole": [], "patches": ["--patches", "0 to 0.1, 0.5 to 0.6"],
                              "layers": ["--layers", "6"]}.items():
            self.assert_done("wedge", f"{name}.h5", *wedge, *options)
            with h5py.File(f"{name}.h5") as file:
                self.assertEqual(set(file["boundaries"]),
                                 {"back", "base", "front", "right", "surface"})
                sizes[name] = len(file["vertices"])
                levels = numpy.unique(file["vertices"][:, 2])
            info = self.assert_done("info", f"{name}.h5")
            self.assertIn("volume           0.081 m^3\n", info)
        numpy.testing.assert_allclose(levels, numpy.linspace(0, 0.6, 7), rtol=0, atol=1e-15)
        self.assertLess(sizes["patches"], 0.6 * sizes["whole"])

    def test_periodic_wedge(self):
        for options in (["--layers", "4"], ["--patches", "0 to 0.05"]):
            self.assert_done("wedge", "wedge.h5", "--overwrite", "--cell-size", "0.03", "--depth",
                             "0.2", "--periodic", *options)
            with h5py.File("wedge.h5") as file:
                self.assertEqual(list(file.attrs["period"]), [0, 0, 0.2])
                self.assertEqual(set(file["boundaries"]), {"base", "right", "surface"})
            self.assertIn("volume           0.027 m^3\n", self.assert_done("info", "wedge.h5"))

    def test_wedge_with_depth_refuses(self):
        for options, pieces in ((["--depth", "-1"], ["Depth = -1"]),
                                (["--layers", "3"], ["--layers needs --depth"]),
                                (["--depth", "1", "--layers", "0"], ["Layers = 0"]),
                                (["--depth", "1", "--layers", "2", "--periodic"], ["At least 3"]),
                                (["--depth", "1", "--layers", "2", "--patches", "0 to 1"],
                                 ["--patches cannot be combined with --layers"]),
                                (["--depth", "1", "--patches", "0 to 1, 2"], ["--patches: '2'"]),
                                (["--depth", "1", "--patches", "0 to 2"],
                                 ["from 0 to 2 m does not lie within"])):
            self.assert_refused(["wedge", "a.h5", "--cell-size", "0.1", *options], *pieces)
        self.assertFalse(pathlib.Path("a.h5").exists())


if __name__ == "__main__":
    unittest.main()
