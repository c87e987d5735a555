"""asperity-study finds the orders and the errors of a deck whose answer and orders are known: the
layer of tests/verification/layer, with a top that goes faster without a jump.

The slip rate grows at 90/s where the event begins. Cells of H / 20 and steps of T / 20 then have
terms of fourth order that are (0.14)^2, 2 % of those of second order: they change the order by 0.03
and what is left at the limit by 2 % of the error. The limits are five times as large. The catalogue
finds the onset on a straight line between steps, in log V, which has an error of second order of
its own that depends on where in a step the onset falls. Where log V has its inflection, at 3 mm/s
in the exact solution, there is none.
"""

import csv
import math
import pathlib
import shutil
import subprocess
import sys
import unittest

import asperity_run
import numpy

LAYER = asperity_run.SOURCE / "tests" / "verification" / "layer"
sys.path.insert(0, str(LAYER))
import exact_layer  # noqa: E402

THRESHOLD, FINAL_TIME, RAMP = 3e-3, 0.7, 0.2  # m/s, s, s
ORDER, ORDER_TOLERANCE, LEFT = 2, 0.15, 0.1
STEP = exact_layer.TRAVEL_TIME / 20
SHARE = f"min(1, t / {RAMP})"
SETTINGS = {
    "Mesh/Rectangle/Width": 0.002,  # the two ends of the fault move as one
    "Mesh/Rectangle/Cells Y": 20,
    "Boundary Conditions/Drive/Velocity":
        f"1e-4 * (1 + 0.5 * {SHARE}^3 * (10 - 15 * {SHARE} + 6 * {SHARE}^2))",
    "Time Stepping/Final Time": FINAL_TIME,
    "Time Stepping/Largest Step": STEP,
    "Time Stepping/Smallest Step": STEP,
    "Coupling/Tolerance": 1e-10,
    "TNNMG/Absolute Tolerance": 1e-13,
    "TNNMG/Relative Tolerance": 1e-13,
    "Output/Event Catalogue/Threshold": THRESHOLD,
}
CELLS = {"Parameters": "{Mesh/Rectangle/Cells Y}", "Change": "Multiply"}
STEPS = {"Parameters": "{Time Stepping/Largest Step, Time Stepping/Smallest Step}"}
# A tolerance for the error of a pair of steps, of third order: an eighth of it halves the steps,
# and an error of second order in the step is one of order 2/3 in the tolerance. All steps are
# powers of 2. Where some are not halved, or twice, the changes may differ from the factor 4 by 1.6.
TOLERANCE = {
    "Parameters": "{Time Stepping/Richardson/Tolerance, Coupling/Tolerance}", "Ratio": 8}
CONTROLLED = {
    "Time Stepping/Scheme": "Generalised Alpha",
    "Time Stepping/Control": "Richardson",
    # chosen after a run with 1e-4, in which waves limit some steps of the first level alone
    "Time Stepping/Richardson/Tolerance": 1e-5,  # chosen after a run: 1e-4 is too large
    "Time Stepping/Largest Step": 0.02,
    "Time Stepping/Smallest Step": 1e-6,
    "Coupling/Tolerance": 1e-9,
}
LEAST, MOST = (math.log(4 / 1.6, 8), math.log(4 * 1.6, 8))


def entries(values):
    return "".join(f'<Parameter name="{name}" value="{value}"/>' for name, value in values.items())


def study(name, settings, **variables):
    """The printed text, and the rows of convergence.csv by event and quantity."""
    lists = "".join(f'<ParameterList name="{each}">{entries(of)}</ParameterList>'
                    for each, of in variables.items())
    path = pathlib.Path(f"{name}.xml")
    path.write_text(f"""<ParameterList name="Asperity Study">
  <Parameter name="Deck" value="{LAYER / "layer.xml"}"/>
  <Parameter name="Sampling" value="Convergence"/>
  <ParameterList name="Settings">{entries(settings)}</ParameterList>
  <ParameterList name="Variables">{lists}</ParameterList>
</ParameterList>""")
    return results(name, path)


def results(name, *arguments):
    """The same of a study by the arguments of asperity-study."""
    shutil.rmtree(name, ignore_errors=True)
    result = subprocess.run(
        [str(asperity_run.PROGRAM.with_name("asperity-study")), *arguments, "--output", name,
         "--cores", "1"], text=True, capture_output=True, check=False)
    if (result.returncode, result.stderr) != (0, ""):
        raise AssertionError(result.stdout + result.stderr)
    with open(pathlib.Path(name) / "convergence.csv", newline="") as file:
        rows = {(row["event"], row["quantity"]): row for row in csv.DictReader(file)}
    print(result.stdout)
    return result.stdout, rows


def number(row, name):
    return float(row[name])


def drive(t):
    share = min(max(t / RAMP, 0), 1)
    return exact_layer.V_BEFORE * (1 + 0.5 * share**3 * (10 - 15 * share + 6 * share**2))


def exact_onset():
    """To 2e-8 s, a hundred times better than the finest level."""
    t, V = exact_layer.solve(FINAL_TIME, 1600, drive)
    i = numpy.flatnonzero((V[:-1] < THRESHOLD) & (V[1:] >= THRESHOLD))[0]
    low, high = numpy.log(V[i:i + 2] / THRESHOLD)
    return t[i] - (t[i + 1] - t[i]) * low / (high - low)


class Convergence(unittest.TestCase):
    def test_cells_and_steps_of_second_order(self):
        text, rows = study("layer", SETTINGS, cells=CELLS, step=STEPS)
        self.assertEqual(rows["", "events"]["value"], "1.0")
        onset = rows["1", "onset"]
        for name in ("cells", "step"):
            self.assertAlmostEqual(number(onset, f"{name} order"), ORDER, delta=ORDER_TOLERANCE)
        exact, error = exact_onset(), number(onset, "error")
        self.assertLess(abs(number(onset, "limit") - exact), LEFT * error)
        self.assertLess(abs(number(onset, "value") - exact), (1 + LEFT) * error)
        self.assertAlmostEqual(number(onset, "cells error") + number(onset, "step error"), error,
                               delta=1e-9 * error)
        for words in ("### cells", "### step", "### Total", "| 1 | mean slip ["):
            self.assertIn(words, text)
        self.assertEqual(len(list(pathlib.Path("layer/runs").iterdir())), 5)

    def test_a_deck_alone_is_refined_in_cells_and_steps(self):
        changes = [word for path, value in SETTINGS.items()
                   for word in ("--set", f"{path}={value}")]
        _, rows = results("deck", "--convergence", LAYER / "layer.xml", *changes)
        onset = rows["1", "onset"]
        for name in ("cells", "step"):
            self.assertAlmostEqual(number(onset, f"{name} order"), ORDER, delta=ORDER_TOLERANCE)
        self.assertLess(abs(number(onset, "limit") - exact_onset()), LEFT * number(onset, "error"))

    def test_a_tolerance_has_two_thirds_of_the_order_and_the_same_limit(self):
        _, controlled = study("controlled", {**SETTINGS, **CONTROLLED}, tolerance=TOLERANCE)
        _, equal = study("equal", SETTINGS, step=STEPS)
        controlled, equal = controlled["1", "onset"], equal["1", "onset"]
        self.assertGreater(number(controlled, "tolerance order"), LEAST)
        self.assertLess(number(controlled, "tolerance order"), MOST)
        errors = number(controlled, "error") + number(equal, "error")
        self.assertLess(abs(number(controlled, "limit") - number(equal, "limit")), LEFT * errors)


if __name__ == "__main__":
    unittest.main()
