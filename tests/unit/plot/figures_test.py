"""The figures of synthetic runs: that they come into being, and that they show the data."""

from unittest import mock

import numpy as np
from matplotlib import pyplot
from matplotlib.collections import QuadMesh
from matplotlib.image import imread

import synthetic_cycle
import synthetic_run
from asperity_plot import cli, energy, events, iterations, maps, raster, slip, slip_rate, style
from asperity_plot import slip_profiles, surface, windows
from asperity.run import Run
from folders import SharedFolderCase, told


def shown(axes) -> np.ndarray:
    """The values of the map in `axes`, (positions, times)."""
    mesh = next(child for child in axes.get_children() if isinstance(child, QuadMesh))
    columns = mesh.get_coordinates().shape[1] - 1
    return np.asarray(mesh.get_array()).reshape(-1, columns)


class Figures(SharedFolderCase):
    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        for name, count, wedge in (("many", 7, True), ("one", 1, False), ("none", 0, True)):
            synthetic_run.write_run(cls.folder / name, count, nodes=50, wedge=wedge)
        synthetic_cycle.write_run(cls.folder / "cycle")
        style.use()
        for name, size in (("COLUMNS", 400), ("POSITIONS", 150)):
            coarse = mock.patch.object(maps, name, size)
            coarse.start()
            cls.addClassCleanup(coarse.stop)

    def tearDown(self):
        pyplot.close("all")

    def plot(self, name: str, *options: str):
        """Exit status, standard output and error of asperity-plot."""
        return told(cli.main, self.folder / name, "--dpi", "60", *options)

    def test_all_figures(self):
        status, out, err = self.plot("many")
        self.assertEqual((status, err), (0, ""))
        missing = {"receivers": "receivers.h5", "stations": "receivers.h5",
                   "rupture_times": "rupture.h5", "rupture_patterns": "rupture.h5",
                   "moment_rate": "global.csv"}
        for name in cli.FIGURES:
            if name in missing:
                self.assertIn(f"No figure '{name}': the run has no {missing[name]}.", out)
            elif name in ("fault_maps", "fault_history", "opening", "traces"):  # of other models
                self.assertNotIn(name, out)
            else:
                self.check_picture("many", name, out)
        self.assertIn("7 events", out)
        self.assertRegex(out, r"Recurrence time +6 ")
        self.assertRegex(out, r"Peak slip rate +7 ")

    def check_picture(self, run: str, name: str, out: str) -> None:
        path = self.folder / run / "figures" / f"{name}.png"
        self.assertIn(str(path), out)
        self.assertGreater(imread(path)[..., :3].std(), 0.03, name)

    def test_figures_for_papers(self):
        for name, begin in (("pdf", b"%PDF"), ("svg", b"<?xml")):
            status, out, _ = self.plot("many", "--figures", "events", "--format", name)
            path = self.folder / "many" / "figures" / f"events.{name}"
            self.assertEqual(status, 0)
            self.assertIn(str(path), out)
            self.assertTrue(path.read_bytes().startswith(begin))

    def test_of_few_events_there_are_no_boxes(self):
        run, view = self.view("one")
        axes = events.draw(run, view).axes
        self.assertEqual([len(panel.patches) for panel in axes], [0] * len(axes))
        slips = axes[2]
        self.assertEqual(slips.lines[0].get_marker(), "o")
        np.testing.assert_allclose(slips.lines[0].get_xdata(),
                                   events.unit_of(run.events["peak_slip"], "m")(
                                       run.events["peak_slip"]))
        many = events.draw(*self.view("many")).axes[0]
        self.assertEqual(len(many.patches), 1)

    def test_quartiles_are_in_one_unit(self):
        self.assertEqual(events._texts(np.array([2.16e5, 2.1e9]), "s"), ["0.00684 yr", "66.5 yr"])

    def test_slip_has_colours_from_the_first_event_to_the_last(self):
        """Also where all events come late: here after 12 of 126 s."""
        run, view = self.view("many")
        bar = slip.draw(run, view).axes[1]
        np.testing.assert_allclose(bar.get_ylim(),
                                   run.complete_events["end"][[0, -1]], rtol=1e-6)

    def test_many_events_are_no_block_of_profiles(self):
        run, view = self.view("many")
        with mock.patch.object(slip_profiles, "MOST", 6):
            cut = slip_profiles.draw(run, view).axes[0]
        first, last = (f"{number:.4g}" for number in view.cycles)
        self.assertEqual(cut.get_title(loc="left"), f"From {float(first):.2f} to {last} s")

    def test_says_why_a_figure_that_was_named_is_missing(self):
        status, out, err = self.plot("many", "--figures", "fault_maps")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("No figure 'fault_maps': fault.h5 is not over a surface", out)

    def test_figures_of_a_vertical_fault(self):
        names = ("slip_rate", "slip", "slip_profiles", "receivers", "stations", "rupture_times",
                 "moment_rate")
        status, out, err = self.plot("cycle", "--figures", ",".join(names))
        self.assertEqual((status, err), (0, ""))
        for name in names:
            self.check_picture("cycle", name, out)

    def test_one_event_on_a_fault_that_is_no_wedge(self):
        status, out, err = self.plot("one")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("1 event.", out)
        self.assertEqual(len(list((self.folder / "one" / "figures").glob("*.png"))), 8)

    def test_no_event(self):
        status, out, err = self.plot("none", "--figures", "events,slip_rate,slip_profiles")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("No figure 'events': the run has no complete event.", out)
        self.assertIn("No event.", out)
        for name in ("slip_rate", "slip_profiles"):
            self.check_picture("none", name, out)

    def test_no_figure_of_an_earlier_call_stays(self):
        folder = self.folder / "left_out"
        for options, is_there in (((), True), (("--from", "1e12"), False)):
            status, out, err = self.plot("many", "--figures", "events", "--output", str(folder),
                                         *options)
            self.assertEqual((status, err), (0, ""))
            self.assertEqual((folder / "events.png").exists(), is_there)
        self.assertIn("No figure 'events': the run has no complete event that is not left out.",
                      out)

    def test_choice_of_figures_window_and_folder(self):
        target = self.folder / "elsewhere" / "deep"
        status, out, _ = self.plot("many", "--figures", "surface,events", "--output", str(target),
                                   "--window", "20", "50")
        self.assertEqual(status, 0)
        self.assertEqual({path.name for path in target.iterdir()}, {"surface.png", "events.png"})
        self.assertNotIn("slip_rate", out)

    def view(self, name: str):
        run = Run(self.folder / name)
        return run, windows.choose(run, None)

    def test_slip_rate_shows_the_fastest_point(self):
        run, view = self.view("many")
        axes = slip_rate.draw(run, view).axes
        rates = run.fault.read("slip_rate", slice(None))
        inside = (run.fault.time >= view.cycles[0]) & (run.fault.time <= view.cycles[1])
        fastest = np.log10(rates[inside].max())
        self.assertLess(abs(shown(axes[0]).max() - fastest), 0.05)
        inside = (run.fault.time >= view.zoom[0]) & (run.fault.time <= view.zoom[1])
        zoom = next(child for child in axes[1].get_children() if isinstance(child, QuadMesh))
        self.assertLess(abs(zoom.get_array().max() - np.log10(rates[inside].max())), 0.05)
        # colours are linear in time between rows, as the contours are
        self.assertEqual(zoom.get_coordinates()[..., 0].size, zoom.get_array().size)
        self.assertIn(f"event {view.number}", axes[1].get_title())
        self.assertIn("[ms]", axes[1].get_xlabel())
        self.assertIn("seismogenic zone", [text.get_text() for text in axes[1].texts])

    def test_every_zone_is_marked(self):
        text = (self.folder / "many" / "parameters.xml").read_text()
        folder = self.folder / "two_zones"
        folder.mkdir()
        mark = '<ParameterList name="Wedge">\n'
        (folder / "parameters.xml").write_text(text.replace(
            mark, mark + '<Parameter name="Refined Intervals" type="Array(double)" '
                         'value="{0.7, 0.8}"/>\n'))
        (folder / "run.log").write_text("")
        _, axes = style.panels(1, 2, (5.0, 4.0))
        style.mark_zone(axes[0, 0], Run(folder), np.array, "white", label=True)
        style.shade_zone(axes[0, 1], Run(folder), np.array)
        lines = [line.get_ydata()[0] for line in axes[0, 0].lines if line.get_color() == "white"]
        np.testing.assert_allclose(sorted(lines)[2:], [0.7, 0.8])
        self.assertEqual(len(axes[0, 1].patches), 2)

    def test_the_name_of_the_zone_lies_over_no_curve(self):
        run, _ = self.view("many")
        figure, axes = style.panels(1, 1, (5.0, 4.0))
        axes[0, 0].plot([0.0, 1.0], [0.0, 1.0])
        style.shade_zone(axes[0, 0], run, lambda places: places)
        figure.canvas.draw()
        label = axes[0, 0].texts[0].get_window_extent()
        self.assertGreaterEqual(label.y0, axes[0, 0].get_window_extent().y1)

    def test_surface_shows_the_component_against_gravity_without_its_trend(self):
        run, view = self.view("many")
        self.assertGreaterEqual(view.num_events, surface.FEWEST)
        values = shown(surface.draw(run, view).axes[0])
        np.testing.assert_allclose(values.mean(axis=1), 0.0, atol=1e-9 * np.abs(values).max())
        columns = raster.centres(raster.edges(view.cycles, values.shape[1]))
        where = raster.centres(raster.edges((0.0, 1.0), values.shape[0]))
        expected = synthetic_run.uplift(columns, where, synthetic_run.event_times(7))
        lines = np.polynomial.Polynomial.fit
        expected = 1e6 * np.array([line - lines(columns, line, 1)(columns)
                                   for line in expected.T])
        error = np.abs(values - expected)
        self.assertLess(np.median(error), 0.01 * np.abs(expected).max())

    def test_boxes_are_those_of_the_table(self):
        run, view = self.view("many")
        self.assertEqual([row[1] for row in events.summary(run)], [6, 7, 7, 7, 7])
        titles = [axes.get_title(loc="right") for axes in events.draw(run, view).axes]
        median = np.median(np.diff(run.events["onset"]))
        self.assertEqual(titles[0], f"median {median:.1f} s")

    def test_widths_of_single_nodes_count_as_unknown(self):
        text = (self.folder / "many" / "events.csv").read_text().splitlines()
        column = text[0].split(",").index("width [m]")
        cells = text[1].split(",")
        cells[column] = "0"
        folder = self.folder / "single_node"
        folder.mkdir()
        (folder / "events.csv").write_text("\n".join([text[0], ",".join(cells), *text[2:], ""]))
        widths = events.samples(Run(folder))["width"]
        self.assertEqual(widths.size, 6)
        self.assertGreater(widths.min(), 0.0)
        figure = events.draw(Run(folder), self.view("many")[1])
        self.assertTrue(any("1 event of a single node" in text.get_text()
                            for text in figure.texts))

    def test_iterations_show_every_step_of_the_zoom(self):
        run, view = self.view("many")
        zoom = iterations.draw(run, view).axes[4]
        time = zoom.lines[0].get_xdata()
        steps = run.steps
        inside = (steps["time"] >= view.zoom[0]) & (steps["time"] <= view.zoom[1])
        self.assertGreater(np.count_nonzero(inside), 50)
        self.assertLessEqual(abs(time.size - np.count_nonzero(inside)), 2)
        expected = steps["fixed_point_iterations"][inside].max()
        self.assertEqual(zoom.lines[0].get_ydata().max(), expected)

    def test_slip_profiles_one_for_each_event(self):
        run, view = self.view("many")
        lines = slip.draw(run, view).axes[0].lines
        self.assertEqual(len(lines), 7)
        self.assertTrue(np.all(lines[-1].get_ydata() > lines[0].get_ydata()))

    def test_energy_closes_as_written(self):
        run, view = self.view("many")
        relative = energy.draw(run, view).axes[1].lines[0].get_ydata()
        self.assertAlmostEqual(relative.max(), 1e-9, delta=1e-11)

    def test_lines_on_zero_are_named_and_not_drawn_and_the_imbalance_is_of_the_largest_work(self):
        text = (self.folder / "many" / "steps.csv").read_text().splitlines()
        columns = text[0].split(",")
        work, defect = columns.index("friction_work [J/m]"), columns.index("energy_defect [J/m]")
        rows = [row.split(",") for row in text[1:]]
        for row in rows:  # a locked fault
            row[work], row[defect] = "0", "1e-9"
        folder = self.folder / "locked"
        folder.mkdir()
        (folder / "steps.csv").write_text("\n".join([text[0], *map(",".join, rows), ""]))
        upper, lower = energy.draw(Run(folder), self.view("many")[1]).axes
        labels = [line.get_label() for line in upper.lines]
        self.assertIn("Boundary work", labels)
        self.assertNotIn("Friction work", labels)
        self.assertIn("friction work", " ".join(upper.get_title(loc="left").split()))
        self.assertLess(lower.lines[0].get_ydata()[-1], 1e-6)

    def test_energy_counts_works_and_dissipation_from_the_start(self):
        lines, view = {}, self.view("many")[1]
        for name in ("kinetic_energy", "numerical_dissipation"):
            text = (self.folder / "many" / "steps.csv").read_text()
            folder = self.folder / name
            folder.mkdir()
            (folder / "steps.csv").write_text(text.replace("elastic_energy", name + "_too"))
            axes = energy.draw(Run(folder), view).axes[0]
            lines.update({line.get_label(): line.get_ydata() for line in axes.lines})
        self.assertIn("Friction work", lines)
        self.assertAlmostEqual(lines["Change of kinetic energy too"][0], 0.0)
        self.assertNotAlmostEqual(lines["Numerical dissipation too"][0], 0.0)
