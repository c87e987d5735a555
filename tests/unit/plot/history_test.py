"""Histories read in blocks, and brought to the columns of a picture."""

from unittest import mock

import h5py
import numpy as np

import synthetic_run
from asperity import history
from asperity_plot import raster
from asperity.errors import InputError, NothingToShow
from asperity.history import History
from folders import FolderCase


class Histories(FolderCase):
    def setUp(self):
        super().setUp()
        self.path = self.folder / "fault.h5"
        random = np.random.default_rng(7)
        self.times = np.cumsum(10.0**random.uniform(-3.0, 0.0, 400))
        self.values = 10.0**random.uniform(-9.0, 0.0, (400, 5))
        self.vectors = random.normal(size=(400, 5, 2))
        self.coordinates = np.stack((np.array([0.0, 0.1, 0.3, 0.4, 1.0]), np.zeros(5)), axis=1)
        self.write()

    def write(self):
        synthetic_run.write_history(self.path, self.times, self.coordinates,
                                    {"slip_rate": self.values, "displacement": self.vectors}, 3)

    def test_rows_enclose_the_window(self):
        opened = History(self.path)
        rows = opened.rows((self.times[10] + 1e-6, self.times[20] - 1e-6))
        self.assertEqual((rows.start, rows.stop), (10, 21))
        everything = opened.rows((-1e9, 1e9))
        self.assertEqual((everything.start, everything.stop), (0, 400))

    def test_read_takes_a_component(self):
        read = History(self.path).read("displacement", slice(130, 140), np.array([0.6, 0.8]))
        expected = self.vectors[130:140] @ np.array([0.6, 0.8])
        np.testing.assert_allclose(read, expected, rtol=1e-14)

    def test_interpolation_does_not_depend_on_blocks(self):
        times = np.linspace(self.times[3], self.times[-3], 311)
        expected = np.stack([np.interp(times, self.times, self.values[:, node])
                             for node in range(5)], axis=1)
        for size in (40, 200, 10**6):
            with mock.patch.object(history, "BLOCK_BYTES", size):
                read = raster.interpolated(History(self.path), "slip_rate", times)
            np.testing.assert_allclose(read, expected, rtol=1e-12)

    def test_maxima_lose_no_row(self):
        window = (self.times[50], self.times[350])
        limits = raster.edges(window, 40)
        for size in (40, 200, 10**6):
            with mock.patch.object(history, "BLOCK_BYTES", size):
                maxima = raster.maxima(History(self.path), "slip_rate", window, 40)
            for column in range(40):
                rows = (self.times >= limits[column]) & (self.times < limits[column + 1])
                if rows.any():
                    largest = np.log10(self.values[rows].max(axis=0))
                    self.assertTrue(np.all(maxima[column] >= largest - 1e-12))
            self.assertLessEqual(maxima.max(), np.log10(self.values[49:352].max()) + 1e-12)

    def test_a_short_event_fills_its_column(self):
        self.values[:] = 1e-9
        self.values[200, 2] = 1.0
        self.write()
        window = (self.times[0], self.times[-1])
        maxima = raster.maxima(History(self.path), "slip_rate", window, 25)
        column = np.searchsorted(raster.edges(window, 25), self.times[200], side="right") - 1
        self.assertAlmostEqual(maxima[column, 2], 0.0)
        self.assertAlmostEqual(maxima[column, 4], -9.0)

    def test_values_between_nodes_are_linear(self):
        positions = np.array([0.0, 1.0, 3.0])
        values = np.array([[0.0, 2.0, 6.0], [1.0, 1.0, -1.0]])
        np.testing.assert_allclose(raster.along(positions, values, np.array([0.5, 2.0, 3.0])),
                                   [[1.0, 4.0, 6.0], [1.0, 0.0, -1.0]])

    def test_zero_slip_rate_has_a_logarithm(self):
        self.assertTrue(np.isfinite(raster.log10(np.zeros(1)))[0])

    def test_missing_segment_is_an_error_and_not_zeros(self):
        (self.path.parent / "segments" / "fault_000001.h5").unlink()
        with self.assertRaisesRegex(InputError, "fault_000001.h5"):
            History(self.path)

    def test_a_fault_in_three_dimensions_has_no_position(self):
        self.coordinates = np.random.default_rng(1).normal(size=(5, 3))
        self.write()
        with h5py.File(self.path, "a") as file:
            del file["geometry/positions"]
        with self.assertRaises(NothingToShow):
            History(self.path).position  # pylint: disable=expression-not-assigned
