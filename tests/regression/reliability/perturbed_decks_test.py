"""Every parameter of a deck, perturbed: the deck is valid, or refused in a few lines that name it,
or what it is a part of.

The short form takes a sample of two small decks. The long form goes through all decks in xml/: each
of their parameters once, and each kind of parameter with each change in one deck or another."""

import collections
import pathlib
import random
import re
import time
import unittest
import xml.etree.ElementTree as xml

import asperity_run
import deck_meshes
import faults
import mesh_files
import time_limits

REGRESSION = asperity_run.SOURCE / "tests" / "regression"
SHORT = [REGRESSION / "bad_input" / "square.xml", REGRESSION / "parallel" / "coarse_wedge.xml"]
SAMPLE = 40  # of the short form
SECONDS = 20
LINES = 6

# A mesh of fewer vertices takes a fraction of a second: cells so many times larger,
LARGER_CELLS = {"bp1_fd": 8, "bp1_qd": 8, "bp1_qd_two_sided": 8, "bp2_qd": 16, "bp5_fd": 4,
                "bp5_qd": 4, "bp7": 4, "bp8": 4, "megathrust_2d": 2, "megathrust_3d": 2,
                "off_fault_2d": 4, "off_fault_cycle_2d": 8, "opening_thrust_2d": 4,
                "opening_well_2d": 4, "step_over_3d": 4, "tpv101_2d": 4, "tpv101_3d": 4,
                "tpv101_two_sided": 4, "tpv104_3d": 4, "tpv105_3d": 4, "tpv205_3d": 4}
# or made from a geometry with cells of this size in m.
SIZES = {"bp3_qd": 2e3, "conjugate_3d": 4e3, "network_2d": 1.2e3, "postseismic_2d": 4e3,
         "splay_2d": 4e3, "subduction_2d": 4e3, "subduction_3d": 8e3, "subduction_cycle_2d": 4e3,
         "subduction_cycle_3d": 12e3}


# What several parameters make together is refused by a message about it, which does not name these
# ones of them. A parameter that is missing has a default, and its message is about what follows.
MADE_TOGETHER = {
    "the number of cells cannot be counted": ["Height", "Length", "slope"],
    "The cohesive zone G' L / (b sigma_n)": ["Gravitational Acceleration", "Normal Stress Factor",
                                             "Width", "upper"],
    "The initial acceleration was not found": ["Normal Stress", "Shear Viscosity", "Velocity", "a",
                                               "alpha"],
    "The static problem has no solution": ["upper"],
    "friction would have to push": ["Density", "Slip Direction", "Slip Rate", "Velocity X",
                                    "Velocity Z", "angle", "s_max", "s_min", "shear"],
    "no state alpha": ["Reference Friction Coefficient", "Slip Rate", "a"],
    "the initial slip rate is zero": ["Slip Rate"],
    "the boundary has no facet": ["Height", "Size", "creeping"],
    "the fault has no facet": ["Cell Size", "Lower Left"],
    "the mesh has no such boundary": ["Type", "Width"],
    "is not a region of the mesh": ["Viscous Thickness", "Cell Size"],
    "is less than the largest one": ["Largest Step"],
    "is less than a thousandth of the smallest step": ["Transient Shear Modulus", "Viscosity"],
    "the region has no cell": ["distance"],
    "at the start the rock at": ["XX", "YY", "ZZ"],
    "but the mesh has 2 dimensions": ["Type"],
    " contradicts ": ["Plate Rate", "Velocity"],
    "Seismogenic Zone End = ": ["zone_end"],
    "Seismogenic Zone Width = ": ["zone_width"],
    "m outside of the fault": ["Lowest Corner"],
    "without gravity there is no normal stress": ["Gravitational Acceleration"]}


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


def path_of(parameter, parents):
    """Names of the lists that it is in, without the root, and its own."""
    names = []
    while parameter in parents:
        names.insert(0, parameter.get("name"))
        parameter = parents[parameter]
    return tuple(names)


def parents_in(tree):
    return {child: parent for parent in tree.iter() for child in parent}


def paths_in(deck):
    tree = xml.parse(deck)
    parents = parents_in(tree)
    return [path_of(parameter, parents) for parameter in tree.getroot().iter("Parameter")]


def kind_of(path):
    """Parameters that differ in names which the user has given are of one kind."""
    names = list(path)
    given = {"Boundary Conditions": 1, "Names": 1}.get(names[0])
    if path[:2] in (("Mesh", "Boundaries"), ("Mesh", "Faults")) or names[0] == "Bulk":
        given = 2
    elif path[:2] == ("Output", "Receivers"):
        given = 3
    if given is not None and given < len(names):
        names[given] = "*"
    return tuple(names)


def all_cases(decks):
    """(deck, index of the parameter, name of the change) of all of them."""
    return [(deck, index, change) for deck in decks for index in range(len(paths_in(deck)))
            for change in CHANGES]


def spread_cases(decks):
    """As many as it takes for each parameter to come once, and each kind with each change."""
    places = collections.defaultdict(list)
    for deck in decks:
        for index, path in enumerate(paths_in(deck)):
            places[kind_of(path)].append((deck, index))
    chance = random.Random(1)
    cases = []
    for of_kind in places.values():
        changes = chance.sample(list(CHANGES), len(CHANGES))
        chance.shuffle(of_kind)
        cases += [(*of_kind[i % len(of_kind)], changes[i % len(changes)])
                  for i in range(max(len(of_kind), len(changes)))]
    chance.shuffle(cases)
    return cases


def made_quick(deck):
    """The same deck on a coarser mesh."""
    tree = xml.parse(deck)
    if deck.stem in SIZES:
        deck_meshes.make_meshes(deck, "--set", f"h={SIZES[deck.stem]}")
    for parameter in tree.getroot().iter("Parameter"):
        if parameter.get("name") == "Cell Size" and deck.stem in LARGER_CELLS:
            value = f"{LARGER_CELLS[deck.stem]} * ({parameter.get('value')})"
            if parameter.get("type") == "double":
                value = str(LARGER_CELLS[deck.stem] * float(parameter.get("value")))
            parameter.set("value", value)
    pathlib.Path("quick").mkdir(exist_ok=True)
    tree.write(f"quick/{deck.name}")
    return pathlib.Path(f"quick/{deck.name}")


def perturbed(deck, index, change):
    """The tree, and what the parameter is called before and after."""
    tree = xml.parse(deck)
    parameter = list(tree.getroot().iter("Parameter"))[index]
    name = parameter.get("name")
    if CHANGES[change]:
        CHANGES[change](parameter)
    else:
        parents_in(tree)[parameter].remove(parameter)
    return tree, {name, parameter.get("name")}


def is_named(name, message):
    """As a whole word; a word of one letter, such as a, in a path, in quotes or in a list."""
    before = r"(/ |'|, )" if len(name) == 1 else r"(?<!\w)"
    return re.search(rf"{before}{re.escape(name)}(?!\w)", message)


def is_quoted(path, message):
    """A name is a piece of text in expressions of other entries: the message quotes one of them."""
    return path[0] == "Names" and re.search(r" = '.*' is (no valid expression|.*, outside )",
                                            message, re.DOTALL)


def is_made_together(names, message):
    return any(piece in message and not names.isdisjoint(of_piece)
               for piece, of_piece in MADE_TOGETHER.items())


class PerturbedDecks(unittest.TestCase):
    def check(self, deck, index, change, results):
        tree, names = perturbed(deck, index, change)
        tree.write("perturbed.xml")
        begin = time.monotonic()
        result = asperity_run.run("perturbed.xml", "--validate", timeout=4 * SECONDS)
        seconds = time.monotonic() - begin
        results.append((result.returncode, seconds))
        self.assertIn(result.returncode, (0, 2), result.stderr)
        self.assertLess(seconds, time_limits.seconds(SECONDS), result.stderr)
        if result.returncode == 0:
            self.assertEqual(result.stderr, "")
            return
        self.assertTrue(result.stderr.startswith("asperity: "), result.stderr)
        self.assertLessEqual(len(result.stderr.splitlines()), LINES, result.stderr)
        if not any(is_named(name, result.stderr) for name in names):
            self.not_named += 1
            self.assertTrue(is_quoted(paths_in(deck)[index], result.stderr)
                            or is_made_together(names, result.stderr), (names, result.stderr))

    def check_all(self, cases):
        self.not_named = 0
        results = collections.defaultdict(list)
        for deck, index, change in cases:
            path = " / ".join(paths_in(deck)[index])
            with self.subTest(deck=deck.name, parameter=path, change=change):
                self.check(deck, index, change, results[deck.name])
        for name, of_deck in sorted(results.items()):
            statuses = dict(sorted(collections.Counter(code for code, _ in of_deck).items()))
            slowest = max(seconds for _, seconds in of_deck)
            print(f"{name}: {len(of_deck)} perturbations, by status: {statuses}, at most "
                  f"{slowest:.1f} s")
        print(f"{len(cases)} perturbations; {self.not_named} messages name what the parameter is a "
              "part of, not the parameter")

    def test_all(self):
        if not faults.is_long():
            self.check_all(random.Random(1).sample(all_cases(SHORT), faults.trials(SAMPLE, None)))
            return
        decks = [deck for deck in deck_meshes.DECKS
                 if mesh_files.MESH_TOOL.exists() or not deck_meshes.meshes_of(deck)]
        decks = [made_quick(deck) for deck in decks]
        for deck in decks:  # what is not valid is not spoilt by a perturbation
            result = asperity_run.run(deck, "--validate")
            self.assertEqual((result.returncode, result.stderr), (0, ""), deck)
        cases = spread_cases(decks)
        self.check_all(cases[:faults.trials(None, len(cases))])


if __name__ == "__main__":
    unittest.main()
