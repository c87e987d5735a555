"""Which way is up, which side of a fault is plus, and what the log says of both."""

import json
import pathlib
import re
import unittest

import numpy

import asperity_run
from asperity_run import settings

HERE = pathlib.Path(__file__).parent
TWO_FAULTS, BURIED = HERE / "two_faults.xml", HERE / "buried_fault.xml"
SQUARE = HERE.parent / "bad_input" / "square.xml"
FAULT = "Boundary Conditions/Fault"


def lines_of(deck, *arguments):
    """What --validate prints."""
    result = asperity_run.run(deck, *arguments, "--validate")
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout.splitlines()


class SeveralFaults(unittest.TestCase):
    """The sign of slip on a fault is its own."""

    LEVEL = settings({"Mesh/Faults/level": "abs(y - 2000) < 1 && x > 4999 && x < 7001",
                      "Boundary Conditions/Level/Boundary": "level",
                      "Boundary Conditions/Level/Type": "Two-Sided Fault"})

    def slips(self, name, *arguments, ranks=1):
        """{x, y: slip at the end}."""
        folder = asperity_run.run_to_end(name, TWO_FAULTS, *arguments, ranks=ranks)
        history = asperity_run.series(folder / "fault.h5")
        return dict(zip(map(tuple, history["geometry/coordinates"]),
                        history["fields/slip"][-1].ravel()))

    def test_slip_does_not_depend_on_another_fault(self):
        alone = self.slips("alone")
        self.assertGreater(min(alone.values()), -1e-12)
        for ranks in (1, 2):
            both = self.slips("both", *self.LEVEL, ranks=ranks)
            level = [slip for (x, _), slip in both.items() if x > 3000]
            self.assertGreater(max(level), 0.01)
            self.assertGreater(min(level), -1e-12)
            for place, slip in alone.items():
                self.assertLess(abs(both[place] - slip), 0.1 * max(alone.values()), place)

    def test_a_line_for_each(self):
        lines = lines_of(TWO_FAULTS, *self.LEVEL)
        self.assertIn("Fault 'upright': its plus side lies towards (1, 0); positive slip moves it "
                      "along (0, 1): the plus side up in a section, left lateral in a map.", lines)
        self.assertIn("Fault 'level': its plus side lies towards (0, 1); positive slip moves it "
                      "along (1, 0): right lateral in a map.", lines)

    def test_of_a_ring_plus_is_the_outside(self):
        ring = settings({"Mesh/Rectangle/Cells X": 8, "Mesh/Rectangle/Cells Y": 8,
                         "Mesh/Faults/ring": "abs(max(abs(x-0.5), abs(y-0.5)) - 0.25) < 1e-6",
                         f"{FAULT}/Boundary": "ring", f"{FAULT}/Type": "Two-Sided Fault"})
        self.assertIn("Fault 'ring': its plus side is the outside; positive slip runs "
                      "counterclockwise, seen against +z.", lines_of(SQUARE, *ring))

    def test_an_s_encloses_nothing(self):
        """Its strokes face each other, and the steps between them have an upper side."""
        strokes = ("abs(x - 0.05) < 1e-6 && y > 0.2499 && y < 0.5001",
                   "abs(y - 0.25) < 1e-6 && x > 0.0399 && x < 0.0501",
                   "abs(x - 0.04) < 1e-6 && y > 0.2499 && y < 0.7501",
                   "abs(y - 0.75) < 1e-6 && x > 0.0299 && x < 0.0401",
                   "abs(x - 0.03) < 1e-6 && y > 0.4999 && y < 0.7501")
        bent = settings({"Mesh/Rectangle/Width": 0.08,
                         "Mesh/Rectangle/Cells X": 8, "Mesh/Rectangle/Cells Y": 8,
                         "Mesh/Faults/bent": " || ".join(f"({stroke})" for stroke in strokes),
                         f"{FAULT}/Boundary": "bent", f"{FAULT}/Type": "Two-Sided Fault"})
        line = next(line for line in lines_of(SQUARE, *bent) if line.startswith("Fault 'bent'"))
        self.assertIn("its plus side lies towards (0, 1); positive slip moves it along (1, 0)",
                      line)

    def test_text_files_take_one_sense(self):
        for name, changes, expected in (("one", (), 1), ("two", self.LEVEL, 0)):
            folder = asperity_run.run_to_end(f"sense_{name}", TWO_FAULTS, *changes)
            entries = map(json.loads, (folder / "run.jsonl").read_text().splitlines())
            facts = next(entry for entry in entries if entry["event"] == "fault")
            self.assertEqual(facts["one_sense"], expected)


class Up(unittest.TestCase):
    """It follows from the free surface, and so does gravity."""

    UPRIGHT = settings("Output/Up={0, 0, 1}", "Bulk/Gravity Direction={0, 0, -1}")

    def normal_stress(self, name, *arguments):
        """Places of the nodes, and their normal stress."""
        folder = asperity_run.run_to_end(name, BURIED, *arguments)
        history = asperity_run.series(folder / "fault.h5")
        return history["geometry/coordinates"], history["fields/normal_stress"][-1].ravel()

    def test_weight_presses_as_it_does_where_the_deck_says_so(self):
        places, found = self.normal_stress("silent")
        numpy.testing.assert_array_equal(found, self.normal_stress("said", *self.UPRIGHT)[1])
        depth = -places[:, 2]
        # not at tips, which cannot slip
        inside = (depth > 2100) & (depth < 5900) & (abs(places[:, 1]) < 1900)
        self.assertGreater(inside.sum(), 5)
        expected = 0.25 / 0.75 * 2670 * 9.81 * depth
        numpy.testing.assert_allclose(found[inside], expected[inside], rtol=0.05)

    def test_weight_presses_under_a_loaded_surface(self):
        """It is not a Free Surface, and the one boundary that nothing holds."""
        places, found = self.normal_stress("loaded", *self.loaded("Surface"))
        depth = -places[:, 2]
        inside = (depth > 2100) & (depth < 5900) & (abs(places[:, 1]) < 1900)
        expected = 0.25 / 0.75 * (2670 * 9.81 * depth + 1e7)
        numpy.testing.assert_allclose(found[inside], expected[inside], rtol=0.05)

    @staticmethod
    def loaded(*conditions):
        changes = {}
        for name in conditions:
            changes[f"Boundary Conditions/{name}/Type"] = "Prescribed Traction"
            changes[f"Boundary Conditions/{name}/Pressure"] = 1e7
        return settings(changes)

    def test_a_default_is_a_warning(self):
        """Two sides under a pressure face two ways."""
        warning = ("WARNING: Gravity acts, and nothing says which way is up: it is taken as "
                   "{0, 1, 0}")
        two = self.loaded("Surface", "Left")
        self.assertIn(warning, "\n".join(lines_of(BURIED, *two)))
        for silent in ([*two, *self.UPRIGHT], self.loaded("Surface"),
                       [*two, *settings("Bulk/Gravitational Acceleration=0")]):
            self.assertNotIn("which way is up", "\n".join(lines_of(BURIED, *silent)))

    def test_the_run_keeps_it(self):
        asperity_run.run_to_end("kept", BURIED)
        text = pathlib.Path("kept/parameters.xml").read_text(encoding="utf-8")
        for name, value in (("Up", "{0, 0, 1}"), ("Gravity Direction", "{0, 0, -1}")):
            self.assertRegex(text, rf'name="{name}"[^>]*value="{re.escape(value)}"')

    def test_the_log_says_where_it_is(self):
        for arguments, reason in (([], "where the free surface 'surface' faces"),
                                  (self.UPRIGHT, "as Output / Up says")):
            self.assertIn(f"Up is (0, 0, 1), {reason}; gravity points to (0, 0, -1).",
                          lines_of(BURIED, *arguments))

    def test_strike_dip_and_rake(self):
        """A vertical fault along +y, north, whose plus side is east of it."""
        self.assertIn(
            "Fault 'main': its plus side lies towards (1, 0, 0); slip has parts along the axes; "
            "strike 0, dip 90; along (0, -1, 0) it is right lateral; a positive Shear Traction has "
            "rake 0, left lateral.", lines_of(BURIED))
        lines = lines_of(BURIED, *settings({
            "Boundary Conditions/Main/Plate Rate": 1e-9,
            "Boundary Conditions/Main/Direction": "{0, -1, 0}"}))
        self.assertIn("The plates slip along it at 1e-09 m/s on the average: rake 180, right "
                      "lateral.", lines)

    def test_the_rake_of_prescribed_slip(self):
        """That of its part along the fault, whatever friction would have by default."""
        lines = lines_of(BURIED, "--remove", "Friction", *settings({
            "Output/Fault History/Fields": "{slip}",
            "Boundary Conditions/Main/Type": "Prescribed Slip Rate",
            "Boundary Conditions/Main/Slip Rate": 1e-9,
            "Boundary Conditions/Main/Direction": "{1, -1, 0}"}))
        self.assertIn(
            "Fault 'main': its plus side lies towards (1, 0, 0); slip has parts along the axes; "
            "strike 0, dip 90; along (0, -1, 0) it is right lateral; a positive Slip Rate has "
            "rake 180, right lateral.", lines)

    def test_contradictions(self):
        for change, message in (
                ("Bulk/Gravity Direction={0, -1}", "Asperity / Bulk / Gravity Direction = "
                 "{0, -1, 0}, but the free surface 'surface' faces {0, 0, 1}"),
                ("Output/Up={0, 1, 0}", "Asperity / Output / Up = {0, 1, 0}, but the free surface "
                 "'surface' faces {0, 0, 1}")):
            self.assertTrue(asperity_run.refuses(BURIED, change, message))


class OnTheFault(unittest.TestCase):
    """A receiver in the body takes one side of the fault, and the log says which."""

    CUT = settings({"Mesh/Faults/main": "abs(y - 0.5) < 1e-6", f"{FAULT}/Boundary": "main",
                    f"{FAULT}/Type": "Two-Sided Fault"})
    RECEIVERS = "Output/Receivers/Off Fault"

    def warnings(self, place, ranks=1):
        station = settings({f"{self.RECEIVERS}/station": place})
        result = asperity_run.run(SQUARE, *self.CUT, *station, "--validate", ranks=ranks)
        self.assertEqual(result.returncode, 0, result.stderr)
        return [line for line in result.stdout.splitlines() if "Receivers" in line]

    def test_on_it(self):
        for ranks in (1, 2):
            warning, = self.warnings("{0.3, 0.5}", ranks)
            self.assertRegex(warning, "WARNING: .*'station' at \\(0.3, 0.5\\) m records the "
                                      "(plus|minus) side")

    def test_the_side_is_that_which_is_recorded(self):
        """The upper side is plus and moves with the top; the lower one rests."""
        warning, = self.warnings("{0.3, 0.5}")
        folder = asperity_run.run_to_end("side", SQUARE, *self.CUT, *settings({
            f"{self.RECEIVERS}/station": "{0.3, 0.5}", "Friction/Normal Stress": 0,
            f"{self.RECEIVERS}/above": "{0.3, 0.501}", f"{self.RECEIVERS}/below": "{0.3, 0.499}",
            "Output/Receivers/Body Fields": "{displacement}"}))
        series = asperity_run.series(folder / "receivers.h5")
        names = [name.decode() if isinstance(name, bytes) else name
                 for name in series["off_fault/names"]]
        moves = dict(zip(names, series["off_fault/fields/displacement"][-1, :, 0]))
        nearer = min(("above", "below"), key=lambda name: abs(moves[name] - moves["station"]))
        self.assertGreater(abs(moves["above"] - moves["below"]), 1e-10)
        self.assertIn({"above": "plus", "below": "minus"}[nearer] + " side", warning)

    def test_beside_it(self):
        self.assertEqual(self.warnings("{0.3, 0.501}"), [])


class OnTheGround(unittest.TestCase):
    """The ground of the buried fault is z = 0, with facets of 2.8 km."""

    RECEIVERS = "Output/Receivers/"

    def test_receivers_are_moved_there(self):
        places = settings({f"{self.RECEIVERS}On Ground/level": "{100, 200}",
                           f"{self.RECEIVERS}On Ground/high": "{100, 300, 1500}"})
        for ranks in (1, 2):
            result = asperity_run.run(BURIED, *places, "--validate", ranks=ranks)
            self.assertEqual(result.returncode, 0, result.stderr)
            self.assertIn("Receivers on the ground: 'level' at (100, 200, 0) m, 'high' at (100, "
                          "300, 0) m, 1500 m below the given place.", result.stdout)
            self.assertNotIn("moved to the ground over more than", result.stdout)

    def test_far_from_their_height_it_is_a_warning(self):
        line, = (line for line in lines_of(BURIED, *settings({
            f"{self.RECEIVERS}On Ground/deep": "{100, 200, -3000}"})) if "WARNING" in line
            and "On Ground" in line)
        self.assertIn("'deep' by 3000 m, where the facets of the ground are 2828.43 m long", line)

    def test_above_it_they_are_told_its_height(self):
        self.assertTrue(asperity_run.refuses(
            BURIED, f"{self.RECEIVERS}Off Fault/gps={{100, 200, 60}}",
            "The free surface there is at (100, 200, 0) m, 60 m below it"))


class Tension(unittest.TestCase):
    """A square that is pulled apart across its fault, which the model holds shut: the stress is the
    same everywhere, and all of the fault is in tension."""

    PULLED = [*OnTheFault.CUT, *settings({
        "Bulk/Dynamics": "Quasi-dynamic", "Boundary Conditions/Drive/Direction": "{0, 1}",
        "Boundary Conditions/Drive/Velocity": 0.1,
        "Boundary Conditions/Side/Type": "Sliding Wall",
        "Boundary Conditions/Base/Boundary": "bottom",
        "Boundary Conditions/Base/Type": "Sliding Wall",
        "Output/Receivers/Off Fault/inside": "{0.3, 0.2}",
        "Output/Receivers/Body Fields": "{stress}"})]

    def test_is_a_warning(self):
        for change in ("Fixed", "Lagged", "Coupled"):
            with self.subTest(change):
                folder = asperity_run.run_to_end(
                    "pulled", SQUARE, *self.PULLED,
                    *settings({"Friction/Normal Stress Change": change}))
                series = asperity_run.series(folder / "receivers.h5")
                stress = series["off_fault/fields/stress"][-1, 0, 2]  # yy
                log = (folder / "run.log").read_text(encoding="utf-8")
                found = re.search("WARNING: In this run the body pulls at "
                                  "([0-9.]+) % of the fault, "
                                  "most with ([0-9.e+]+) Pa", log)
                self.assertIsNotNone(found, log)
                self.assertEqual(float(found[1]), 100)
                self.assertAlmostEqual(float(found[2]) / (stress - 1e4), 1, delta=1e-4)
                journal = (folder / "run.jsonl").read_text(encoding="utf-8")
                self.assertIn("fault in tension", journal)

    def test_pressed_it_is_none(self):
        pressed = settings({"Boundary Conditions/Drive/Velocity": -0.1})
        folder = asperity_run.run_to_end("pressed", SQUARE, *self.PULLED, *pressed)
        self.assertNotIn("tension", (folder / "run.jsonl").read_text(encoding="utf-8"))

    def test_at_the_start(self):
        """Its own weight pulls a square that hangs from the ceiling, with 10 kPa where its sides do
        not disturb it."""
        lines = lines_of(SQUARE, "--remove", "Friction/Normal Stress", *settings({
            f"{FAULT}/Boundary": "top", "Boundary Conditions/Drive/Boundary": "right",
            "Boundary Conditions/Drive/Velocity": 0,
            "Boundary Conditions/Side/Type": "Sliding Wall",
            "Bulk/Gravitational Acceleration": 10}))
        warning, = [line for line in lines if line.startswith("WARNING: The static solution")]
        found = re.search("pulls at 100 % of the fault, most with ([0-9.e+]+) Pa", warning)
        self.assertIsNotNone(found, warning)
        self.assertAlmostEqual(float(found[1]) / 1e4, 1, delta=0.05)


class AgainstTheLoad(unittest.TestCase):
    """A square that starts to slip against the shear traction that acts on it."""

    WARNING = "At the start friction acts with the load instead of against it over 100 %"

    def log(self, changes, ranks=1):
        folder = asperity_run.run_to_end("against", SQUARE, *settings({
            "Friction/Shear Traction": 6e3, "Initial State/State": "Steady",
            "Time Stepping/Final Time": 0.1, **changes}), ranks=ranks)
        return (folder / "run.log").read_text(encoding="utf-8")

    def test_is_a_warning(self):
        for ranks in (1, 2):
            self.assertIn(self.WARNING, self.log({"Initial State/Slip Rate": -1e-6}, ranks))

    def test_with_it_there_is_none(self):
        for legal in ({"Initial State/Slip Rate": 1e-6}, {"Initial State/Slip Rate": 0,
                                                          "Initial State/State": "Given"},
                      {"Initial State/Slip Rate": "abs(x - 0.5) < 0.2 ? -1e-6 : 1e-6"},
                      {"Initial State/Slip Rate": 1e-6, "Friction/Shear Traction": 9e3},
                      {"Initial State/Slip Rate": 1e-6, "Friction/Shear Traction": 0}):
            with self.subTest(legal):
                self.assertNotIn("friction acts with", self.log(legal))


if __name__ == "__main__":
    unittest.main()
