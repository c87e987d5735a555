"""collect.py on a result folder that the test writes itself, and on the pages of the tree."""

import json
import pathlib
import shutil
import tempfile
import unittest

import h5py
import numpy

import benchmark_cases
import collect
import pages
import readings
from case import Case, Quantity

DECK = "spring_slider"
PAGE = "# Page\n\nText.\n\n<!-- values: mine -->\nold\n<!-- end -->\n\nMore text.\n"
ONSETS = (100.0, 300.0, 100300.0)  # s; the first two are within a day


def case(name="mine", **more):
    return Case(name, "Mine", "page", 1, (
        Quantity("number of events", "", readings.number_of_events(0), 3),
        Quantity("onset of event 2", "s", readings.onset(2, 1, 0), 250),
        Quantity("slip in event 2", "m", readings.slip_in_event("here", 2), (0.5, 2)),
        Quantity("onset of event 9", "s", readings.onset(9, 1, 0), 1),
        Quantity("energy defect", "", readings.energy_defect, 0)),
                "a book", deck=DECK, in_index=("onset of event 2",), **more)


def write_run(folder, rises=0):
    """Three events of ten seconds; 1 m of slip in each, at the one receiver."""
    folder.mkdir(parents=True)
    rows = [f"{n},{onset},{onset + 10},10,5\n" for n, onset in enumerate(ONSETS, 1)]
    (folder / "events.csv").write_text(
        "".join(["number,onset [s],end [s],duration [s],width [m]\n", *rows]))
    (folder / "steps.csv").write_text(
        "step,time [s],step_size [s],coupled_steps,rate_problems,tnnmg_iterations,"
        "energy_increases,friction_work [J/m],energy_defect [J/m]\n"
        f"1,1,1,3,4,5,0,10,0\n2,2,1,3,4,5,{rises},20,-2e-9\n")
    (folder / "run.log").write_text("Asperity 9.8.7 on Serial, 1 rank.\n"
                                    "Finished at t = 2 s after 2 steps.\n")
    shutil.copy(collect.SOURCE / "xml" / f"{DECK}.xml", folder / "parameters.xml")
    with h5py.File(folder / "receivers.h5", "w") as file:
        times = numpy.sort([time for onset in ONSETS for time in (onset, onset + 10)])
        file["time"] = times
        file["on_fault/names"] = ["here"]
        file["on_fault/fields/slip"] = -numpy.array([0, 1, 1, 2, 2, 3.])[:, None]


class Collecting(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.results = pathlib.Path(temporary.name) / "results"
        self.pages = pathlib.Path(temporary.name) / "pages"
        self.pages.mkdir()
        self.page = self.pages / "page.md"
        self.page.write_text(PAGE)
        write_run(self.results / "mine")

    def collect(self, *cases, results=True):
        words = [str(self.results)] if results else []
        return collect.main([*words, "--pages", str(self.pages)], cases or (case(),))

    def entries(self):
        return json.loads((self.pages / "values.json").read_text())

    def test_a_run_in_which_j_rose_is_left_out(self):
        shutil.rmtree(self.results / "mine")
        write_run(self.results / "mine", rises=2)
        self.assertEqual(self.collect(), 1)
        self.assertEqual(self.entries(), {})

    def test_values_of_a_run(self):
        self.assertEqual(self.collect(), 0)
        entry = self.entries()["mine"]
        self.assertEqual(entry["source"], "Asperity 9.8.7")
        self.assertEqual(entry["steps"], {"accepted steps": 2, "coupled steps": 6,
                                          "rate problems": 8, "TNNMG iterations": 10})
        values = [(row["value"], row["reference"]) for row in entry["quantities"]]
        # Events within a day are one: the slip is that of the third row.
        self.assertEqual(values, [(3, 3), (300, 250), (1, [0.5, 2]), (None, 1), (1e-10, 0)])

    def test_tables_on_pages(self):
        self.collect()
        text = self.page.read_text()
        for line in ("    asperity xml/spring_slider.xml --output results/mine",
                     "| number of events | 3 | 3 | +0 |",
                     "| onset of event 2 [s] | 250 | 300.000 | +20.00 % |",
                     "| slip in event 2 [m] | 0.5 to 2 | 1.000 | within |",
                     "| onset of event 9 [s] | 1 | none |  |",
                     "| energy defect | 0 | 1.0e-10 | 1.0e-10 |",
                     "The run takes 2 accepted steps, 6 coupled steps, 8 rate problems, "
                     "10 TNNMG iterations."):
            self.assertIn(line + "\n", text)
        self.assertNotIn("old", text)
        self.assertTrue(text.startswith("# Page\n\nText.\n") and text.endswith("\n\nMore text.\n"))

    def test_the_index(self):
        index = self.pages / "index.md"
        index.write_text("<!-- values: index -->\n<!-- end -->\n")
        self.collect()
        self.assertIn("| [Mine](page.md) | onset of event 2 [s] | a book | 250 | 300.000 | "
                      "+20.00 % |\n", index.read_text())
        self.assertEqual(index.read_text().count("Mine"), 1)

    def test_other_entries_stay(self):
        other = {"source": "a diary", "steps": {},
                 "quantities": [{"quantity": "onset of event 2", "value": 7}]}
        (self.pages / "values.json").write_text(json.dumps({"other": other}))
        self.collect(case("other"), case())
        self.assertEqual(list(self.entries()), ["other", "mine"])
        self.assertEqual(self.entries()["other"]["source"], "a diary")
        self.assertEqual(self.entries()["other"]["quantities"], [
            {"quantity": "onset of event 2", "unit": "s", "reference": 250, "value": 7}])

    def test_another_run_as_the_reference(self):
        write_run(self.results / "whole")
        whole = Case("whole", "", "page", 1, (
            Quantity("onset of event 2", "s", readings.onset(2, 1, 0)),), deck=DECK, against="mine")
        self.page.write_text(PAGE + PAGE.replace("mine", "whole"))
        self.collect(case(), whole)
        self.assertIn("| onset of event 2 [s] | 300.000 | 300.000 | 0 |\n", self.page.read_text())

    def test_check(self):
        self.collect()
        self.assertEqual(collect.check(self.pages, (case(),)), [])
        self.assertEqual(len(collect.check(self.pages, (case(), case("other")))), 1)
        self.page.write_text(self.page.read_text().replace("300.000", "250.000"))
        self.assertEqual(len(collect.check(self.pages, (case(),))), 1)
        self.collect(results=False)
        self.assertEqual(collect.check(self.pages, (case(),)), [])

    def test_a_block_of_no_case(self):
        self.page.write_text(PAGE.replace("mine", "nobody"))
        with self.assertRaisesRegex(ValueError, "no case 'nobody'"):
            self.collect()

    def test_runs_that_are_left_out(self):
        log, deck = (self.results / "mine" / name for name in ("run.log", "parameters.xml"))
        whole = log.read_text()
        log.write_text(whole.replace("Finished", "Stopped"))
        self.assertEqual(self.collect(), 1)
        log.write_text(whole)
        self.assertEqual(self.collect(case(settings=("Time Stepping/Final Time=9e3",))), 1)
        deck.write_text(deck.read_text().replace('value="10000"', 'value="9000"'))
        self.assertEqual(self.collect(), 1)
        self.assertEqual(self.collect(case(settings=("Time Stepping/Final Time=9e3",))), 0)


class Tree(unittest.TestCase):
    def test_pages_agree_with_values(self):
        self.assertEqual(collect.check(collect.PAGES, collect.CASES), [])

    def test_cases_are_sound(self):
        names = [each.name for each in collect.CASES]
        self.assertEqual(len(set(names)), len(names))
        for each in collect.CASES:
            self.assertTrue((collect.SOURCE / "xml" / f"{each.deck_name}.xml").exists(), each.name)
            self.assertTrue((collect.PAGES / f"{each.page}.md").exists(), each.name)
            quantities = [quantity.name for quantity in each.quantities]
            self.assertEqual(len(set(quantities)), len(quantities), each.name)
            self.assertLessEqual(set(each.in_index), set(quantities), each.name)
            self.assertIn(each.against, ["", *names])

    def test_long_commands_are_broken(self):
        for each in collect.CASES:
            for line in each.commands().splitlines():
                self.assertLessEqual(len(line), 112, each.name)

    def test_differences(self):
        onset, speed = benchmark_cases.BP1[0], benchmark_cases.BP1[-2]
        self.assertEqual(pages.difference(1.0, 1.00001, speed), "-1e-05")
        self.assertEqual(pages.difference(1.0, 1.00001, onset), "0.00 %")
        self.assertEqual(pages.difference(21.0, (22, 24), speed), "-4.55 %")
        self.assertEqual(pages.difference(None, 2, speed), "")


if __name__ == "__main__":
    unittest.main()
