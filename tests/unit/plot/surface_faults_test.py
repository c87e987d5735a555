"""Figures of runs in three dimensions, whose fault is a surface."""

import tempfile
from dataclasses import replace
from pathlib import Path
from unittest import mock

import h5py
import numpy as np
from matplotlib import pyplot
from matplotlib.quiver import QuiverKey

import synthetic_run
import synthetic_surface as surface
from asperity_plot import (deformation, fault_history, fault_maps, moment_rate, plane,
                           rupture_patterns, style, windows)
from asperity_plot.cli import main
from asperity.errors import NothingToShow
from asperity.run import Run
from folders import FolderCase, told


class SurfaceFaults(FolderCase):
    def setUp(self):
        super().setUp()
        surface.write_run(self.folder)
        self.run_ = Run(self.folder)
        self.view = windows.choose(self.run_, None)
        style.use()
        self.addCleanup(pyplot.close, "all")

    def test_nodes_by_strike_and_dip(self):
        where = plane.plane(self.run_, self.run_.fault)
        strike, dip, triangles = surface.grid()
        np.testing.assert_allclose(where.strike, strike, atol=1e-9)
        np.testing.assert_allclose(where.dip, dip, atol=1e-9)
        np.testing.assert_array_equal(where.triangles, triangles)

    def test_a_level_fault_has_its_strike_along_z(self):
        corners = np.array([[[0.0, 0, 0], [1, 0, 1], [1, 0, 0]]])
        strike, dip = plane.directions(corners, np.array([0.0, 1, 0]))
        np.testing.assert_allclose(strike, [0, 0, 1], atol=1e-15)
        np.testing.assert_allclose(np.abs(dip), [1, 0, 0], atol=1e-15)

    def test_faults_that_cover_each_other_lie_side_by_side(self):
        x, y = (values.ravel() for values in np.meshgrid(np.arange(4.0), [0.0, 1.0]))
        strip = np.array([[i, i + 1, i + 5] for i in range(3)] +
                         [[i, i + 5, i + 4] for i in range(3)])
        triangles, fault_of = np.concatenate((strip, strip + 8)), np.repeat([0, 1], 8)
        for shift, down, moves in ((2.0, 0.0, True), (3.0, 0.0, False), (0.0, 1.0, False)):
            along = np.concatenate((x, x + shift))
            moved = plane.side_by_side(along, np.concatenate((y, y + down)), fault_of)
            self.assertEqual((moved[0], moved[1] > 0.0), (0.0, moves))
        # the second fault lies 5 m behind the first one
        nodes = np.stack((np.concatenate((x, x + 2)), -np.concatenate((y, y)),
                          np.repeat([0.0, 5.0], 8)), axis=1)
        where = plane.unrolled(nodes, triangles, ["front", "back"], np.repeat([0, 1], 6),
                               np.array([0.0, 1.0, 0.0]))
        self.assertEqual(float(where.unit.factor), 1.0)
        np.testing.assert_allclose(where.place(nodes[3]), (3.0, 0.0), atol=1e-12)
        self.assertGreater(where.place(nodes[8])[0], 3.0)

    def test_a_splay_begins_at_its_own_upper_end(self):
        """It shares its lower edge with the main fault, and its upper edge is at the surface."""
        nodes = np.array([[0.0, 0, 0], [0, 0, 2e3], [3e3, -4e3, 0], [3e3, -4e3, 2e3],
                          [6e3, -8e3, 0], [6e3, -8e3, 2e3],  # main, down to 8 km
                          [6e3, 0, 0], [6e3, 0, 2e3]])       # of the splay, which joins it at 4 km
        triangles = np.array([[0, 1, 3], [0, 3, 2], [2, 3, 5], [2, 5, 4], [6, 7, 3], [6, 3, 2]])
        where = plane.unrolled(nodes, triangles, ["main", "splay"], np.array([0, 0, 0, 0, 1, 1]),
                               np.array([0.0, 1.0, 0.0]))
        splay = where.fault_of == 1
        np.testing.assert_allclose(where.dip[~splay], [0, 0, 5e3, 5e3, 10e3, 10e3], atol=1e-9)
        np.testing.assert_allclose(where.dip[splay], [5e3, 5e3, 0, 0], atol=1e-9)  # 2, 3, 6, 7
        np.testing.assert_array_equal(where.source[splay], [2, 3, 6, 7])
        self.assertGreater(where.strike[splay].min(), where.strike[~splay].max())
        np.testing.assert_allclose(nodes[where.source], where.nodes)
        _, axes = style.panels(1, 1, (5.0, 4.0))
        where.label(axes[0, 0])
        self.assertEqual([text.get_text() for text in axes[0, 0].texts], ["main", "splay"])

    def write_surface(self, factors):
        """Displacements at the start, the onset, five durations after the end, and the run's end,
        as `factors` of those that this returns."""
        x, z = (values.ravel() for values in np.meshgrid([-1e3, 0.0, 0.0, 1e3], [0.0, 2e3]))
        side = np.array([0.0, 0.0, 1.0, 1.0] * 2)[:, None]  # 1 in the hanging wall
        rates = (1 - side) * [0.1, 0.02, 0.0] + side * [-0.3, 0.05, 0.1]
        corners = np.array([[0, 1, 5], [0, 5, 4], [2, 3, 7], [2, 7, 6]])
        with h5py.File(self.folder / "surface.h5", "w") as file:
            file["time"] = [0.0, surface.ONSET, 118.0, 200.0]
            file["fields/displacement"] = np.array(factors)[:, None, None] * rates
            surface.write_geometry(file, np.stack((x, 0.0 * x, z), axis=1), corners)
        return rates

    def test_maps_of_the_surface_on_both_sides(self):
        rates = self.write_surface([0.0, surface.ONSET, -10.0, 0.0])
        axes = deformation.draw(Run(self.folder), self.view).axes
        self.assertEqual(len(axes), 2)
        for panel, factor in zip(axes[:2], (surface.ONSET, -10.0 - surface.ONSET)):
            self.assertEqual((panel.get_xlabel(), panel.get_ylabel()[:1]), ("x [km]", panel
                             is axes[0] and "z" or ""))
            colours, arrows = panel.collections[:2]
            unit = 100.0 if np.abs(factor * rates[:, 1]).max() < 1.0 else 1.0
            np.testing.assert_allclose(colours.get_array(), unit * factor * rates[:, 1])
            left = arrows.XY[:, 0] < 0.0
            self.assertTrue(left.any() and not left.all())
            np.testing.assert_allclose(arrows.U[left], factor * 0.1)
            np.testing.assert_allclose(arrows.V[arrows.XY[:, 0] > 0.5], factor * 0.1)

    def write_half(self, lean=0.0):
        """A surface over x >= 1 km beside an antisymmetric fault at x = 1 km, which leans by this
        tangent; the displacement at the end of the event."""
        x, z = (values.ravel() for values in np.meshgrid([1e3, 3e3], [0.0, 2e3]))
        moved = np.array([[0.1, 0.02, 0.3], [-0.2, 0.05, 0.1], [0.3, -0.04, 0.2], [0.0, 0.01, 0.1]])
        with h5py.File(self.folder / "surface.h5", "w") as file:
            file["time"] = [0.0, surface.ONSET, 118.0, 200.0]
            file["fields/displacement"] = np.array([0, 0, 1, 1])[:, None, None] * moved
            surface.write_geometry(file, np.stack((x, 0.0 * x, z), axis=1), [[0, 1, 3], [0, 3, 2]])
        strike, dip, triangles = surface.grid()
        (self.folder / "fault.h5").unlink()  # the run of the set-up has it open
        with h5py.File(self.folder / "fault.h5", "w") as file:
            file["time"] = [0.0, 200.0]
            surface.write_geometry(file, np.stack((1e3 + lean * dip, -dip, strike), axis=1),
                                   triangles)
        synthetic_run.add_condition(self.folder, "Antisymmetric Fault")
        return moved

    def test_beside_an_antisymmetric_fault_both_halves_are_drawn(self):
        moved = self.write_half()
        panel = deformation.draw(Run(self.folder), self.view).axes[0]
        colours, arrows = panel.collections[:2]
        self.assertEqual(colours.get_array().size, 8)
        np.testing.assert_allclose(colours.get_array()[:4], 100 * moved[:, 1] / (
            1.0 if "[cm]" in panel.child_axes[0].get_ylabel() else 100.0))
        # u_t changes its sign in the image, along z and upwards; u_n along x does not
        np.testing.assert_allclose(colours.get_array()[4:], -colours.get_array()[:4])
        np.testing.assert_allclose(panel.get_xlim(), [-1.0, 3.0])  # the image of 3 km is at -1 km
        for place, x, z in zip(arrows.XY, arrows.U, arrows.V):
            node = int(np.argmin(np.abs(np.abs(place[0] - 1.0) - [0, 2, 0, 2])
                                 + np.abs(place[1] - np.array([0, 0, 2, 2]))))
            if place[0] != 1.0:  # two nodes are at the fault
                self.assertAlmostEqual(x, moved[node, 0])
                self.assertAlmostEqual(z, np.sign(place[0] - 1.0) * moved[node, 2])

    def test_a_leaning_antisymmetric_fault_has_its_half_and_says_so(self):
        self.write_half(lean=0.3)
        figure = deformation.draw(Run(self.folder), self.view)
        self.assertEqual(figure.axes[0].collections[0].get_array().size, 4)
        self.assertIn("modelled half", figure._suptitle.get_text())

    def test_where_nothing_moves_before_the_event_there_is_no_empty_map(self):
        for factors, words in (([0.0, 0.0, -10.0, 0.0], "from the onset of event 1"),
                               ([0.0, 5.0, 5.0, 5.0], "before event 1")):
            rates = self.write_surface(factors)
            axes = deformation.draw(Run(self.folder), self.view).axes
            self.assertEqual(len(axes), 1)
            self.assertTrue(axes[0].get_title().endswith(words), axes[0].get_title())
            unit = {"m": 1.0, "cm": 100.0}[
                axes[0].child_axes[0].get_ylabel().partition("[")[2].rstrip("]")]
            np.testing.assert_allclose(axes[0].collections[0].get_array(),
                                       unit * (factors[2] or factors[1]) * rates[:, 1])

    def test_where_nothing_moves_there_is_nothing_to_show(self):
        self.write_surface([1.0, 1.0, 1.0, 1.0])
        with self.assertRaisesRegex(NothingToShow, "does not move"):
            deformation.draw(Run(self.folder), self.view)

    def test_slip_and_arrivals_of_the_event(self):
        strike, dip, _ = surface.grid()
        expected = surface.slip_of(np.array([surface.END]), strike, dip)[0]
        slip = fault_maps.event_slip(self.run_, surface.ONSET, surface.END)
        np.testing.assert_allclose(slip, expected, atol=1e-12)
        front = fault_maps.arrivals(self.run_, 0)
        np.testing.assert_allclose(front, surface.arrivals(strike, dip), atol=1e-9)
        self.assertEqual(fault_maps.interval(front), 0.2)  # 1.75 s in about six parts

    def test_maps_of_the_event_show_its_magnitude_and_hypocentre(self):
        figure = fault_maps.draw(self.run_, self.view)
        self.assertEqual(figure._suptitle.get_text(), "Event 1 at 100.00 s, lasting 3.00 s, "
                         "Mw 5.90")
        for panel in figure.axes:
            stars = [line for line in panel.lines if line.get_label() == "hypocentre"]
            self.assertEqual([star.get_marker() for star in stars], ["*"])
            np.testing.assert_allclose(stars[0].get_xydata(), [[2.5, 2.0]])  # [km]
            self.assertEqual([text.get_text() for text in panel.get_legend().get_texts()],
                             ["hypocentre"])
        text = (self.folder / "events.csv").read_text()
        (self.folder / "events.csv").write_text(
            text.replace("magnitude", "other").replace("hypocentre", "place"))
        figure = fault_maps.draw(Run(self.folder), self.view)
        self.assertNotIn("Mw", figure._suptitle.get_text())
        self.assertEqual([line for panel in figure.axes for line in panel.lines], [])

    def test_the_border_of_a_front_is_no_stair(self):
        """That of a circle on squares of 500 m stays within half a square of the circle, and its
        area within 2 % of it."""
        strike, dip, _ = surface.grid()
        where = plane.plane(self.run_, self.run_.fault)
        centre, radius = (5000.0, 2500.0), 2200.0
        distance = np.hypot(strike - centre[0], dip - centre[1])
        front = np.where(distance <= radius, distance / surface.SPEED, np.nan)
        mesh, values = fault_maps.reached_part(where, front)
        x, y = (where.unit.factor * each for each in (mesh.x, mesh.y))
        corners = np.stack((x, y), axis=1)[mesh.triangles]
        sides = corners[:, 1:] - corners[:, :1]
        area = 0.5 * np.abs(sides[:, 0, 0] * sides[:, 1, 1] - sides[:, 0, 1] * sides[:, 1, 0])
        self.assertLess(abs(area.sum() / (np.pi * radius**2) - 1.0), 0.06)
        cuts = np.arange(strike.size, x.size)  # behind the nodes come the points of the border
        away = np.hypot(x[cuts] - centre[0], y[cuts] - centre[1]) - radius
        self.assertLess(np.abs(away).max(), 0.5 * surface.STEP)
        self.assertLess(np.std(away), 0.2 * surface.STEP)
        self.assertLessEqual(values[mesh.triangles].max(), radius / surface.SPEED)
        none, _ = fault_maps.reached_part(where, np.full(strike.size, np.nan))
        self.assertIsNone(none)

    def test_patterns_have_hypocentres_and_long_faults_few_columns(self):
        figure = rupture_patterns.draw(self.run_, self.view)
        self.assertIn("hypocentre", [line.get_label() for line in figure.axes[0].lines])
        for height, columns in ((10.0, 1), (40.0, 2), (90.0, rupture_patterns.COLUMNS)):
            limits = np.array([0.0, 100.0]), np.array([0.0, height])
            self.assertEqual(rupture_patterns.columns_for(limits), columns)

    def test_the_key_of_the_arrows_lies_below_the_map(self):
        self.write_surface([0.0, surface.ONSET, -10.0, 0.0])
        figure = deformation.draw(Run(self.folder), self.view)
        figure.canvas.draw()
        for panel in figure.axes[:2]:
            key = next(each for each in panel.get_children() if isinstance(each, QuiverKey))
            self.assertLess(key.text.get_window_extent().y1, panel.get_window_extent().y0)

    def test_an_event_after_the_end_of_the_history_is_not_drawn(self):
        rows = (self.folder / "events.csv").read_text().splitlines()
        late = rows[1].split(",")
        last = float(self.run_.fault.time[-1])
        late[1], late[2] = str(last + 1e6), str(last + 1e6 + 3.0)
        (self.folder / "events.csv").write_text("\n".join([rows[0], ",".join(late)]) + "\n")
        run = Run(self.folder)
        with self.assertRaisesRegex(NothingToShow, "fault.h5 ends before the event"):
            fault_maps.draw(run, windows.choose(run, None))
        slip = fault_maps.event_slip(run, last, last + 1e6)
        np.testing.assert_array_equal(slip, 0.0)

    def test_events_share_a_rupture_that_goes_on_through_them(self):
        strike, dip, _ = surface.grid()
        times, middle = surface.arrivals(strike, dip), 1.0
        rows = (self.folder / "events.csv").read_text().splitlines()
        second = rows[1].split(",")
        first = ["1", *second[1:]]
        first[2], first[3] = str(surface.ONSET + middle), str(middle)
        second[0], second[1] = "2", str(surface.ONSET + middle + 0.2)
        (self.folder / "events.csv").write_text(
            "\n".join([rows[0], ",".join(first), ",".join(second)]) + "\n")
        run = Run(self.folder)
        early, late = fault_maps.arrivals(run, 0), fault_maps.arrivals(run, 1)
        np.testing.assert_array_equal(np.isfinite(early), times <= middle)
        np.testing.assert_array_equal(np.isfinite(late), times > middle)
        self.assertEqual(np.nanmin(late), 0.0)

    def test_colour_bars_are_as_high_as_their_panels(self):
        for size in ((21, 11), (21, 5), (21, 21), (9, 31)):
            with self.subTest(size=size), mock.patch.multiple(surface, NX=size[0], NZ=size[1]), \
                    tempfile.TemporaryDirectory() as name:
                surface.write_run(Path(name))
                run = Run(Path(name))
                figure = fault_maps.draw(run, windows.choose(run, None))
                figure.canvas.draw()
                bars = [(each.ax, each.mappable.axes) for each in
                        (image.colorbar for panel in figure.axes for image in panel.collections)
                        if each is not None]
                self.assertEqual(len(bars), 2)
                for bar, panel in bars:
                    heights = [axes.get_window_extent().height for axes in (bar, panel)]
                    self.assertLess(abs(heights[0] / heights[1] - 1.0), 0.01)

    def test_patterns_show_what_was_reached(self):
        where = plane.plane(self.run_, self.run_.ruptures)
        rows, fronts = rupture_patterns.chosen(self.run_, self.view)
        self.assertEqual(rows, [0])
        across, down = rupture_patterns.extent(where, fronts)
        # The radius of 3.5 km about (2.5, 2) km, in nodes, with a tenth of it around; the fault
        # ends at 0 and 5 km.
        np.testing.assert_allclose(across, [0.0, 6.6])
        np.testing.assert_allclose(down, [0.0, 5.0])
        outside = replace(self.view, sequence=(0.0, surface.ONSET - 1.0))
        with self.assertRaises(NothingToShow):
            rupture_patterns.draw(self.run_, outside)

    def test_values_along_the_line(self):
        where = plane.plane(self.run_, self.run_.fault)
        depth, reason = fault_history.line_depth(self.run_, where)
        self.assertEqual(reason, "the hypocentre of the largest event, 1")
        self.assertAlmostEqual(depth, surface.HYPOCENTRE[1])
        points, weights = fault_history.line(where, depth)
        np.testing.assert_allclose(weights @ (where.strike + 3.0 * where.dip),
                                   points + 3.0 * depth, rtol=1e-9)
        times, peak, along = fault_history.rates(self.run_, self.view.cycles, where, weights)
        self.assertEqual(along.shape, (times.size, points.size))
        rate = self.run_.fault.array("fields/slip_rate")
        np.testing.assert_allclose(10.0**peak, rate.max(axis=1))

    def test_no_event_is_lost_between_two_columns(self):
        times, values = np.arange(1000.0), np.zeros((1000, 2))
        values[123, 1] = 7.0
        shown = fault_history.maxima(times, values, np.linspace(0.0, 999.0, 11))
        np.testing.assert_array_equal(shown[:, 1], [0, 7] + 8 * [0])
        sparse = fault_history.maxima(np.array([0.0, 9.0]), np.array([[1.0], [2.0]]),
                                      np.linspace(0.0, 9.0, 4))
        np.testing.assert_array_equal(sparse[:, 0], [1, 1, 1])

    def test_moment_rate_is_of_the_whole_fault(self):
        figure = moment_rate.draw(self.run_, self.view)
        self.assertRegex(figure.axes[0].get_ylabel(), r"^Moment rate \[.*N m/s\]$")

    def test_all_figures_of_the_run(self):
        status, out, _ = told(main, self.folder, "--dpi", "50")
        self.assertEqual(status, 0)
        for name in ("fault_maps", "rupture_patterns", "fault_history", "moment_rate"):
            self.assertTrue((self.folder / "figures" / f"{name}.png").exists(), out)
        status, out, _ = told(main, self.folder, "--events")
        self.assertEqual(status, 0)
        self.assertIn("Mw", out)

    def test_in_two_dimensions_there_are_none(self):
        folder = self.folder / "plane"
        synthetic_run.write_run(folder, num_events=2)
        run = Run(folder)
        for module in (fault_maps, fault_history):
            with self.assertRaises(NothingToShow):
                module.draw(run, windows.choose(run, None))
