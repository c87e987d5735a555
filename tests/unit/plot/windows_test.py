"""Which stretch of a run is shown, and what the deck says about the wedge."""

import numpy as np

import synthetic_run
from asperity import wedge
from asperity_plot import windows
from asperity.errors import InputError
from asperity.parameters import Parameters
from asperity.run import Run
from folders import FolderCase


class Windows(FolderCase):
    def run_with(self, events: str, deck: str = "") -> Run:
        steps = "step,time [s],step_size [s]\n"
        steps += "\n".join(f"{time},{time},1" for time in range(1, 1001))
        (self.folder / "steps.csv").write_text(steps + "\n")
        header = "number,onset [s],duration [s],peak_slip [m],complete\n"
        (self.folder / "events.csv").write_text(header + events)
        if deck:
            (self.folder / "parameters.xml").write_text(deck)
        return Run(self.folder)

    def test_a_median_event_of_the_second_half(self):
        slips = [9, 9, 9, 9, 9, 1, 5, 3, 2, 4]
        run = self.run_with("".join(f"{n},{100 * n - 50},0.1,{slip},1\n"
                                    for n, slip in enumerate(slips, start=1)))
        view = windows.choose(run, None)
        self.assertEqual(view.number, 8)
        self.assertAlmostEqual(view.onset, 750.0)
        np.testing.assert_allclose(view.cycles, (500.0, 1000.0))
        np.testing.assert_allclose(view.zoom, (749.9, 750.3))
        self.assertEqual(view.num_events, 5)

    def test_an_event_cut_off_by_the_end_is_not_chosen(self):
        run = self.run_with("1,200,0.1,1,1\n2,600,0.1,1,1\n3,999,0.1,1,0\n")
        self.assertEqual(windows.choose(run, None).number, 2)
        self.assertEqual(len(run.events), 3)
        self.assertEqual(windows.choose(run, (500.0, 1000.0)).num_events, 2)

    def test_tiny_events_do_not_choose_what_is_shown(self):
        rows = [(100 * n, 1.0) for n in range(1, 10)]
        rows += [(100 * n + part, 0.01) for n in range(5, 10) for part in (10, 20, 30, 40)]
        run = self.run_with("".join(f"{n},{onset},0.1,{slip},1\n"
                                    for n, (onset, slip) in enumerate(sorted(rows), start=1)))
        view = windows.choose(run, None)
        self.assertEqual(view.onset % 100.0, 0.0)
        np.testing.assert_allclose(view.cycles[1] - view.cycles[0], 500.0)

    def test_no_event(self):
        view = windows.choose(self.run_with(""), None)
        self.assertEqual(view.cycles, (0.0, 1000.0))
        self.assertIsNone(view.zoom)
        self.assertTrue(view.whole_run)

    def test_one_event(self):
        view = windows.choose(self.run_with("1,200,0.1,1,1\n"), None)
        self.assertEqual(view.cycles, (0.0, 1000.0))
        self.assertEqual(view.number, 1)

    def test_window_of_the_user(self):
        run = self.run_with("1,200,0.1,1,1\n2,600,0.1,1,1\n")
        view = windows.choose(run, (500.0, 5000.0))
        self.assertEqual(view.cycles, (500.0, 1000.0))
        self.assertEqual(view.number, 2)
        self.assertIsNone(windows.choose(run, (300.0, 500.0)).zoom)
        for window in ((5.0, 5.0), (2000.0, 3000.0), (-5.0, -1.0)):
            with self.assertRaisesRegex(InputError, "--window"):
                windows.choose(run, window)

    def test_the_sequence_is_the_whole_run_unless_it_has_many_events(self):
        def row(number: int) -> str:
            return f"{number},{20 * number},0.1,1,1\n"
        run = self.run_with("".join(row(number) for number in range(1, 41)))
        view = windows.choose(run, None)
        self.assertEqual(view.sequence, (0.0, 1000.0))
        whole = windows.over_sequence(run, view)
        self.assertEqual((whole.cycles, whole.num_events), ((0.0, 1000.0), 40))
        self.assertEqual(windows.choose(run, (10.0, 100.0)).sequence, (10.0, 100.0))
        run = self.run_with("".join(row(number) for number in range(1, 42)))
        view = windows.choose(run, None)
        self.assertEqual(view.sequence, view.cycles)
        self.assertEqual(windows.over_sequence(run, view), view)

    def test_the_wedge(self):
        run = self.run_with("", synthetic_run.PARAMETERS)
        end = 0.35 * np.sqrt(1.0 + 0.27**2)
        np.testing.assert_allclose(wedge.seismogenic_zones(run.parameters), [(end - 0.2, end)])
        further = '<Parameter name="Refined Intervals" type="Array(double)" ' \
                  'value="{0.6, 0.7, 0.05, 0.1}"/>\n'
        mark = '<ParameterList name="Wedge">\n'
        run = self.run_with("", synthetic_run.PARAMETERS.replace(mark, mark + further))
        np.testing.assert_allclose(wedge.seismogenic_zones(run.parameters),
                                   [(0.05, 0.1), (end - 0.2, end), (0.6, 0.7)])

    def test_up_is_against_gravity_or_off_the_surface_of_the_wedge_or_y(self):
        up = (-np.sin(np.arctan(0.27)), np.cos(np.arctan(0.27)))
        deck = synthetic_run.PARAMETERS
        np.testing.assert_allclose(self.run_with("", deck).upwards(2), up)
        deck = deck.replace("9.81", "0").replace("{0.27, -1.0}", "{0, -1}")
        np.testing.assert_allclose(self.run_with("", deck).upwards(2), up)
        deck = '<ParameterList name="Asperity"><ParameterList name="Bulk">' \
               '<Parameter name="Gravity Direction" type="Array(double)" value="{6.0, -8.0}"/>' \
               '</ParameterList></ParameterList>'
        run = self.run_with("", deck)
        np.testing.assert_allclose(run.upwards(2), (-0.6, 0.8))
        self.assertEqual(wedge.seismogenic_zones(run.parameters), [])
        (self.folder / "parameters.xml").unlink()
        np.testing.assert_allclose(Run(self.folder).upwards(3), (0.0, 1.0, 0.0))

    def test_parameters_by_path(self):
        parameters = Parameters({"A/x": "-1.5e-3", "A/f": "2*x", "A/v": "{1, 2.5}"})
        self.assertEqual(parameters.number("A/x"), -1.5e-3)
        self.assertIsNone(parameters.number("A/f"))
        self.assertEqual(parameters.numbers("A/v"), [1.0, 2.5])
        self.assertEqual(parameters.numbers("A/absent"), [])
