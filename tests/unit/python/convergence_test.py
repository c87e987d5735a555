"""Studies of convergence: runs, observed orders, events that correspond, and the tables."""

import csv
from pathlib import Path

import h5py
import numpy as np

from asperity.errors import InputError
from asperity.run import Run
from asperity.selection import Selection
from asperity_study import cli, convergence, convergence_text, of_deck, order, quantities, study
from asperity_study.quantities import Quantity
from asperity_study.runner import Job
from folders import FolderCase

DECK = """<ParameterList name="Asperity">
  <ParameterList name="Mesh"><Parameter name="Cells" value="16"/>
    <Parameter name="Size" value="100"/><Parameter name="Formula" value="100 + x"/>
  </ParameterList>
  <ParameterList name="Time"><Parameter name="Tolerance" value="1e-3"/></ParameterList>
  <ParameterList name="Output"><ParameterList name="Receivers"><ParameterList name="On Fault">
    <Parameter name="st05" value="{5, 0}"/></ParameterList></ParameterList></ParameterList>
</ParameterList>"""
CELLS = '<Parameter name="Parameters" value="{Mesh/Size}"/>'
STEPS = ('<Parameter name="Parameters" value="{Time/Tolerance, Coupling/Tolerance}"/>'
         '<Parameter name="Ratio" value="8"/>')
COUPLING = ('<ParameterList name="Settings"><Parameter name="Coupling/Tolerance" value="1e-5"/>'
            '</ParameterList>')
ONSET, COUNT = Quantity("onset", "s"), convergence.EVENTS


class Studies(FolderCase):
    def write(self, cells: str = CELLS, steps: str = STEPS, rest: str = COUPLING) -> Path:
        (self.folder / "deck.xml").write_text(DECK)
        path = self.folder / "study.xml"
        path.write_text(f"""<ParameterList name="Asperity Study">
          <Parameter name="Deck" value="deck.xml"/>
          <Parameter name="Sampling" value="Convergence"/>{rest}
          <ParameterList name="Variables"><ParameterList name="cells">{cells}</ParameterList>
            <ParameterList name="steps">{steps}</ParameterList></ParameterList></ParameterList>""")
        return path

    def refuse(self, words: str, *arguments, **options):
        with self.assertRaisesRegex(InputError, words):
            study.read(self.write(*arguments, **options)).runs()


class OfDecks(FolderCase):
    """asperity-study --convergence; a program that prints defaults stands for asperity."""

    DEFAULTS = {"Mesh/Type": "Wedge", "Mesh/Refinements": "0", "Mesh/Wedge/Cell Size": "0.002",
                "Mesh/Box/Cell Size Factor": "1", "Time Stepping/Control": "Step Doubling",
                "Time Stepping/Step Doubling/Tolerance": "1e-5",
                "Time Stepping/Largest Step": "", "Coupling/Tolerance": "1e-5"}

    def write(self, values, name) -> Path:
        entries = ""
        for path, value in values.items():
            *lists, last = path.split("/")
            entries += "".join(f'<ParameterList name="{each}">' for each in lists)
            entries += f'<Parameter name="{last}" value="{value}"/>'
            entries += "</ParameterList>" * len(lists)
        path = self.folder / name
        path.write_text(f'<ParameterList name="Asperity">{entries}</ParameterList>')
        return path

    def variables(self, deck, changes=(), coarser=False):
        """Of each variable the overrides of its three levels, the others as in the deck."""
        program = self.folder / "asperity"
        program.write_text(f"#!/bin/sh\ncat {self.write(self.DEFAULTS, 'defaults.xml')}\n")
        program.chmod(0o755)
        what = of_deck.convergence(self.write(deck, "deck.xml"), program, list(changes), coarser)
        self.assertEqual(len(what.runs()), 1 + 2 * len(what.variables))
        return {each.name: [each.settings(value) for value in each.values]
                for each in what.variables}, what

    def test_halves_cells_and_steps_by_what_the_deck_gives_or_its_defaults(self):
        deck = {"Time Stepping/Largest Step": "4", "Output/Receivers/On Fault/st05": "{5, 0}"}
        found, what = self.variables(deck, ["Coupling/Tolerance=8e-8"])
        step, coupling = "Time Stepping/Step Doubling/Tolerance", "Coupling/Tolerance"
        self.assertEqual(found["cells"], [{"Mesh/Wedge/Cell Size": value}
                                          for value in ("0.002", "0.001", "0.0005")])
        self.assertEqual(found["tolerance"],
                         [{step: "1e-5", coupling: "8e-8"},
                          {step: repr(1e-5 / 8), coupling: repr(8e-8 / 8)},
                          {step: repr(1e-5 / 64), coupling: repr(8e-8 / 64)}])
        self.assertEqual(found["largest step"], [{"Time Stepping/Largest Step": value}
                                                 for value in ("4", "2", "1")])
        self.assertEqual(what.receivers, ("st05",))

    def test_theory_and_expected_cost(self):
        deck = {"Time Stepping/Largest Step": "4", "Bulk/Model": "Solid"}
        _, what = self.variables(deck)
        self.assertEqual([each.refinement.order for each in what.variables], [2.0, 2.0 / 3.0, 2.0])
        # the deck; cells 2^3 and 4^3; tolerances and largest steps each 2 and 4
        self.assertIn("7 runs, which together cost about 85 times what the deck itself does, the "
                      "dearest 64 times", cli.expectation(what, what.runs()))
        _, what = self.variables({**deck, "Time Stepping/Scheme": "Backward Euler"})
        self.assertEqual([each.refinement.order for each in what.variables], [2.0, 0.5, 1.0])
        _, what = self.variables({"Time Stepping/Largest Step": "4"}, coarser=True)
        self.assertIn("7 runs, which together cost about 2.81 times",  # 1 + 1/4 + 1/16 + 2 * 3/4
                      cli.expectation(what, what.runs()))

    def test_doubles_where_the_deck_is_to_be_the_finest(self):
        deck = {"Mesh/Type": "Box", "Mesh/Box/Cell Size": "100 + x",
                "Time Stepping/Largest Step": "4"}
        found, _ = self.variables(deck, coarser=True)
        self.assertEqual(found["cells"], [{"Mesh/Box/Cell Size Factor": value}
                                          for value in ("1", "2", "4")])
        self.assertEqual(found["largest step"][2], {"Time Stepping/Largest Step": "16"})

    def test_refines_meshes_without_a_size_and_steps_without_a_tolerance(self):
        deck = {"Mesh/Type": "File", "Time Stepping/Control": "Prescribed",
                "Time Stepping/Largest Step": "4", "Time Stepping/Smallest Step": "0.5"}
        found, _ = self.variables(deck)
        self.assertEqual(found["cells"], [{"Mesh/Refinements": value} for value in "012"])
        self.assertEqual(found["step"][1], {"Time Stepping/Largest Step": "2",
                                            "Time Stepping/Smallest Step": "0.25"})

    def test_a_formula_of_names_is_divided(self):
        deck = {"Names/longest": "4", "Time Stepping/Largest Step": "longest"}
        found, _ = self.variables(deck)
        self.assertEqual([each["Time Stepping/Largest Step"] for each in found["largest step"]],
                         ["longest", "(longest) / 2.0", "(longest) / 4.0"])
        found, _ = self.variables({"Time Stepping/Largest Step": "32 * day"})
        self.assertEqual(found["largest step"][1], {"Time Stepping/Largest Step":
                                                    "(32 * day) / 2.0"})

    def test_what_cannot_be_refined_is_refused(self):
        for field in ("32 * x", "{4, 2}", "Richardson"):
            with self.assertRaisesRegex(InputError,
                                        "largest step .--set may give a number.*no number"):
                self.variables({"Time Stepping/Largest Step": field})
        with self.assertRaisesRegex(InputError, "--set 4: 'Path/To/Parameter=value' is wanted"):
            self.variables({"Time Stepping/Largest Step": "4"}, ["4"])


class Runs(Studies):
    def overrides(self, *arguments, **options):
        what = study.read(self.write(*arguments, **options))
        return [what.overrides(values) for values in what.runs()]

    def test_one_variable_after_the_other_is_refined_and_the_deck_is_the_first_run(self):
        cells, steps = ("Mesh/Size", ("100", "50", "25")), (
            ("1e-3", "1e-5"), ("0.000125", "1.25e-06"), ("1.5625e-05", "1.5625e-07"))
        self.assertEqual(
            [set(each) for each in self.overrides()],
            [{f"{cells[0]}={cells[1][cell]}", f"Time/Tolerance={steps[step][0]}",
              f"Coupling/Tolerance={steps[step][1]}"}
             for cell, step in ((0, 0), (1, 0), (2, 0), (0, 1), (0, 2))])

    def of_cells(self, entries: str):
        what = study.read(self.write(f'<Parameter name="Parameters" value="Mesh/Cells"/>{entries}'))
        return [each[1].split("=")[1] for each in map(what.overrides, what.runs()[:4])
                if each[1].startswith("Mesh/Cells")]

    def test_numbers_are_multiplied_halvings_added_and_a_ratio_below_one_is_coarser(self):
        ratio = '<Parameter name="Ratio" value="{}"/><Parameter name="Change" value="{}"/>'
        levels = '<Parameter name="Levels" value="4"/>'
        self.assertEqual(self.of_cells(levels + ratio.format(2, "Multiply")),
                         ["16", "32", "64", "128"])
        self.assertEqual(self.of_cells(levels + ratio.format(0.5, "Multiply")),
                         ["16", "8", "4", "2"])
        self.assertEqual(self.of_cells(levels + ratio.format(4, "Add")), ["16", "18", "20", "22"])
        self.assertEqual(self.of_cells(levels + ratio.format(0.5, "Divide")),
                         ["16", "32", "64", "128"])

    def test_what_is_wrong_is_named(self):
        self.refuse("cells: Levels = '2'; a whole number from 3",
                    CELLS + '<Parameter name="Levels" value="2"/>')
        for ratio in ("1", "0", "-2"):
            self.refuse(f"cells: Ratio = {ratio}; a positive number other than 1",
                        CELLS + f'<Parameter name="Ratio" value="{ratio}"/>')
        self.refuse("Change = Add a power of 2", CELLS + '<Parameter name="Ratio" value="3"/>'
                    '<Parameter name="Change" value="Add"/>')
        self.refuse("'Mesh/Formula' = '100 . x' is no number", CELLS.replace("Size", "Formula"))
        self.refuse("neither the deck nor Settings gives 'Coupling/Tolerance'", rest="")
        self.refuse("'Values' is unknown", CELLS + '<Parameter name="Values" value="{1, 2}"/>')
        self.refuse("parameter 'Mesh/Size' is given twice", steps=CELLS)
        self.refuse("no receiver 'st9' on the fault; it has st05",
                    rest=COUPLING + '<Parameter name="Receivers" value="{st05, st9}"/>')


class Orders(FolderCase):
    def test_a_power_of_the_size_is_found(self):
        # The smallest change is above 1e-5, of values around 7 that are rounded to 1e-15.
        for power, ratio, levels in ((2.0, 2.0, 3), (2.0, 2.0, 5), (1.0, 8.0, 3), (3.7, 2.0, 4),
                                     (2.0 / 3.0, 8.0, 4), (2.0, 0.5, 3), (1.5, 0.25, 4)):
            values = 7.0 - 0.3 * (0.5 / ratio**np.arange(levels))**power
            self.assertGreater(np.abs(np.diff(values)).min(), 1e-5)
            found = order.estimate(values, ratio)
            self.assertAlmostEqual(found.order, power, delta=1e-8)
            self.assertAlmostEqual(found.limit, 7.0, delta=1e-12)
            self.assertAlmostEqual(found.error, 0.3 * 0.5**power, delta=1e-12)
            self.assertEqual(found.note, "")

    def test_without_an_order_the_error_is_the_spread(self):
        for values, note in (((1.0, 3.0, 2.0), order.ALTERNATING), ((1.0, 2.0, 4.0), order.GROWING),
                             ((1.0, 1.0, 4.0), order.GROWING), ((1.0, 4.0, 4.0), order.VANISHING),
                             ((4.0, 1.0, 3.0, 2.0), order.ALTERNATING)):
            found = order.estimate(values, 2.0)
            self.assertEqual((found.note, found.error), (note, 3.0 if 4.0 in values else 2.0))
            self.assertTrue(np.isnan(found.order) and np.isnan(found.limit))
        self.assertEqual(order.of_counts([8, 6, 5], 2.0).note, order.COUNT)
        self.assertEqual(order.of_counts([8, 6, 5], 2.0).error, 3.0)

    def test_an_order_far_from_theory_tells_no_limit(self):
        """Changes of 1 and 1/218, as of order 2.59 with a ratio of 8, of 1 and 0.86 as of 0.07."""
        for ratio, fine, found in ((8.0, 8.0**-2.59, 2.59), (8.0, 8.0**-0.07, 0.07),
                                   (0.125, 8.0**-2.59, 2.59)):
            values = np.cumsum([0.0, 1.0, fine])[::1 if ratio > 1.0 else -1]
            estimate = order.estimate(values, ratio, 2.0 / 3.0)
            self.assertAlmostEqual(estimate.order, found, delta=1e-8)
            self.assertAlmostEqual(estimate.error, 1.0 + fine, delta=1e-12)
            self.assertTrue(np.isnan(estimate.limit))
            self.assertEqual(estimate.note, f"{found:.2f} is far from 0.67 of theory")
        near = order.estimate([0.0, 1.0, 1.0 + 8.0**-0.5], 8.0, 2.0 / 3.0)
        self.assertEqual(near.note, "")
        self.assertAlmostEqual(near.order, 0.5, delta=1e-12)

    def test_equal_and_missing_values(self):
        found = order.estimate([5.0] * 3, 2.0)
        self.assertEqual((found.limit, found.error, found.note), (5.0, 0.0, order.EQUAL))
        self.assertTrue(np.isnan(found.order))
        found = order.estimate([5.0, np.nan, 4.0], 2.0)
        self.assertEqual(found.note, order.MISSING)
        self.assertTrue(np.isnan(found.error))


class Events(FolderCase):
    def run_of(self, onsets, name: str = "run", widths=None, complete=None) -> Run:
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        lines = ["number,onset [s],duration [s],width [m],peak_slip [m],moment_per_length [N],"
                 "complete"]
        widths = widths or [50.0] * len(onsets)
        complete = complete or [1] * len(onsets)
        lines += [f"{number},{onset!r},4,{width},0.5,3e10,{whole}" for number, (onset, width, whole)
                  in enumerate(zip(onsets, widths, complete), start=1)]
        (folder / "events.csv").write_text("\n".join(lines) + "\n")
        (folder / "parameters.xml").write_text(
            '<ParameterList name="Asperity"><ParameterList name="Bulk"><Parameter '
            'name="Shear Modulus" value="3e9"/></ParameterList><ParameterList name="Output">'
            '<ParameterList name="Event Catalogue"><Parameter name="Threshold" value="1e-3"/>'
            '</ParameterList></ParameterList></ParameterList>')
        return Run(folder)

    def common(self, *runs, **options):
        return quantities.number_in_common([self.run_of(onsets, f"{number}", **options)
                                            for number, onsets in enumerate(runs)])

    def test_events_correspond_in_order_while_their_onsets_are_near(self):
        self.assertEqual(self.common([10.0, 30.0, 50.0], [11.0, 32.0, 53.0]), 3)
        self.assertEqual(self.common([10.0, 30.0, 50.0], [11.0, 32.0]), 2)
        self.assertEqual(self.common([10.0, 30.0, 50.0], [11.0, 15.0, 32.0]), 1)
        self.assertEqual(self.common([10.0], [90.0]), 1)
        self.assertEqual(self.common([10.0], []), 0)

    def test_an_event_that_the_end_cuts_off_in_some_runs_only_does_not_correspond(self):
        runs = [self.run_of([10.0, 30.0], f"{last}", complete=[1, last]) for last in (0, 1)]
        self.assertEqual(quantities.number_in_common(runs), 1)
        self.assertEqual(quantities.number_in_common([runs[0], runs[0]]), 2)

    def test_slip_is_the_mean_over_the_rupture_and_intervals_are_between_onsets(self):
        found = quantities.measured(self.run_of([10.0, 30.0], widths=[50.0, 0.0]))
        np.testing.assert_allclose(found[Quantity("mean_slip", "m")], [0.2, np.nan])
        np.testing.assert_allclose(found[Quantity("interval", "s")], [np.nan, 20.0])

    def test_arrivals_at_receivers_count_from_the_onset_of_their_event(self):
        run = self.run_of([10.0, 30.0])
        with h5py.File(run.directory / "receivers.h5", "w") as file:
            file["time"] = time = np.arange(0.0, 60.0, 0.5)
            # reached 1.5 s after the first onset, between two rows, and never after the second
            file["on_fault/names"] = ["st05"]
            rate = np.where((time > 11.5) & (time < 13.0), 1e-2, 1e-4)
            rate[23] = 1e-3
            file["on_fault/fields/slip_rate"] = rate[:, None]
            file["on_fault/fields/slip"] = 0.01 * time[:, None]
        found = quantities.measured(run, ["st05"])
        np.testing.assert_allclose(found[Quantity("arrival at st05", "s")], [1.5, np.nan])
        np.testing.assert_allclose(found[Quantity("slip at st05", "m")], [0.04, 0.04])


class Tables(Studies, Events):
    def parts(self, *onsets, selection=Selection(), **options):
        """Of five runs: deck, two finer cells, two finer tolerances."""
        what = study.read(self.write())
        jobs = []
        for number, each in enumerate(onsets, start=1):
            self.run_of(each or [], f"{number}", **options)
            jobs.append(Job(number, self.folder / f"{number}", [],
                            "finished" if each is not None else "failed"))
        return convergence.parts(what, jobs, what.runs(), selection)

    @staticmethod
    def rows(parts):
        return {(row.event, row.quantity): row for row in convergence.total(parts)}

    def test_errors_of_parts_add_up_and_the_limit_is_corrected_by_both(self):
        # 100 + 0.8 h^2 - 0.3 s with s in thirds of the tolerance's levels
        parts = self.parts([100.5], [99.9], [99.75], [100.65], [100.725])
        self.assertEqual([round(part.estimates[1, ONSET].order, 6) for part in parts],
                         [2.0, round(1.0 / 3.0, 6)])
        row = self.rows(parts)[1, ONSET]
        np.testing.assert_allclose((row.value, row.limit, row.error), (100.5, 100.0, 1.1),
                                   rtol=1e-12)
        with open(convergence_text.write(self.folder, parts)[0], newline="") as file:
            line = [line for line in csv.DictReader(file) if line["quantity"] == "onset"][0]
        self.assertEqual((line["event"], line["cells 1"], line["cells 4"], line["steps 64"]),
                         ("1", "100.5", "99.75", "100.725"))
        self.assertAlmostEqual(float(line["relative error"]), 1.1 / 100.5, delta=1e-12)
        text = (self.folder / "convergence.md").read_text()
        self.assertIn("| 1 | onset [s] | 100.5 | 99.9 | 99.75 | 2.00 | 99.7 | 0.8 |", text)
        self.assertNotIn("WARNING", text)

    def test_rows_whose_order_is_far_from_theory_are_marked(self):
        order_one = '<Parameter name="Order" value="1"/>'
        what = study.read(self.write(CELLS + order_one))
        self.assertEqual([each.refinement.order for each in what.variables], [1.0, None])
        jobs = []
        for number, onset in enumerate((100.5, 99.5, 99.498, 100.5, 100.5), start=1):
            self.run_of([onset], f"{number}")
            jobs.append(Job(number, self.folder / f"{number}", [], "finished"))
        parts = convergence.parts(what, jobs, what.runs())
        text = convergence_text.text_of(parts)
        self.assertIn("### cells: order 1 in theory", text)
        self.assertIn("| event | quantity | deck | 2 x finer | 4 x finer | order | limit | error |",
                      text)
        self.assertIn("| 1 | onset [s] | 100.5 | 99.5 | 99.498 | 8.97 * |  | 1 * |", text)
        self.assertTrue(self.rows(parts)[1, ONSET].is_doubtful)
        self.refuse("cells: Order = -1; a number above 0 is wanted",
                    CELLS + '<Parameter name="Order" value="-1"/>')
        coarser = study.read(self.write(CELLS + '<Parameter name="Ratio" value="0.5"/>'))
        part = convergence.Part(coarser.variables[0])
        self.assertEqual(convergence_text.levels(part), ["deck", "2 x coarser", "4 x coarser"])

    def test_other_numbers_of_events_are_warned_of_and_unmatched_events_have_no_numbers(self):
        two, three = [10.0, 30.0], [10.0, 30.0, 50.0]
        parts = self.parts(three, two, three, three, three)
        self.assertIn("cells: 3, 2, 3 events with 1, 2, 4; those after the first 2 do not",
                      parts[0].warning)
        self.assertEqual(parts[1].warning, "")
        self.assertIn("WARNING: cells", convergence_text.text_of(parts))
        rows = self.rows(parts)
        self.assertEqual(rows[0, COUNT].error, 1.0)
        self.assertNotIn((3, ONSET), parts[0].values)
        self.assertEqual(parts[1].estimates[3, ONSET].note, order.EQUAL)
        self.assertTrue(np.isnan(rows[3, ONSET].error))
        self.assertEqual(rows[2, ONSET].error, 0.0)

    def test_as_many_events_that_are_others_have_no_numbers_either(self):
        usual = [10.0, 30.0, 50.0]
        parts = self.parts(usual, [10.0, 14.0, 30.0], usual, usual, usual)
        self.assertIn("those after the first 1 do not correspond", parts[0].warning)
        self.assertEqual({event for event, _ in parts[0].values}, {0, 1})
        self.assertEqual({event for event, _ in parts[1].values}, {0, 1, 2, 3})

    def test_a_level_without_results_leaves_its_variable_without_errors(self):
        parts = self.parts([10.0], None, [10.0], [10.5], [10.75])
        self.assertIn("cells: no results with 2", parts[0].warning)
        row = self.rows(parts)[1, ONSET]
        self.assertAlmostEqual(parts[1].estimates[1, ONSET].error, 1.0)
        self.assertTrue(np.isnan(row.error) and np.isnan(row.limit))

    def test_events_that_do_not_count_are_left_out(self):
        parts = self.parts(*[[10.0, 30.0]] * 5, widths=[5.0, 50.0],
                           selection=Selection(smallest_width=20.0))
        self.assertEqual(parts[0].values[0, COUNT], [1.0, 1.0, 1.0])
        self.assertEqual(parts[0].values[1, ONSET], [30.0, 30.0, 30.0])
