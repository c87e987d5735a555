"""Fields that call tables: layers, damaged and edited files, the example of the manual."""

import pathlib
import re
import shutil
import unittest

import numpy

import asperity_run
import runs
from asperity_run import settings

DECK = pathlib.Path(__file__).parent.parent / "bad_input" / "square.xml"
PAGE = asperity_run.SOURCE / "docs" / "first_model" / "starting_values.md"
LAYERS = 10
# In tenths of a metre, and in kg/m^3: a layer in each tenth of the square, whose surface is y = 1.
TOPS, DENSITIES = range(LAYERS), [1000 + 55 * layer for layer in range(LAYERS)]
STEPS = {"Tables/rho/Interpolation": "Step", "Tables/rho/Outside": "Nearest"}
OF_TABLE = {"Bulk/Density": "rho(1 - y)"}


def questions():
    """The same layers in nested conditions."""
    text = f"{DENSITIES[-1]}"
    for top, density in reversed(list(zip(TOPS[1:], DENSITIES))):
        text = f"1 - y < {top}e-1 ? {density} : ({text})"
    return {"Bulk/Density": text}


def in_deck():
    return {"Tables/rho/Arguments": "{" + ", ".join(f"{top}e-1" for top in TOPS) + "}",
            "Tables/rho/Values": "{" + ", ".join(map(str, DENSITIES)) + "}", **STEPS, **OF_TABLE}


def rows(densities=DENSITIES):
    return [f"{top}e-4, {density / 1000}" for top, density in zip(TOPS, densities)]


def write(name, lines, head="depth [km], density [g/cm^3]"):
    pathlib.Path(name).write_text("\n".join([head, *lines, ""]))
    return {"Tables/rho/From": "File", "Tables/rho/File Name": name,
            "Tables/rho/Argument Column": "depth", "Tables/rho/Value Column": "density", **STEPS,
            **OF_TABLE}


class Tables(unittest.TestCase):
    def results(self, folder, deck, ranks=1):
        folder = asperity_run.run_to_end(folder, DECK, *settings(deck), ranks=ranks)
        series = asperity_run.series(folder / "fault.h5")
        return asperity_run.content(folder / "steps.csv"), series

    def assert_same(self, one, other):
        self.assertEqual(one[0], other[0])
        self.assertEqual(sorted(one[1]), sorted(other[1]))
        for name, values in one[1].items():
            numpy.testing.assert_array_equal(values, other[1][name], name)

    def test_ten_layers_are_those_of_nested_conditions(self):
        expected = self.results("questions", questions())
        self.assert_same(expected, self.results("in_deck", in_deck()))
        self.assert_same(expected, self.results("in_file", write("crust.csv", rows())))
        uniform = self.results("uniform", {"Bulk/Density": DENSITIES[0]})
        self.assertNotEqual(expected[0], uniform[0])

    def test_two_ranks_have_the_layers_of_nested_conditions(self):
        self.assert_same(self.results("questions_2", questions(), ranks=2),
                         self.results("in_file_2", write("crust.csv", rows()), ranks=2))

    def test_the_parameters_of_a_run_find_the_table(self):
        folder = asperity_run.run_to_end("found", DECK, *settings(write("crust.csv", rows())))
        elsewhere = pathlib.Path("elsewhere").absolute()
        shutil.rmtree(elsewhere, ignore_errors=True)
        elsewhere.mkdir()
        shutil.copy(folder / "parameters.xml", elsewhere / "deck.xml")
        again = asperity_run.run_to_end("again", elsewhere / "deck.xml")
        self.assertEqual(asperity_run.content(folder / "steps.csv"),
                         asperity_run.content(again / "steps.csv"))

    def assert_refused(self, deck, *pieces, ranks=1):
        with self.subTest(pieces, ranks=ranks):
            result = asperity_run.run(DECK, *settings(deck), "--validate", ranks=ranks)
            runs.assert_one_message(self, result, runs.INPUT, *pieces)

    def test_damaged_files_are_refused(self):
        good, head = rows(), "depth [km], density [g/cm^3]"
        for ranks in (1, 2):
            self.assert_refused(write("swapped.csv", [", ".join(reversed(row.split(", ")))
                                                      for row in reversed(good)]),
                                "Asperity / Tables / rho, line 3 of '", "swapped.csv'", "is less",
                                ranks=ranks)
        self.assert_refused(write("order.csv", good[:3] + [good[5], good[4]]),
                            "Asperity / Tables / rho, line 6 of '", "order.csv'", "Sort the rows")
        self.assert_refused(write("nan.csv", good[:2] + ["2e-4, nan"]), "line 4",
                            "column 'density': 'nan' is no finite number")
        self.assert_refused(write("short.csv", good[:-1] + ["9e-4"]), "line 11",
                            "'9e-4' has 1 entries", "2 columns")
        self.assert_refused(write("empty.csv", []), "Asperity / Tables / rho: a table needs two")
        self.assert_refused(write("units.csv", good, "depth [km], density [g/ccm]"),
                            "column 'density'", "the unit 'g/ccm' is unknown")
        self.assert_refused(write("column.csv", good, "depth [km], densty [g/cm^3]"),
                            "Asperity / Tables / rho / Value Column = 'density'",
                            "Did you mean 'densty'?")
        self.assert_refused({**write("other.csv", good, head), "Tables/rho/Value Unit": "kg/m^3"},
                            "Asperity / Tables / rho / Value Unit = 'kg/m^3'", "in [g/cm^3]")
        self.assert_refused({**write("good.csv", good), "Tables/rho/File Name": "godd.csv"},
                            "there is no such file", "Did you mean 'good.csv'?")

    def test_a_place_outside_of_the_table_is_named(self):
        for ranks in (1, 2):
            self.assert_refused(
                {**write("crust.csv", rows()[:5]), "Tables/rho/Outside": "Error"},
                "Asperity / Bulk / Density = 'rho(1 - y)' has no value at (x, y, z) = (",
                "Asperity / Tables / rho has arguments from 0 to 0.4, but 0.", "is wanted",
                ranks=ranks)

    def test_an_edited_file_is_noticed_by_a_restart(self):
        deck = settings(write("edited.csv", rows()))
        folder = asperity_run.run_to_end("edited", DECK, *deck)
        longer = settings("Time Stepping/Final Time=0.6")
        write("edited.csv", rows(DENSITIES[:-1] + [DENSITIES[-1] + 1]))
        for ranks in (1, 2):
            result = asperity_run.run(DECK, *deck, *longer, "--restart",
                                      folder / "checkpoint.h5", "--output", folder, ranks=ranks)
            runs.assert_one_message(self, result, runs.INPUT, "the content of table file '",
                                    "edited.csv'", "has changed since then")
        write("edited.csv", rows())
        asperity_run.go_on(folder, DECK, *deck, *longer)

    def test_wave_speeds_give_the_moduli(self):
        """cs = 20 m/s and cp = 20 sqrt(3) m/s, a Poisson's ratio of 1/4, with 2500 kg/m^3."""
        base = {"Bulk/Density": 2500}
        self.results("moduli", base)
        folder = asperity_run.run_to_end(
            "speeds", DECK, "--remove", "Bulk/Shear Modulus", "--remove", "Bulk/Poisson's Ratio",
            *settings(base, {"Bulk/S-Wave Speed": 20, "Bulk/P-Wave Speed": "20 * sqrt(3)"}))
        rates, expected = ([row["peak_slip_rate"] for row in asperity_run.table(
            pathlib.Path(name) / "steps.csv")] for name in (folder, "moduli"))
        numpy.testing.assert_allclose(rates, expected, rtol=0, atol=1e-6 * max(expected))
        self.assertGreater(max(expected), 0)

    def test_the_example_of_the_manual_is_valid(self):
        text = PAGE.read_text(encoding="utf-8")
        for language, name in (("text", "crust.csv"), ("xml", "layers.xml")):
            blocks = re.findall(rf"^```{language}\n(.*?)^```", text, re.MULTILINE | re.DOTALL)
            self.assertEqual(len(blocks), 1)
            pathlib.Path(name).write_text(blocks[0])
        result = asperity_run.run(asperity_run.SOURCE / "examples" / "first_model" / "plane.xml",
                                  "--overlay", "layers.xml", "--validate")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)


if __name__ == "__main__":
    unittest.main()
