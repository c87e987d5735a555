"""Three dimensions: a wedge that repeats itself along its depth is the wedge in the plane."""

import pathlib
import unittest

import numpy

import asperity_run

HERE = pathlib.Path(__file__).parent
PLANE = HERE.parent / "parallel"
OVERLAYS = ["--overlay", PLANE / "rupture.xml"]
SAME_CELLS = ["--set", "Mesh/Wedge/Cell Size=0.03"]
SOLID = ["--overlay", HERE / "periodic_wedge.xml"]


def run_rupture(name, changes, ranks=1):
    return asperity_run.run_to_end(name, PLANE / "coarse_wedge.xml", *OVERLAYS, *changes,
                                   ranks=ranks, timeout=400)


def by_place(file_name, names):
    """Coordinates and {name: values (steps, nodes[, components])}, ordered by the coordinates."""
    data = asperity_run.series(file_name)
    places = data["geometry/coordinates"]
    order = numpy.lexsort(numpy.round(places.T, 9))
    return places[order], {name: data["fields/" + name][:, order] for name in names}


class PeriodicWedge(unittest.TestCase):
    """Steps are prescribed: everything must agree to the solver's tolerance."""

    @classmethod
    def setUpClass(cls):
        cls.plane = run_rupture("plane", SAME_CELLS)
        cls.solid = run_rupture("solid", SOLID)

    def test_is_a_rupture(self):
        rate = asperity_run.series(self.plane / "fault.h5")["fields/slip_rate"]
        self.assertGreater(rate.max(), 2e-3)

    def test_the_fault_moves_as_in_the_plane(self):
        self.assert_same_as_plane(self.solid)

    def test_two_ranks(self):
        self.assert_same_as_plane(run_rupture("solid_2", SOLID, ranks=2))

    def assert_same_as_plane(self, folder):
        names = ["slip_rate", "alpha", "slip", "traction"]
        places, expected = by_place(self.plane / "fault.h5", names)
        solid_places, found = by_place(folder / "fault.h5", names)
        layers = numpy.unique(numpy.round(solid_places[:, 2], 9))
        self.assertEqual(len(layers), 3)
        for layer in layers:
            here = numpy.abs(solid_places[:, 2] - layer) < 1e-9
            numpy.testing.assert_allclose(solid_places[here][:, :2], places, rtol=0, atol=1e-12)
            for name in names:
                ours, theirs = found[name][:, here], expected[name]
                if ours.ndim == 3 and ours.shape[2] == 3:  # along the axes, the fault along x
                    self.assertLess(numpy.abs(ours[..., 1:]).max(), 1e-9 * numpy.abs(theirs).max())
                    ours = ours[..., 0]
                error = numpy.abs(ours.squeeze() - theirs.squeeze()).max()
                self.assertLess(error, 1e-8 * numpy.abs(theirs).max(), (name, layer))

    def test_nothing_moves_along_the_depth(self):
        names = ["displacement", "velocity"]
        places, expected = by_place(self.plane / "volume.h5", names)
        solid_places, found = by_place(self.solid / "volume.h5", names)
        for layer in numpy.unique(numpy.round(solid_places[:, 2], 9)):
            here = numpy.abs(solid_places[:, 2] - layer) < 1e-9
            self.assertEqual(here.sum(), len(places))
            for name in names:
                largest = numpy.abs(expected[name]).max()
                self.assertLess(numpy.abs(found[name][:, here, 2]).max(), 1e-9 * largest, name)
                error = numpy.abs(found[name][:, here, :2] - expected[name]).max()
                self.assertLess(error, 1e-8 * largest, name)


if __name__ == "__main__":
    unittest.main()
