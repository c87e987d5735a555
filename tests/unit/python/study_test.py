"""Studies: which runs a file asks for, and what is wrong with one that asks badly."""

import csv
import json
from pathlib import Path
from unittest import mock

import h5py
import numpy as np
from matplotlib import pyplot

import synthetic_run
from asperity.errors import InputError
from asperity.selection import Selection
from asperity_study import figure, results, runner, study
from asperity_study.runner import Job
from folders import FolderCase

EXAMPLES = Path(__file__).resolve().parents[3] / "examples" / "study"


class Studies(FolderCase):
    def setUp(self):
        super().setUp()
        (self.folder / "deck.xml").write_text("<ParameterList name='Asperity'/>")

    def write(self, variables: str, rest: str = "", sampling: str = "Grid") -> Path:
        path = self.folder / "study.xml"
        path.write_text(f"""<ParameterList name="Asperity Study">
          <Parameter name="Deck" type="string" value="deck.xml"/>
          <Parameter name="Sampling" type="string" value="{sampling}"/>{rest}
          <ParameterList name="Variables">{variables}</ParameterList></ParameterList>""")
        return path

    @staticmethod
    def listed(name: str, path: str, values: str) -> str:
        return (f'<ParameterList name="{name}"><Parameter name="Parameters" value="{{{path}}}"/>'
                f'<Parameter name="Values" value="{{{values}}}"/></ParameterList>')

    @staticmethod
    def sampled(name: str, low: str, high: str, how: str = "Uniform") -> str:
        return (f'<ParameterList name="{name}"><Parameter name="Parameters" value="F/{name}"/>'
                f'<Parameter name="Lowest" value="{low}"/><Parameter name="Highest" '
                f'value="{high}"/><Parameter name="Distribution" value="{how}"/></ParameterList>')

    def refuse(self, words: str, *arguments, **options):
        with self.assertRaisesRegex(InputError, words):
            study.read(self.write(*arguments, **options)).runs()


class Runs(Studies):
    def test_grid_is_every_combination(self):
        what = study.read(self.write(self.listed("law", "F/Law", "A, B")
                                     + self.listed("h", "M/h", "1, 2, 3")))
        self.assertEqual([tuple(run.values()) for run in what.runs()],
                         [("A", "1"), ("A", "2"), ("A", "3"), ("B", "1"), ("B", "2"), ("B", "3")])
        self.assertEqual(what.overrides(what.runs()[4]), ["F/Law=B", "M/h=2"])

    def test_list_goes_row_by_row(self):
        what = study.read(self.write(self.listed("a", "F/a", "1, 2") +
                                     self.listed("b", "F/b", "max(x, 0), 7"), sampling="List"))
        self.assertEqual([tuple(run.values()) for run in what.runs()],
                         [("1", "max(x, 0)"), ("2", "7")])

    def test_a_value_may_go_to_several_parameters(self):
        what = study.read(self.write(self.listed("tol", "S/Tolerance, C/Tolerance", "1e-4, 1e-5"),
                                     '<ParameterList name="Settings"><Parameter name="T" '
                                     'value="3"/></ParameterList>'))
        self.assertEqual(what.overrides(what.runs()[1]),
                         ["T=3", "S/Tolerance=1e-5", "C/Tolerance=1e-5"])

    def samples(self, seed: int, number: int = 2000):
        rest = (f'<Parameter name="Samples" value="{number}"/>'
                f'<Parameter name="Seed" value="{seed}"/>')
        what = study.read(self.write(self.sampled("b", "-1", "3")
                                     + self.sampled("L", "1e-6", "1e-2", "Logarithmic"), rest,
                                     "Random"))
        return np.array([[float(value) for value in run.values()] for run in what.runs()])

    def test_random_samples_fill_their_limits(self):
        values = self.samples(5)
        shares = np.stack(((values[:, 0] + 1.0) / 4.0, (np.log10(values[:, 1]) + 6.0) / 4.0))
        for share in shares:
            self.assertGreaterEqual(share.min(), 0.0)
            self.assertLess(share.max(), 1.0)
            # each tenth has a tenth of them, to four standard deviations
            counts = np.histogram(share, 10, (0.0, 1.0))[0]
            self.assertLess(np.abs(counts - 200).max(), 4.0 * np.sqrt(200 * 0.9))
        self.assertLess(abs(np.corrcoef(shares)[0, 1]), 4.0 / np.sqrt(2000))

    def test_a_seed_is_a_sequence(self):
        np.testing.assert_array_equal(self.samples(5, 10), self.samples(5, 10))
        np.testing.assert_array_equal(self.samples(5, 10), self.samples(5, 20)[:10])
        self.assertFalse((self.samples(5, 10) == self.samples(6, 10)).any())

    def test_the_examples(self):
        for name, number in (("thesis", 18), ("slider", 4), ("random", 6), ("convergence", 5)):
            what = study.read(EXAMPLES / f"{name}.xml")
            self.assertEqual(len(what.runs()), number, name)
            self.assertTrue(what.deck.is_file(), name)


class BadStudies(Studies):
    def test_what_is_wrong_is_named(self):
        one = self.listed("a", "F/a", "1, 2")
        self.refuse("Sampling = 'Gird'; one of Grid", one, sampling="Gird")
        self.refuse("'Valeus' is unknown", one.replace('"Values"', '"Valeus"'))
        self.refuse("'Values' is missing", one.replace('<Parameter name="Values" value="{1, 2}"/>',
                                                       ""))
        self.refuse("variable 'a' is given twice", one + one)
        self.refuse("parameter 'F/a' is given twice, in Variables / a and in Variables / c",
                    one + one.replace('"a"', '"c"'))
        self.refuse("parameter 'F/a' is given twice, in Variables / a and in Settings",
                    one, '<ParameterList name="Settings"><Parameter name="F/a" value="1"/>'
                         '</ParameterList>')
        self.refuse("same number of values", one + self.listed("b", "F/b", "1, 2, 3"),
                    sampling="List")
        self.refuse("nothing varies", "")
        self.refuse("'Samples' is missing", self.sampled("b", "1", "2"), sampling="Random")
        samples = '<Parameter name="Samples" value="3"/>'
        self.refuse("Lowest = 2 and Highest = 1", self.sampled("b", "2", "1"), samples, "Random")
        self.refuse("both above 0", self.sampled("b", "0", "1", "Logarithmic"), samples, "Random")
        self.refuse("'x' is no number", self.sampled("b", "x", "1"), samples, "Random")
        self.refuse("Samples = '0'; a whole number from 1", self.sampled("b", "0", "1"),
                    samples.replace("3", "0"), "Random")

    def test_what_is_given_twice_is_refused(self):
        variable = self.listed("a", "F/a", "1, 2")
        once = '<Parameter name="T" value="3"/>'
        settings = f'<ParameterList name="Settings">{once}{{}}</ParameterList>'
        study.read(self.write(variable, settings.format("")))
        self.refuse("Settings: 'T' is given twice, as '3' and '4'", variable,
                    settings.format(once.replace("3", "4")))
        self.refuse("'Ranks' is given twice", variable, '<Parameter name="Ranks" value="1"/>' * 2)

    def test_a_variable_with_the_name_of_a_result_is_refused(self):
        results.require_other_names(study.read(self.write(self.listed("step", "T/s", "1, 2"))))
        for name in ("steps", "state", "width_median"):
            with self.assertRaisesRegex(InputError, f"'{name}' is the name of another column"):
                results.require_other_names(study.read(self.write(
                    self.listed(name, "T/s", "1, 2"))))

    def test_a_folder_has_one_study_at_a_time(self):
        folder = self.folder / "results"
        with runner.alone(folder):
            with self.assertRaisesRegex(InputError, "Another asperity-study works in .*results"):
                with runner.alone(folder):
                    self.fail("two studies at once")
        with runner.alone(folder):
            self.assertTrue(folder.is_dir())

    def test_files(self):
        with self.assertRaisesRegex(InputError, "cannot be read"):
            study.read(self.folder / "none.xml")
        with self.assertRaisesRegex(InputError, "the root is not"):
            study.read(self.folder / "deck.xml")
        path = self.write(self.listed("a", "F/a", "1"))
        (self.folder / "deck.xml").unlink()
        with self.assertRaisesRegex(InputError, "Deck: there is no file.*relative"):
            study.read(path)


class Tables(Studies):
    def test_table_and_figure_of_runs_that_are_done_or_not(self):
        what = study.read(self.write(self.listed("law", "F/Law", "A, B, C")))
        jobs = [Job(number, self.folder / f"{number}", [], state) for number, state in
                ((1, "finished"), (2, "waiting"), (3, "failed"))]
        synthetic_run.write_run(jobs[0].folder, 6, nodes=20)
        synthetic_run.write_run(jobs[1].folder, 1, nodes=20)
        (jobs[0].folder / "run.log").write_text("WARNING: one\nWARNING: two\nWARNING: one\n")
        table = results.columns(what, jobs, what.runs())
        self.assertLessEqual({name for name, _, _ in table} - {"law"}, results.NAMES)
        self.assertIn("1 finished, 1 failed, 1 waiting\nWARNING: results may be wrong",
                      runner.summary(jobs))
        self.assertIn("run 1.", runner.summary(jobs))
        self.assertEqual(runner.summary(jobs[1:]), "0 finished, 1 failed, 1 waiting")
        results.write(self.folder, table, Selection(merging_time=5.0))
        figure.draw(what, table, self.folder / "study.png")
        with open(self.folder / "results.csv", newline="") as file:
            rows = list(csv.DictReader(file))
        self.assertEqual([(row["run"], row["law"], row["state"]) for row in rows],
                         [("1", "A", "finished"), ("2", "B", "waiting"), ("3", "C", "failed")])
        self.assertEqual((rows[0]["events"], rows[1]["events"], rows[2]["events"]),
                         ("6", "1", "nan"))
        self.assertEqual((rows[0]["warnings"], rows[1]["warnings"]), ("2", "nan"))
        onsets = synthetic_run.event_times(6)
        self.assertAlmostEqual(float(rows[0]["recurrence_median [s]"]), np.median(np.diff(onsets)),
                               delta=0.05)
        with h5py.File(self.folder / "results.h5") as file:
            self.assertIn("5", file.attrs["selection"])
            np.testing.assert_array_equal(file["complete_events"][:2], [6, 1])
            self.assertEqual(file["recurrence_median"].attrs["unit"], "s")
            self.assertEqual(list(file["law"].asstr()), ["A", "B", "C"])
            self.assertEqual(len(file), len(rows[0]))
        self.assertGreater((self.folder / "study.png").stat().st_size, 10000)

    def drawn(self, path: Path):
        """The table of the study and the axes of its figure."""
        what = study.read(path)
        jobs = [Job(number, self.folder / str(number), [], "finished")
                for number in range(1, len(what.runs()) + 1)]
        for job in jobs:
            synthetic_run.write_run(job.folder, 3, nodes=20)
            (job.folder / "run.log").write_text("Asperity 0.1.0 on Serial, 1 rank.\n")
            end = {"event": "end", "how": "finished", "exit_status": 0, "message": "",
                   "wall_time": 7200 * job.number}
            (job.folder / "run.jsonl").write_text(json.dumps(end) + "\n")
        table = results.columns(what, jobs, what.runs())
        with mock.patch.object(figure.style, "save") as save:
            figure.draw(what, table, self.folder / "study.png")
        axes = save.call_args[0][0].axes
        self.addCleanup(pyplot.close, axes[0].figure)
        return {name: values for name, _, values in table}, axes

    def test_labels_of_the_figure_have_units(self):
        unit = '<Parameter name="Unit" value="mm"/><Parameter name="Values"'
        height = self.listed("height", "M/h", "1, 2").replace('<Parameter name="Values"', unit)
        data, axes = self.drawn(self.write(height + self.listed("law", "F/Law", "A")))
        self.assertEqual([panel.get_ylabel() for panel in axes],
                         ["Events", "Recurrence time\n[s]", "Rupture width\n[cm]",
                          "Peak slip\n[mm]", "Duration\n[ms]", "Peak slip rate\n[mm/s]", "Steps",
                          "Wall time\n[h]"])
        self.assertEqual(axes[-1].get_xlabel(), "height [mm]")
        np.testing.assert_allclose(axes[2].lines[0].get_ydata(),
                                   100.0 * np.array(data["width_median"]))
        np.testing.assert_allclose(axes[-1].lines[0].get_ydata(), [2.0, 4.0])

    def test_a_grid_is_drawn_over_its_numbers_with_a_line_for_each_other_value(self):
        grid = self.listed("height", "M/h", "4, 1, 2") + self.listed("law", "F/Law", "A, B")
        data, axes = self.drawn(self.write(grid))
        lines = axes[-1].lines
        self.assertEqual([line.get_label() for line in lines], ["law A", "law B"])
        wall = np.array(data["run"]) * 2.0  # [h]
        for line, law in zip(lines, "AB"):
            mine = np.array(data["law"]) == law
            np.testing.assert_array_equal(line.get_xdata(), [1.0, 2.0, 4.0])
            order = np.argsort(np.array(data["height"])[mine])
            np.testing.assert_allclose(line.get_ydata(), wall[mine][order])
        words = self.listed("law", "F/Law", "A, B") + self.listed("kind", "F/S", "C, D")
        _, axes = self.drawn(self.write(words))  # without a number they are categories
        self.assertEqual(axes[-1].get_xlabel(), "law, kind")
        self.assertEqual([text.get_text() for text in axes[-1].get_xticklabels()],
                         ["A, C", "A, D", "B, C", "B, D"])

    def test_labels_over_samples_have_units(self):
        unit = '<Parameter name="Unit" value="Pa"/><Parameter name="Lowest"'
        stress = self.sampled("stress", "1e6", "2e6").replace('<Parameter name="Lowest"', unit)
        _, axes = self.drawn(self.write(stress + self.sampled("b", "1", "2"),
                                        '<Parameter name="Samples" value="2"/>', "Random"))
        self.assertEqual([panel.get_xlabel() for panel in axes[-2:]], ["stress [Pa]", "b"])
