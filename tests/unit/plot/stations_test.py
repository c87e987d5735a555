"""Series at receivers in the body: displacement over the run, velocity in one rupture."""

import h5py
import numpy as np
from matplotlib import pyplot

import synthetic_cycle as cycle
from asperity.errors import InputError, NothingToShow
from asperity.run import Run
from asperity_plot import stations, style, units, windows
from asperity_plot.windows import Options
from folders import FolderCase


class Stations(FolderCase):
    def setUp(self):
        super().setUp()
        self.times = cycle.row_times()
        cycle.write_receivers(self.folder / "receivers.h5", self.times)
        cycle.write_events(self.folder / "events.csv")
        cycle.write_steps(self.folder / "steps.csv", self.times)
        cycle.write_parameters(self.folder / "parameters.xml")
        style.use()
        self.addCleanup(pyplot.close, "all")

    def draw(self, window=None, **options):
        run = Run(self.folder)
        return stations.draw(run, windows.choose(run, window, Options(**options)))

    def change(self, field: str, values) -> None:
        """Another field of this name, or none."""
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file[f"off_fault/fields/{field}"]
            if values is not None:
                file[f"off_fault/fields/{field}"] = values

    def panels(self, figure) -> np.ndarray:
        return np.array(figure.axes[:-1]).reshape(3, 2)  # the last one has the legend

    def test_displacement_counts_from_the_start(self):
        figure = self.draw()
        displacement = cycle.motion(self.times)["displacement"]
        for number, panel in enumerate(self.panels(figure)[:, 0]):
            self.assertEqual(len(panel.lines), 2 + (number == 0))  # the mark of the zoom
            for station, line in enumerate(panel.lines[:2]):
                np.testing.assert_allclose(line.get_xdata(), self.times / units.YEAR)
                expected = displacement[:, station, number] - displacement[0, station, number]
                np.testing.assert_allclose(line.get_ydata(), expected, atol=1e-15)
        labels = [panel.get_ylabel() for panel in self.panels(figure)[:, 0]]
        self.assertEqual(labels, ["Displacement x [m]", "Displacement y [m]",
                                  "Displacement z [m]"])
        legend = figure.axes[-1].get_legend()
        self.assertEqual([text.get_text() for text in legend.get_texts()], ["near", "far"])

    def test_velocity_in_the_rupture(self):
        panel = self.panels(self.draw())[1, 1]
        line = panel.lines[0]
        shown = line.get_xdata()
        inside = (shown >= -1e-6) & (shown <= 10.0 + 1e-6)
        rows = (self.times >= cycle.ONSETS[2]) & (self.times <= cycle.ONSETS[2] + 10.0)
        np.testing.assert_allclose(shown[inside], np.arange(0.0, 10.1, 0.25), atol=1e-6)
        expected = cycle.motion(self.times)["velocity"][rows, 0, 1]
        unit = units.prefixed([np.abs(cycle.motion(self.times)["velocity"][rows]).max()], "m/s")
        np.testing.assert_allclose(line.get_ydata()[inside], expected / unit.factor)
        self.assertEqual(panel.get_ylabel(), f"Velocity y [{unit.name}]")

    def test_up_is_where_the_deck_says(self):
        text = (self.folder / "parameters.xml").read_text()
        (self.folder / "parameters.xml").write_text(text.replace(
            '<ParameterList name="Output">', '<ParameterList name="Output">'
            '<Parameter name="Up" type="Array(double)" value="{0, 0, 2}"/>', 1))
        labels = [panel.get_ylabel() for panel in self.panels(self.draw())[:, 0]]
        self.assertEqual(labels[1:], ["Displacement y [m]", "Displacement z (up) [m]"])

    def test_one_field_is_shown_twice(self):
        self.change("velocity", None)
        panels = self.panels(self.draw())
        self.assertTrue(panels[0, 1].get_ylabel().startswith("Displacement x"))
        self.assertEqual(panels[0, 1].lines[0].get_ydata()[0], 0.0)
        self.change("displacement", None)
        with self.assertRaisesRegex(NothingToShow, "none of the fields displacement, velocity"):
            self.draw()

    def test_without_an_event_both_are_shown_over_the_whole_time(self):
        (self.folder / "events.csv").unlink()
        for panel in self.panels(self.draw()).flat:
            np.testing.assert_allclose(panel.lines[0].get_xdata(), self.times / units.YEAR)

    def test_fewer_components(self):
        for field, values in cycle.motion(self.times).items():
            self.change(field, values[:, :, 0])
        figure = self.draw()
        self.assertEqual(len(figure.axes), 2 + 1)
        self.assertEqual(figure.axes[0].get_ylabel(), "Displacement along strike [m]")
        for field, values in cycle.motion(self.times).items():
            self.change(field, values[:, :, :2])
        labels = [axes.get_ylabel() for axes in self.draw().axes[:4:2]]
        self.assertEqual(labels, ["Displacement x [m]", "Displacement y [m]"])

    def test_a_tensor_is_no_motion(self):
        self.change("displacement", np.zeros((self.times.size, 2, 6)))
        with self.assertRaisesRegex(InputError, "off_fault/fields/displacement' has 6 components"):
            self.draw()

    def test_choice_of_receivers(self):
        self.assertEqual(len(self.draw(receivers=("far", "dp000")).axes[2].lines), 1)
        with self.assertRaisesRegex(NothingToShow, "no receiver named dp000 lies in the body"):
            self.draw(receivers=("dp000",))
        with self.assertRaisesRegex(InputError, "has no receiver 'fra'"):
            self.draw(receivers=("fra",))

    def test_no_receiver_in_the_body(self):
        with h5py.File(self.folder / "receivers.h5", "a") as file:
            del file["off_fault"]
        with self.assertRaisesRegex(NothingToShow, "no receiver in the body"):
            self.draw()
