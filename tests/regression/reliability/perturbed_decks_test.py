"""Every parameter of a deck, perturbed: the deck is valid, or refused in a few lines that name what
is wrong."""

import pathlib
import random
import time
import unittest
import xml.etree.ElementTree as xml

import asperity_run
import faults

DECKS = asperity_run.SOURCE / "xml"
REGRESSION = asperity_run.SOURCE / "tests" / "regression"
SHORT = [REGRESSION / "bad_input" / "square.xml", REGRESSION / "parallel" / "coarse_wedge.xml"]
LONG = [DECKS / name for name in ("wedge_2d.xml", "bp1_fd.xml", "wedge_3d.xml")]
SAMPLE = 40  # of the short form
SECONDS = 20
LINES = 6


def set_value(value, kind=None):
    def change(parameter):
        parameter.set("value", value)
        if kind:
            parameter.set("type", kind)
    return change


def misspell(parameter):
    name = parameter.get("name")
    parameter.set("name", name[:-1] + ("x" if name[-1] != "x" else "y"))


CHANGES = {"wrong type": set_value("perhaps", "bool"), "nan": set_value("nan"),
           "inf": set_value("inf"), "negative": set_value("-1.5"), "huge": set_value("1e308"),
           "empty": set_value(""), "misspelt": misspell, "unparsable": set_value("1 + * x"),
           "divides by zero": set_value("1/(x-x)"), "missing": None}


def perturbations(deck):
    """(index of the parameter, name of the change) of all of them."""
    number = len(list(xml.parse(deck).getroot().iter("Parameter")))
    return [(index, change) for index in range(number) for change in CHANGES]


def perturbed(deck, index, change):
    """The tree, and the names of the parameter and of the lists that it is in."""
    tree = xml.parse(deck)
    parents = {child: parent for parent in tree.iter() for child in parent}
    parameter = list(tree.getroot().iter("Parameter"))[index]
    names, parent = [parameter.get("name")], parents[parameter]
    while parent is not tree.getroot():
        names.append(parent.get("name"))
        parent = parents[parent]
    if CHANGES[change]:
        CHANGES[change](parameter)
    else:
        parents[parameter].remove(parameter)
    return tree, names


class PerturbedDecks(unittest.TestCase):
    def check(self, deck, index, change, counts):
        tree, names = perturbed(deck, index, change)
        tree.write("perturbed.xml")
        begin = time.monotonic()
        result = asperity_run.run("perturbed.xml", "--validate", timeout=4 * SECONDS)
        seconds = time.monotonic() - begin
        counts[result.returncode] = counts.get(result.returncode, 0) + 1
        self.assertIn(result.returncode, (0, 2), result.stderr)
        if result.returncode == 0:
            self.assertEqual(result.stderr, "")
            return
        self.assertTrue(result.stderr.startswith("asperity: "), result.stderr)
        self.assertLessEqual(len(result.stderr.splitlines()), LINES, result.stderr)
        if change == "missing":  # the default may be what is wrong
            names = ["Asperity / "]
        self.assertTrue(any(name in result.stderr for name in names), (names, result.stderr))
        if faults.is_long():
            self.assertLess(seconds, SECONDS)

    def test_all(self):
        cases = [(deck, *case) for deck in (LONG if faults.is_long() else SHORT)
                 for case in perturbations(deck)]
        if not faults.is_long():
            cases = random.Random(1).sample(cases, SAMPLE)
        counts = {}
        for deck, index, change in cases:
            with self.subTest(deck=pathlib.Path(deck).name, index=index, change=change):
                self.check(deck, index, change, counts)
        print(f"{len(cases)} perturbations, by status: {counts}")


if __name__ == "__main__":
    unittest.main()
