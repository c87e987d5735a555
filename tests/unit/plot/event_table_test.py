"""The tables of events, cycles and energies: their numbers, and Markdown."""

import unittest

import h5py
import numpy as np

import synthetic_cycle as cycle
from asperity_plot import cli, event_table, markdown, units, windows
from asperity.errors import InputError, NothingToShow
from asperity_plot.windows import Options
from asperity.run import Run
from folders import FolderCase, told


class EventTables(FolderCase):
    def setUp(self):
        super().setUp()
        cycle.write_run(self.folder)

    def columns(self, **options):
        """Values by header."""
        run = Run(self.folder)
        columns = event_table.events(run, windows.choose(run, None, Options(**options)))
        return {column.header: np.asarray(column.values) for column in columns}

    def cycles(self):
        return {column.header: column.values for column in event_table.cycles(Run(self.folder))}

    def edit(self, name: str, old: str, new: str) -> None:
        text = (self.folder / name).read_text()
        self.assertIn(old, text)
        (self.folder / name).write_text(text.replace(old, new))

    def test_events(self):
        columns = self.columns()
        self.assertEqual(list(columns)[:6], ["event", "onset [yr]", "recurrence [yr]",
                                             "duration [s]", "peak slip rate [m/s]",
                                             "largest slip [m]"])
        np.testing.assert_allclose(columns["onset [yr]"], cycle.ONSETS)
        self.assertTrue(np.isnan(columns["recurrence [yr]"][0]))
        np.testing.assert_allclose(columns["recurrence [yr]"][1:] / units.YEAR,
                                   [75.6, 77.8, 78.3])
        np.testing.assert_allclose(columns["largest slip [m]"], cycle.offsets())
        moment = columns["moment per length [N]"]
        np.testing.assert_allclose(moment, 32e9 * 16.5e3 * cycle.offsets())
        np.testing.assert_allclose(10.0**(1.5 * columns["Mw of 1 km"] + 9.1), 1e3 * moment)

    def test_a_single_event_has_no_recurrence(self):
        lines = (self.folder / "events.csv").read_text().splitlines()
        (self.folder / "events.csv").write_text("\n".join(lines[:2]) + "\n")
        self.assertTrue(np.isnan(self.columns()["recurrence [yr]"]).all())

    def test_slip_at_receivers_is_that_from_onset_to_end(self):
        columns = self.columns(receivers=("dp050", "dp150", "dp200"))
        self.assertEqual([name for name in columns if " at " in name],
                         ["slip at dp050 [m]", "slip at dp150 [m]", "slip at dp200 [m]"])
        for name in ("dp050", "dp150"):
            np.testing.assert_allclose(columns[f"slip at {name} [m]"], cycle.offsets(), rtol=1e-9)
        np.testing.assert_allclose(columns["slip at dp200 [m]"], 1e-9 * cycle.duration(),
                                   rtol=1e-5)

    def test_slip_at_depths_between_nodes(self):
        columns = self.columns(depths=(16.3e3, 0.0))
        # 16.3 km lies between nodes at 16 and 16.5 km; all is linear there.
        share = (18.0 - 16.3) / 3.0
        np.testing.assert_allclose(columns["slip at 16.3 km [m]"], share * cycle.offsets(),
                                   rtol=1e-6)
        np.testing.assert_allclose(columns["slip at 0 km [m]"], cycle.offsets(), rtol=1e-9)
        with self.assertRaisesRegex(InputError, "--at 50000 m lies outside .* 0 m to 48000 m"):
            self.columns(depths=(5e3, 5e4))

    def test_places_on_a_buried_fault_count_from_its_upper_end(self):
        """The same fault 2 km deeper has the same slips 16.3 km below its upper end."""
        before = self.columns(depths=(16.3e3,))["slip at 16.3 km [m]"]
        for name in ("fault.h5", "rupture.h5"):
            with h5py.File(self.folder / name, "a") as file:
                file["geometry/coordinates"][:, 1] -= 2e3
        np.testing.assert_allclose(self.columns(depths=(16.3e3,))["slip at 16.3 km [m]"], before)
        with self.assertRaisesRegex(InputError, "the distance from the upper end .* 0 m to 48000"):
            self.columns(depths=(49e3,))

    def test_cycles_sum_to_the_run(self):
        columns = self.cycles()
        times = cycle.row_times()[1:]
        ends = cycle.ONSETS + cycle.duration()
        counts = [np.count_nonzero(times < ends[0])]
        counts += [np.count_nonzero((times >= first) & (times < last))
                   for first, last in zip(ends, ends[1:])]
        counts[0] += 1  # the step that ends with the event, here exactly
        np.testing.assert_array_equal(columns["accepted steps"][:4], counts)
        self.assertEqual(columns["accepted steps"][4], times.size)
        self.assertEqual(columns["event"], ["1", "2", "3", "4", "whole run"])
        for name, factor in (("coupled steps", 2), ("rate problems", 3), ("TNNMG iterations", 5),
                             ("coupled per accepted", None)):
            expected = factor * columns["accepted steps"] if factor else 2.0
            np.testing.assert_allclose(columns[name], expected, rtol=1e-12)
        self.assertNotIn("V-cycles", columns)

    def test_a_first_event_that_is_left_out_takes_its_steps_with_it(self):
        before = self.cycles()["accepted steps"]
        run = Run(self.folder).select(start=cycle.ONSETS[0] + cycle.duration() + 1.0)
        columns = {column.header: column.values for column in event_table.cycles(run)}
        self.assertEqual(columns["event"], ["2", "3", "4", "whole run"])
        np.testing.assert_array_equal(columns["accepted steps"], before[1:])

    def test_cycles_without_some_columns(self):
        self.edit("steps.csv", "coupled_steps", "others")
        self.assertEqual(list(self.cycles()),
                         ["event", "accepted steps", "rate problems", "TNNMG iterations"])
        (self.folder / "steps.csv").unlink()
        with self.assertRaisesRegex(NothingToShow, "no steps.csv"):
            self.cycles()

    def test_energy(self):
        columns = {column.header: column.values
                   for column in event_table.energy(Run(self.folder))}
        np.testing.assert_allclose(columns["friction work [J/m]"], 1e9 * np.arange(1, 5))
        np.testing.assert_allclose(columns["numerical dissipation [J/m]"], 2e5 * np.arange(1, 5))
        np.testing.assert_allclose(columns["defect / friction work"], -3e-5)
        self.edit("events.csv", "energy_defect", "unknown")
        with self.assertRaisesRegex(NothingToShow, "no friction_work and energy_defect"):
            event_table.energy(Run(self.folder))

    def test_an_event_cut_off_by_the_end(self):
        lines = (self.folder / "events.csv").read_text().splitlines()
        lines[4] = lines[4].replace(",12000,1,", ",12000,0,")
        (self.folder / "events.csv").write_text("\n".join(lines) + "\n")
        run = Run(self.folder)
        text = event_table.text(run, windows.choose(run, None))
        self.assertIn("The end of the run cut off the last event.", text)
        self.assertEqual(self.cycles()["event"], ["1", "2", "3", "whole run"])
        self.assertEqual(self.columns()["event"].size, 4)

    def plot(self, *arguments: str):
        return told(cli.main, self.folder, "--events", *arguments)

    def test_the_command_prints_markdown_and_draws_nothing(self):
        status, out, err = self.plot("--at", "5000")
        self.assertEqual((status, err), (0, ""))
        self.assertIn("\n| event | onset [yr] | recurrence [yr] |", out)
        self.assertIn("\n| 2 | 272.000 | 75.60 | 10.00 | 0.5964 | 2.386 | 2.386 | 1.260e+15 |", out)
        for heading in ("### Events", "### Cycles", "### Energy of the events"):
            self.assertIn(heading, out)
        self.assertIn("A year has 365.25 days.", out)
        self.assertIn("at least 1 mm/s anywhere", out)
        self.assertIn("Moments and largest slips count a node only while it is at least that fast",
                      out)
        self.assertFalse((self.folder / "figures").exists())

    def test_figures_besides_if_asked_for(self):
        status, out, _ = self.plot("--figures", "rupture_times", "--dpi", "40")
        self.assertEqual(status, 0)
        self.assertEqual([path.name for path in (self.folder / "figures").iterdir()],
                         ["rupture_times.png"])
        self.assertNotIn("quartile", out)

    def test_without_events_one_clear_message(self):
        (self.folder / "events.csv").unlink()
        status, out, err = self.plot()
        self.assertEqual((status, out), (2, ""))
        self.assertEqual(err.count("asperity-plot: "), 1)
        self.assertIn("events.csv does not exist. Is this output enabled", err)

    def test_tables_alone(self):
        for name in ("fault.h5", "receivers.h5", "global.csv", "rupture.h5"):
            (self.folder / name).unlink()
        status, out, _ = self.plot()
        self.assertEqual(status, 0)
        self.assertNotIn("slip at", out.split("\n\n")[1])
        status, _, err = self.plot("--at", "5000")
        self.assertEqual(status, 2)
        self.assertIn("fault.h5 does not exist", err)

    def test_no_event(self):
        header = (self.folder / "events.csv").read_text().splitlines()[0]
        (self.folder / "events.csv").write_text(header + "\n")
        self.assertEqual(self.plot()[:2], (0, "No event.\n"))


class Markdown(unittest.TestCase):
    def test_cells(self):
        columns = [markdown.Column("n", [1.0, 12345.0], digits=0),
                   markdown.Column("x", [0.0012345, float("nan")], units.Unit("mm", 1e-3), 3),
                   markdown.Column("y", [1.5e-7, 2.34567e6]), markdown.Column("z", ["a", 0.0])]
        self.assertEqual(markdown.table(columns),
                         "| n | x [mm] | y | z |\n| ---: | ---: | ---: | ---: |\n"
                         "| 1 | 1.23 | 1.500e-07 | a |\n| 12,345 |  | 2.346e+06 | 0 |")
