"""The figure of faults that open: where and while they are open, and no other time or place."""

import numpy as np
from matplotlib import pyplot

import synthetic_run
from asperity.errors import NothingToShow, OtherModel
from asperity.run import Run
from asperity_plot import opening, style, windows
from figures_test import shown
from folders import FolderCase

TIMES, PLACES = np.linspace(0.0, 20.0, 81), np.linspace(0.0, 1000.0, 101)


def opened(times, places):
    """[m] open up to 100 m around 400 m, from 6 s to 10 s; elsewhere nodes have passed a little."""
    in_time = np.maximum(1.0 - ((times - 8.0) / 2.0)**2, 0.0)[:, None]
    return 0.3 * in_time * np.maximum(1.0 - ((places - 400.0) / 100.0)**2, -1e-3)


class Opening(FolderCase):
    def setUp(self):
        super().setUp()
        style.use()
        self.addCleanup(pyplot.close, "all")

    def draw(self, fields):
        coordinates = np.stack((PLACES, 0.0 * PLACES), axis=1)
        synthetic_run.write_history(self.folder / "fault.h5", TIMES, coordinates, fields)
        run = Run(self.folder)
        return opening.draw(run, windows.choose(run, None))

    def test_shows_where_and_while_a_fault_is_open(self):
        axes = self.draw({"opening": opened(TIMES, PLACES)}).axes[0]
        # the first and the last row, and node, that are open, and 15 % more
        np.testing.assert_allclose(axes.get_xlim(), (6.25 - 0.15 * 3.5, 9.75 + 0.15 * 3.5))
        np.testing.assert_allclose(axes.get_ylim(), (310 - 0.15 * 180, 490 + 0.15 * 180))
        picture = shown(axes)
        self.assertEqual(picture.min(), 0.0)
        self.assertAlmostEqual(picture.max(), 30.0, delta=0.3)  # cm
        low, high = axes.get_ylim()
        row = np.argmax(picture.max(axis=1)) + 0.5
        self.assertAlmostEqual(low + row / len(picture) * (high - low), 400.0, delta=3.0)

    def test_a_fault_that_stays_shut(self):
        with self.assertRaisesRegex(NothingToShow, "does not open"):
            self.draw({"opening": np.minimum(opened(TIMES, PLACES), 0.0)})

    def test_a_fault_that_cannot_open(self):
        with self.assertRaisesRegex(OtherModel, "no field 'opening'"):
            self.draw({"slip_rate": opened(TIMES, PLACES)})
