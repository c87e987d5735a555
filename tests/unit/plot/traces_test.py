"""Maps of several faults in the plane, and the panels of a network."""

import numpy as np
from matplotlib import pyplot
from matplotlib.collections import LineCollection

import synthetic_network as network
import synthetic_run
from asperity_plot import (along, rupture_times, slip, slip_profiles, slip_rate, style, trace_names,
                           traces, windows)
from asperity_plot.cli import main
from asperity.errors import OtherModel
from asperity.run import Run
from folders import FolderCase, told

MANY = {f"strand_{number}": ((0.0, 1e3 * number), (4e3, 1e3 * number - 500.0))
        for number in range(12)}


class Traces(FolderCase):
    def setUp(self):
        super().setUp()
        network.write_run(self.folder)
        self.run_ = Run(self.folder)
        self.view = windows.choose(self.run_, None)
        style.use()
        self.addCleanup(pyplot.close, "all")

    def test_crossings_junctions_and_tips_are_where_they_are(self):
        found = traces.places(self.run_.fault, along.pieces(self.run_.fault))
        np.testing.assert_allclose(found["crossing"], [(4e3, 0.0)])
        np.testing.assert_allclose(found["junction"], [(1e3, 0.0)])
        expected = [(0, 0), (8e3, 0), (4e3, 3e3), (4e3, -3e3), (3e3, 2e3), (5e3, -2e3), (9e3, -4e3)]
        np.testing.assert_allclose(found["tip"], expected, atol=1e-9)

    def test_an_end_that_slips_is_no_tip(self):
        """It lies on the boundary of the body."""
        history = self.folder / "other.h5"
        faults = network.curves()
        values = network.fields(network.times(), faults)
        values["slip"][:, 0] = np.linspace(0.0, 1.0, network.times().size)
        synthetic_run.write_history(history, network.times(),
                                    np.concatenate(list(faults.values())), values)
        fault = traces.History(history)
        found = traces.places(fault, along.pieces(self.run_.fault))
        self.assertNotIn([0.0, 0.0], found["tip"].tolist())

    def test_slip_and_peak_rate_of_the_event_are_the_colours(self):
        """The zoom shows event 2, of `across` and `through`."""
        self.assertEqual(self.view.number, 2)
        axes = traces.draw(self.run_, self.view).axes
        colours = [next(each for each in panel.collections if isinstance(each, LineCollection)
                        and each.get_array() is not None) for panel in axes[:2]]
        last = network.fields(np.array([network.FINAL]), network.curves())["slip"][0]
        self.assertAlmostEqual(float(colours[0].get_array().max()), 2.5, delta=0.05)
        segments = colours[0].get_segments()
        self.assertEqual(len(segments), last.size - 4)  # none from one fault to the next
        middle = np.array([np.mean(each, axis=0) for each in segments])
        rate = np.asarray(colours[1].get_array())
        is_across = (np.abs(middle[:, 0] - 4.0) < 1e-9) & (middle[:, 1] != 0.0)
        is_apart = middle[:, 1] < -2.0
        self.assertAlmostEqual(rate[is_across].max(), 1.0 / 8.0, delta=0.002)
        self.assertLess(rate[is_apart & ~is_across].max(), 1e-9)

    def test_the_star_is_where_the_event_began(self):
        panel = traces.draw(self.run_, self.view).axes[1]
        star = next(line for line in panel.lines if line.get_marker() == "*")
        np.testing.assert_allclose(star.get_xydata(), [[4.0, 0.0]], atol=1e-9)

    def test_every_fault_has_its_name(self):
        panel = traces.draw(self.run_, self.view).axes[0]
        self.assertEqual([text.get_text() for text in panel.texts], list(network.ENDS))

    def test_names_keep_clear_of_traces_and_of_each_other(self):
        curves = list(network.curves().items())
        names = trace_names.arranged(curves, 200.0)
        self.assertEqual([name.text for name in names], list(network.ENDS))
        boxes = [trace_names._box(name, 200.0) for name in names]
        for number, box in enumerate(boxes):
            others = [nodes for k, (_, nodes) in enumerate(curves) if k != number]
            others += [each for k, each in enumerate(boxes) if k != number]
            away = np.linalg.norm(box[:, None] - np.concatenate(others), axis=-1).min()
            self.assertGreater(away, 200.0, names[number].text)

    def test_without_an_event_there_is_one_map(self):
        (self.folder / "events.csv").unlink()
        run = Run(self.folder)
        figure = traces.draw(run, windows.choose(run, None))
        self.assertEqual(len(figure.axes), 1)

    def test_a_single_fault_has_no_map(self):
        synthetic_run.write_run(self.folder / "single", 1, nodes=20)
        run = Run(self.folder / "single")
        with self.assertRaises(OtherModel):
            traces.draw(run, windows.choose(run, None))
        _, out, _ = told(main, run.directory, "--dpi", "40")
        self.assertNotIn("traces", out)

    def test_the_program_draws_it(self):
        status, out, err = told(main, self.folder, "--dpi", "40")
        self.assertEqual((status, err), (0, ""))
        for name in ("traces", "slip_rate", "slip_profiles", "slip"):
            self.assertIn(f"{name}.png", out)


class ManyFaults(FolderCase):
    """Each of twelve faults has a panel, its name, and positions from its own upper end."""

    def setUp(self):
        super().setUp()
        network.write_run(self.folder, {**network.ENDS, **MANY})
        self.run_ = Run(self.folder)
        self.view = windows.choose(self.run_, None)
        style.use()
        self.addCleanup(pyplot.close, "all")
        self.names = [*network.ENDS, *MANY]

    def test_slip_rate(self):
        figure = slip_rate.draw(self.run_, self.view)
        panels = [panel for panel in figure.axes if panel.get_ylabel()
                  and panel.get_ylabel() != "Slip rate V [m/s]"]
        self.assertEqual([panel.get_ylabel().replace("\n", "") for panel in panels], self.names)
        for panel in panels[1:2] + panels[4:]:  # down from the upper end
            self.assertEqual(panel.get_ylim()[1], 0.0)
        self.assertEqual(figure._supylabel.get_text(), "Distance from the upper end of the fault "
                                                       "[km]")

    def test_panels_of_profiles(self):
        for module in (slip, slip_profiles):
            axes = module.draw(self.run_, self.view).axes[:len(self.names)]
            self.assertEqual([panel.get_title(loc="right") for panel in axes], self.names)
            slips = {panel.get_ylim() for panel in axes}  # all are comparable
            self.assertEqual(len(slips), 1)

    def test_faults_are_alike_where_one_is_level(self):
        faults = along.faults(self.run_, self.run_.fault)
        self.assertEqual({where.is_downwards for where in faults}, {True, False})
        self.assertEqual({where.is_downwards for where in along.alike(faults)}, {False})

    def test_labels_that_all_panels_share_stand_at_the_rim(self):
        faults = along.alike(along.faults(self.run_, self.run_.fault))
        _, axes = style.fault_panels(faults, (7.5, 5.0))
        for panel in axes:
            panel.set(xlabel="across", ylabel="up")
        style.share_labels(axes)
        self.assertEqual([panel.get_ylabel() for panel in axes[:5]], ["up", "", "", "", "up"])
        self.assertEqual([panel.get_xlabel() for panel in axes[-5:]], ["", *4 * ["across"]])
        self.assertIs(style.upper_right(axes), axes[style.COLUMNS - 1])

    def test_very_many_pieces_share_an_axis(self):
        more = {f"piece_{number}": ((1e4, 1e3 * number), (1.2e4, 1e3 * number))
                for number in range(along.MOST_FAULTS)}
        network.write_run(self.folder / "more", {**network.ENDS, **more})
        run = Run(self.folder / "more")
        self.assertEqual(len(along.faults(run, run.fault)), 1)
        self.assertEqual(len(along.pieces(run.fault)), along.MOST_FAULTS + len(network.ENDS))
