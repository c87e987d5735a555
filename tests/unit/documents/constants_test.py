"""Constants that the manual names are those of the code."""

import os
import pathlib
import re
import unittest

SOURCE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"])
NUMBER = r"([\d.]+(?:e-?\d+)?)\b"
WORDS = {"two": 2.0, "tenth": 0.1, "hundredth": 0.01, "thousandth": 1e-3, "millionth": 1e-6}

# What the manual says, and where the code says it; each expression finds one number or word. The
# last entry turns the manual's number into the code's.
CONSTANTS = [
    ("docs/method.md", r"\\Delta J>\((\d+)\+n/2\)\\,\\epsilon",
     "packages/tnnmg/NodalProblem.hpp", r"\((\d+) \+ num_terms / 2\)"),
    ("docs/method.md", r"\\Delta J>\(\d+\+n/(\d+)\)",
     "packages/tnnmg/NodalProblem.hpp", r"\(\d+ \+ num_terms / (\d+)\)"),
    ("docs/method.md", r"V>L/\((\d+)\\tau\)",
     "packages/dynamics/watches/GrowthWatch.cpp", rf"part_of_L = {NUMBER};", lambda x: 1 / x),
    ("docs/method.md", r"exceeds \$(\d+)L\$",
     "packages/dynamics/watches/GrowthWatch.cpp", rf"most_slow_slip = {NUMBER};"),
    ("docs/method.md", r"strains the body by \$10\^\{(-\d+)\}\$",
     "packages/scenario/run/Evolution.cpp", rf"least_strain = {NUMBER};", lambda x: 10 ** x),
    ("docs/model.md", r"strains the body by \$10\^\{(-\d+)\}\$",
     "packages/scenario/run/Evolution.cpp", rf"least_strain = {NUMBER};", lambda x: 10 ** x),
    ("docs/model.md", r"default of `Smallest Step` is a (\w+) of the run",
     "packages/scenario/checks/SmallestStep.cpp", rf"share_of_run = {NUMBER},"),
    ("docs/model.md", r"at most a (\w+) of the time in\s+which a shear wave crosses",
     "packages/scenario/checks/SmallestStep.cpp", rf"share_of_crossing = {NUMBER};"),
    ("docs/choosing.md", r"\| (\d+) cells or more in \$\\Lambda_0\$",
     "packages/scenario/checks/ResolutionCheck.cpp", rf"enough_cells = {NUMBER};"),
    ("docs/choosing.md", r"The zone needs (\w+) cells or more",
     "packages/scenario/checks/ResolutionCheck.hpp", rf"fewest_cells_of_front = {NUMBER};"),
    ("docs/choosing.md", r"default is a (\w+) of the tolerance of the steps",
     "packages/dynamics/coupling/CouplingSettings.cpp", rf"share_of_steps = {NUMBER};"),
    ("docs/choosing.md", rf"of the tolerance of the steps, at most {NUMBER}",
     "packages/dynamics/coupling/CouplingSettings.hpp", rf"double tolerance = {NUMBER};"),
]


def found(test, name, pattern):
    text = (SOURCE / name).read_text(encoding="utf-8")
    matches = {match.group(1) for match in re.finditer(pattern, text)}
    test.assertEqual(len(matches), 1, f"{name}: {pattern} finds {sorted(matches)}")
    return matches.pop()


class Constants(unittest.TestCase):
    def test_are_those_of_the_code(self):
        for page, sentence, source, definition, *convert in CONSTANTS:
            with self.subTest(page=page, sentence=sentence):
                said = found(self, page, sentence)
                value = WORDS[said] if said in WORDS else float(said)
                for function in convert:
                    value = function(value)
                self.assertAlmostEqual(value / float(found(self, source, definition)), 1, 12)


if __name__ == "__main__":
    unittest.main()
