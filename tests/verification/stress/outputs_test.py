"""Stress and strain in the files of a run are what the displacement there says, by Hooke's law: on
two ranks, after a restart, for XDMF, and at receivers of a condensed body."""

import pathlib
import sys
import unittest
import xml.etree.ElementTree

import asperity_run
import h5py
import numpy

sys.path.insert(0, str(asperity_run.SOURCE / "python"))
import asperity  # noqa: E402  (the package of this source tree)

HERE = pathlib.Path(__file__).parent
STRIP, BOX = HERE / "strip.xml", HERE / "box.xml"
STATIC = "TNNMG/Static Condensation=Off"
TENSOR = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)]  # xx, xy, xz, yy, yz, zz


def gradients(file, elements):
    """(elements, components, dimension) of the displacement in the last row of a file."""
    corners = file["geometry/coordinates"][elements]
    u = file["fields/displacement"][-1]
    u = (u if u.ndim == 2 else u[:, None])[elements]
    return numpy.swapaxes(numpy.linalg.solve(corners[:, 1:] - corners[:, :1],
                                             u[:, 1:] - u[:, :1]), 1, 2)


def hooke(gradient, shear, poisson):
    """(elements, 6) from gradients (elements, 3, 3); shear (elements)."""
    strain = (gradient + numpy.swapaxes(gradient, 1, 2)) / 2
    lame = 2 * shear * poisson / (1 - 2 * poisson)
    trace = numpy.trace(strain, axis1=1, axis2=2)
    sigma = (lame * trace)[:, None, None] * numpy.eye(3) + 2 * shear[:, None, None] * strain
    return numpy.stack([sigma[:, i, k] for i, k in TENSOR], axis=1)


def inside(file, point):
    """The number of the element that has a point, and the point's weights at its corners.

    Elements that a periodic mesh wraps around are not looked at."""
    elements = file.get("geometry/whole_elements", file["geometry/connectivity"])
    corners = file["geometry/coordinates"][elements]
    weights = numpy.linalg.solve(numpy.swapaxes(corners[:, 1:] - corners[:, :1], 1, 2),
                                 (point - corners[:, 0])[..., None])[..., 0]
    found = numpy.flatnonzero((weights.min(axis=1) > 0) & (weights.sum(axis=1) < 1))
    assert found.size == 1, found
    weights = weights[found[0]]
    return found[0], numpy.concatenate(([1 - weights.sum()], weights))


class InSpace(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = asperity_run.run_to_end("box", BOX)
        cls.volume = asperity_run.series(cls.folder / "volume.h5")
        cls.whole = cls.volume["geometry/whole_elements"]

    def test_stress_is_that_of_the_displacement(self):
        self.assertLess(len(self.whole), len(self.volume["geometry/connectivity"]))
        numpy.testing.assert_array_equal(self.volume["geometry/connectivity"][:len(self.whole)],
                                         self.whole)
        gradient = gradients(self.volume, self.whole)
        places = self.volume["geometry/coordinates"][self.whole].mean(axis=1)
        expected = hooke(gradient, numpy.where(places[:, 0] < 0.5, 1e6, 3e6), 0.25)
        stress = self.volume["fields/stress"][-1]
        self.assertEqual(stress.shape[1], 6)
        scale = numpy.abs(expected).max()
        self.assertGreater(scale, 100)
        numpy.testing.assert_allclose(stress[:len(self.whole)], expected, rtol=0, atol=1e-9 * scale)
        strain = numpy.stack([(gradient[:, i, k] + gradient[:, k, i]) / 2 for i, k in TENSOR], 1)
        numpy.testing.assert_allclose(self.volume["fields/strain"][-1, :len(self.whole)], strain,
                                      rtol=0, atol=1e-9 * numpy.abs(strain).max())

    def test_coulomb_stress_change_is_that_of_the_traction_since_the_start(self):
        change = self.volume["fields/stress"] - self.volume["fields/stress"][0]
        sigma = numpy.zeros(change.shape[:2] + (3, 3))
        for component, (i, k) in enumerate(TENSOR):
            sigma[..., i, k] = sigma[..., k, i] = change[..., component]
        dip = numpy.radians(30)  # to +x; the hanging wall is above it and slips up to -x
        normal = numpy.array([numpy.sin(dip), numpy.cos(dip), 0])
        slip = numpy.array([-numpy.cos(dip), numpy.sin(dip), 0])
        expected = (slip + 0.4 * normal) @ sigma @ normal
        found = self.volume["fields/coulomb_stress_change_thrust"]
        self.assertTrue(numpy.all(found[0] == 0))
        self.assertGreater(numpy.abs(expected).max(), 1)
        numpy.testing.assert_allclose(found, expected, rtol=0,
                                      atol=1e-9 * numpy.abs(expected).max())

    def test_the_push_loads_a_thrust(self):
        """On average over the body, which is compressed along x."""
        self.assertGreater(self.volume["fields/coulomb_stress_change_thrust"][-1].mean(), 0)

    def test_of_the_surface_is_that_of_the_cell_below(self):
        surface = asperity_run.series(self.folder / "surface.h5")
        ids = surface["geometry/vertex_ids"][surface["geometry/connectivity"]]
        cells = [set(cell) for cell in self.volume["geometry/connectivity"].tolist()]
        for facet, stress in zip(ids.tolist(), surface["fields/stress"][-1]):
            below = [i for i, cell in enumerate(cells) if cell.issuperset(facet)]
            self.assertEqual(len(below), 1)
            numpy.testing.assert_array_equal(stress, self.volume["fields/stress"][-1, below[0]])

    def test_at_a_receiver_is_that_of_its_cell(self):
        receivers = asperity_run.series(self.folder / "receivers.h5")
        cell, _ = inside(self.volume, numpy.array([0.3, 0.45, 0.41]))
        numpy.testing.assert_allclose(receivers["off_fault/fields/stress"][-1, 0],
                                      self.volume["fields/stress"][-1, cell], rtol=1e-12)

    def test_on_two_ranks(self):
        other = asperity_run.run_to_end("box_on_two", BOX, ranks=2)
        for name in ("volume.h5", "surface.h5", "receivers.h5"):
            ours, theirs = (asperity_run.series(folder / name) for folder in (self.folder, other))
            for dataset, values in ours.items():
                if dataset.endswith(("stress", "strain", "thrust")):
                    scale = numpy.abs(values).max()
                    numpy.testing.assert_allclose(theirs[dataset], values, rtol=0,
                                                  atol=1e-7 * scale)
                elif dataset.startswith("geometry/") and "weights" not in dataset:
                    numpy.testing.assert_array_equal(theirs[dataset], values, dataset)

    def test_python_reads_components_and_centring(self):
        volume = asperity.Run(self.folder).volume
        self.assertEqual(volume.component_names("stress"), ["xx", "xy", "xz", "yy", "yz", "zz"])
        self.assertEqual(volume.component_names("displacement"), [])
        self.assertTrue(volume.is_of_elements("stress"))
        self.assertFalse(volume.is_of_elements("displacement"))
        self.assertEqual(volume["stress"].shape[1:], (len(volume.elements), 6))

    def test_xdmf_has_tensors_in_the_cells_that_it_draws(self):
        root = xml.etree.ElementTree.parse(self.folder / "volume.xdmf").getroot()
        drawn = int(root.find(".//Topology[@NumberOfElements]").get("NumberOfElements"))
        self.assertEqual(drawn, len(self.whole))
        grid = root.findall(".//Grid[@GridType='Uniform']")[-1]
        kinds = {item.get("Name"): (item.get("AttributeType"), item.get("Center"))
                 for item in grid.findall("Attribute")}
        self.assertEqual(kinds, {"displacement": ("Vector", "Node"), "stress": ("Tensor", "Cell"),
                                 "strain": ("Tensor", "Cell"),
                                 "coulomb_stress_change_thrust": ("Scalar", "Cell")})
        xx, xy, xz, yy, yz, zz = self.volume["fields/stress"][-1, :drawn].T
        numpy.testing.assert_array_equal(self.read(grid, "stress"), numpy.transpose(
            [xx, xy, xz, xy, yy, yz, xz, yz, zz]))

    def read(self, grid, name):
        """What a reader of XDMF takes for an attribute."""
        item = grid.find(f"Attribute[@Name='{name}']/DataItem")
        path, dataset = item.text.split(":")
        with h5py.File(self.folder / path) as file:
            values = file[dataset][()]
        self.assertEqual(values.shape, tuple(map(int, item.get("Dimensions").split())))
        return values


class Condensed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = asperity_run.run_to_end("condensed", STRIP)

    def test_receivers_are_those_of_the_whole_body(self):
        whole = asperity_run.run_to_end("whole", STRIP, *asperity_run.settings(STATIC))
        self.assertIn("products give the motion of the body at them",
                      (self.folder / "run.log").read_text())
        self.assertNotIn("products give the motion of the body at them",
                         (whole / "run.log").read_text())
        ours, theirs = (asperity_run.series(folder / "receivers.h5")
                        for folder in (self.folder, whole))
        # Not the velocity: the whole body starts at rest inside, which its scheme damps slowly.
        for name in ("displacement", "stress", "coulomb_stress_change_upright"):
            expected = theirs[f"off_fault/fields/{name}"]
            numpy.testing.assert_allclose(ours[f"off_fault/fields/{name}"], expected, err_msg=name,
                                          rtol=0, atol=1e-9 * numpy.abs(expected).max())

    def test_receivers_are_those_of_the_recovered_volume(self):
        """By rows for the points, and by the whole body, in one run."""
        volume, receivers = (asperity_run.series(self.folder / name)
                             for name in ("volume.h5", "receivers.h5"))
        rows = numpy.isin(receivers["time"], volume["time"])
        for i, place in enumerate(receivers["off_fault/coordinates"]):
            cell, weights = inside(volume, place)
            nodes = volume["geometry/connectivity"][cell]
            for name in ("displacement", "velocity"):
                expected = volume[f"fields/{name}"][:, nodes] @ weights
                numpy.testing.assert_allclose(
                    receivers[f"off_fault/fields/{name}"][rows, i], expected, rtol=0,
                    atol=1e-12 * numpy.abs(volume[f"fields/{name}"]).max(), err_msg=name)
            expected = volume["fields/stress"][:, cell]
            numpy.testing.assert_allclose(receivers["off_fault/fields/stress"][rows, i], expected,
                                          rtol=0, atol=1e-12 * numpy.abs(expected).max())

    def test_many_receivers_recover_the_whole_body(self):
        places = asperity_run.settings(*(
            f"Output/Receivers/Off Fault/r{i}={{{0.02 + 0.05 * (i % 10)}, "
            f"{0.02 + 0.05 * (i // 10)}}}" for i in range(100)))
        folder = asperity_run.run_to_end("many", STRIP, *places)
        self.assertIn("Choose fewer receivers", (folder / "run.log").read_text())
        ours, theirs = (asperity_run.series(of / "receivers.h5") for of in (self.folder, folder))
        names = list(theirs["off_fault/names"])
        for i, name in enumerate(ours["off_fault/names"]):
            for field in ("displacement", "stress"):
                expected = ours[f"off_fault/fields/{field}"][:, i]
                found = theirs[f"off_fault/fields/{field}"][:, names.index(name)]
                numpy.testing.assert_allclose(found, expected, rtol=0,
                                              atol=1e-12 * numpy.abs(expected).max())

    def test_a_restart_goes_on_bit_for_bit(self):
        folder = pathlib.Path("stopped")
        asperity_run.run_to_end(folder, STRIP, "--set", "Time Stepping/Final Time=0.6")
        asperity_run.go_on(folder, STRIP)
        for name in ("volume.h5", "receivers.h5"):
            ours, theirs = (asperity_run.series(of / name) for of in (self.folder, folder))
            # The first part has a row at its end.
            rows = numpy.isin(theirs["time"], ours["time"])
            for dataset in filter(lambda path: "fields/" in path, ours):
                numpy.testing.assert_array_equal(theirs[dataset][rows], ours[dataset], dataset)


class Planes(unittest.TestCase):
    def test_one_that_no_output_writes_is_told(self):
        changes = asperity_run.settings(
            {"Output/Volume Snapshots/Fields": "{stress}",
             "Output/Receivers/Body Fields": "{stress}", "Time Stepping/Final Time": 0.1})
        result = asperity_run.run(STRIP, "--output", "unwritten", "--overwrite", *changes)
        self.assertEqual(result.returncode, 0, result.stderr)
        self.assertIn("Coulomb Planes / upright is not written: no Fields name "
                      "coulomb_stress_change_upright.", result.stdout)


class Refusals(unittest.TestCase):
    def refused(self, deck, *changes):
        result = asperity_run.run(deck, "--validate", *asperity_run.settings(*changes))
        self.assertEqual(result.returncode, 2, result.stdout)
        return result.stderr

    def test_planes_that_do_not_fit(self):
        planes = "Output/Coulomb Planes/"
        self.assertIn("4: strike, dip, rake", self.refused(BOX, planes + "thrust={0, 30, 90}"))
        self.assertIn("3: angle, rake", self.refused(STRIP, planes + "upright={0, 30, 90, 0.4}"))
        self.assertIn("outside [0, 90]", self.refused(BOX, planes + "thrust={0, 120, 90, 0.4}"))
        for friction in (-0.4, 40):
            self.assertIn("outside [0, 1]",
                          self.refused(BOX, planes + f"thrust={{0, 30, 90, {friction}}}"))
        self.assertIn("East is parallel to Up", self.refused(BOX, "Output/East={0, 2, 0}"))
        self.assertIn("coulomb_stress_change_thrust", self.refused(
            BOX, "Output/Volume Snapshots/Fields={coulomb_stress_change_trust}"))


class TractionOfAFault(unittest.TestCase):
    """The first model, whose fault creeps below its zone; its lowest node has a given slip rate."""

    def tractions(self, a_of_lowest):
        """Those of the last row (nodes), the law's, and where the slip rate is prescribed."""
        folder = asperity_run.run_to_end(
            f"traction_{a_of_lowest}", asperity_run.SOURCE / "examples/first_model/plane.xml",
            *asperity_run.settings(
                "Names/cell=2000", "Names/slip_distance=0.1", "Time Stepping/Final Time=3e8",
                f"Friction/a=y < -24e3 + 1 ? {a_of_lowest} : 0.005 + 0.020 * "
                "min(1, beyond_zone / 3e3)", "Output/Fault History/Precision=Double",
                "Output/Fault History/Fields={slip_rate, alpha, traction, normal_stress, "
                "prescribed}"))
        fault = asperity.Run(folder).fault
        rate, alpha, traction, sigma_n, prescribed = (
            fault[name][-1].ravel() for name in ("slip_rate", "alpha", "traction", "normal_stress",
                                                 "prescribed"))
        a = numpy.where(prescribed == 1, a_of_lowest, 0.025)
        law = sigma_n * a * numpy.arcsinh(rate / 2e-6 * numpy.exp((0.6 + 0.015 * alpha) / a))
        return traction, law, prescribed == 1, fault.coordinates[:, 1] < -17e3

    def test_is_a_reaction_where_the_slip_rate_is_prescribed(self):
        traction, law, prescribed, creeps = self.tractions(0.025)
        self.assertEqual(prescribed.sum(), 1)
        free = creeps & ~prescribed
        numpy.testing.assert_allclose(traction[free], law[free], rtol=1e-4)
        self.assertGreater(abs(traction / law - 1)[prescribed][0], 0.05)
        other, other_law, *_ = self.tractions(0.05)
        self.assertGreater(abs(other_law / law - 1)[prescribed][0], 0.02)
        numpy.testing.assert_allclose(other, traction, rtol=1e-9)


if __name__ == "__main__":
    unittest.main()
