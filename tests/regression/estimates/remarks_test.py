"""What --validate says of decks that are valid and probably not what was meant."""

import pathlib
import re
import sys
import unittest

import asperity_run
from asperity_run import settings

sys.path.insert(0, str(asperity_run.SOURCE / "python"))
from asperity_status.facts import facts  # noqa: E402 pylint: disable=wrong-import-position

XML = asperity_run.SOURCE / "xml"
STRIP = XML / "spring_slider.xml"
BP1, BP6, WEDGE = XML / "bp1_qd.xml", XML / "bp6.xml", XML / "wedge_2d.xml"


def lines(deck, *changes, options=(), ranks=1):
    result = asperity_run.run(deck, *settings(*changes), *options, "--validate", ranks=ranks)
    if result.returncode != 0:
        raise AssertionError(result.stderr)
    return result.stdout.splitlines()


def those_with(words, *arguments, **more):
    return [line for line in lines(*arguments, **more) if words in line]


class UnreadEntries(unittest.TestCase):
    WORDS = "has no effect: only"
    TOLERANCE = "Time Stepping/Richardson/Tolerance"  # the deck has Step Doubling

    def overlay(self, name, text):
        path = pathlib.Path(name).absolute()
        path.write_text(f'<ParameterList name="Asperity"><ParameterList name="Time Stepping">{text}'
                        "</ParameterList></ParameterList>")
        return str(path)

    def test_an_entry_of_another_choice_is_named(self):
        for deck in (WEDGE, XML / "lake_2d.xml"):  # defaults of a scheme are no entries
            self.assertEqual(those_with(self.WORDS, deck), [])
        told = those_with(self.WORDS, WEDGE, {self.TOLERANCE: 1e-3})
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], "^WARNING: Time Stepping / Richardson / Tolerance has no effect: "
                         "only Time Stepping / Control = Richardson reads it, but it is Step "
                         "Doubling")
        told = those_with(self.WORDS, WEDGE, {
            f"Time Stepping/{entry}": value for entry, value in (
                ("Richardson/Tolerance", 1e-3), ("Richardson/First Step", 1e-3),
                ("Newmark/beta", 0.3), ("Newmark/Stability Limit", 1), ("Control", "Step Doubling"),
                ("Scheme", "Backward Euler"))})
        self.assertIn("And 1 more of them.", told[0])

    def test_what_an_override_puts_out_of_force_is_no_mistake(self):
        given = [each for each in those_with("Step Doubling", WEDGE, "Time Stepping/Control="
                                             "Richardson") if "WARNING" in each]
        self.assertEqual(given, [])
        # but it is where the override gives the entry itself
        told = those_with(self.WORDS, WEDGE, "Time Stepping/Control=Richardson",
                          "Time Stepping/Step Doubling/Tolerance=0.0123")
        self.assertEqual(len(told), 1)

    def test_overlays_are_like_overrides(self):
        control = '<Parameter name="Control" type="string" value="{}"/>'
        richardson = ('<ParameterList name="Richardson"><Parameter name="Tolerance" type="double" '
                      'value="1e-3"/></ParameterList>')
        chosen = self.overlay("chosen.xml", control.format("Richardson") + richardson)
        back = self.overlay("back.xml", control.format("Step Doubling"))
        alone = self.overlay("alone.xml", richardson)
        for overlays, number in (((chosen,), 0), ((chosen, back), 0), ((alone,), 1),
                                 ((back, alone), 1)):
            options = [word for name in overlays for word in ("--overlay", name)]
            self.assertEqual(len(those_with(self.WORDS, WEDGE, options=options)), number, overlays)

    def test_run_and_status_have_it_and_a_restart_does_not_repeat_it(self):
        folder = pathlib.Path("unread").absolute()
        change = {"Time Stepping/Prescribed/Levels": "{3}"}
        for options in (("--overwrite",), None):
            if options is None:
                result = asperity_run.run("--restart", folder)
            else:
                result = asperity_run.run(STRIP, *settings(change), "--output", folder, *options)
            self.assertEqual(result.returncode, 0, result.stderr)
            log = (folder / "run.log").read_text()
            self.assertEqual(log.count("Time Stepping / Prescribed"), log.count("WARNING"))
            self.assertIn("unread parameters", str(facts(folder, 600.0)))


class Coupling(unittest.TestCase):
    def test_a_tolerance_above_that_of_the_steps_is_questioned(self):
        words = "the errors that it leaves add up"
        for value, number in ((1e-2, 1), (1e-4, 0)):  # the steps have 1e-4
            told = those_with(words, BP1, {"Coupling/Tolerance": value})
            self.assertEqual(len(told), number)
            self.assertTrue(all(line.startswith("WARNING: Coupling / Tolerance = 0.01 is above")
                                for line in told))
        self.assertEqual(those_with(words, WEDGE), [])


class FlatCells(unittest.TestCase):
    def test_beside_prescribed_slip_they_are_questioned(self):
        deck, words = XML / "known_slip_2d.xml", "along which slip is prescribed"
        self.assertEqual(those_with(words, deck), [])
        told = those_with(words, deck, "Mesh/Flat Cells Beside={thrust}")
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], "^WARNING: Mesh / Flat Cells Beside names 'thrust'")


class HeldEnds(unittest.TestCase):
    WORDS = "which prescribes the slip of"

    def test_a_driven_end_is_named(self):
        told = those_with(self.WORDS, WEDGE)
        self.assertEqual(len(told), 1)
        self.assertRegex(told[0], r"^The fault ends on the boundary 'right' \(Prescribed Velocity\)"
                         r", which prescribes the slip of its node at \(1.0[0-9]*, 0\) m: up to "
                         r"[45][.0-9]*e-05 m/s\.$")

    def test_an_end_on_a_fixed_boundary_is_a_warning(self):
        """Also on two ranks."""
        for ranks in (1, 2):
            told = those_with(self.WORDS, WEDGE, {
                "Boundary Conditions/Backstop/Type": "Fixed"}, ranks=ranks, options=(
                    "--remove", "Boundary Conditions/Backstop/Velocity",
                    "--remove", "Boundary Conditions/Backstop/Direction",
                    "--remove", "Boundary Conditions/Backstop/Ramp Duration"))
            self.assertEqual(len(told), 1)
            self.assertRegex(told[0], r"^WARNING: The fault ends on the boundary 'right' "
                             r"\(Fixed\), which prescribes the slip of its node at .* m: none\.")

    def test_continuations_and_walls_that_leave_slip_free_are_none(self):
        for deck in (BP1, XML / "bp5_qd.xml"):
            self.assertEqual(those_with(self.WORDS, deck), [])

    def test_a_node_is_told_of_once(self):
        """In the corners of the driven backstop and the walls all slip is prescribed."""
        told = those_with(self.WORDS, XML / "wedge_3d.xml")
        self.assertEqual(len(told), 1)
        self.assertIn("'right' (Prescribed Velocity), which prescribes the slip of 2 of its nodes,",
                      told[0])


class Drives(unittest.TestCase):
    WORDS = "Plates move at"

    def test_a_plate_in_mm_per_year_is_questioned(self):
        for velocity, number in ((30, 1), (1.5, 1), (0.5, 0), ("t < 1e9 ? 0 : 30", 1)):
            told = those_with(self.WORDS, BP1, {"Boundary Conditions/Plate/Velocity": velocity})
            self.assertEqual(len(told), number, (velocity, told))
        self.assertIn("Plate / Velocity reaches 30 m/s", told[0])

    def test_waves_may_be_driven_faster(self):
        for velocity, number in ((30, 1), (5, 0)):
            told = those_with(self.WORDS, BP1, {"Boundary Conditions/Plate/Velocity": velocity,
                                                "Bulk/Dynamics": "Inertial"})
            self.assertEqual(len(told), number, (velocity, told))


class Wells(unittest.TestCase):
    def test_each_has_a_line(self):
        for place, nodes in (("{0, 0}", "one node takes its rate."),
                             ("{0, -60}", "2 nodes of a cell share its rate.")):
            for ranks in (1, 2):
                told = those_with("Well 'well'", BP6, {
                    "Friction/Pore Pressure/Wells/well/Place": place}, ranks=ranks)
                self.assertEqual(len(told), 1)
                found = re.match(r"Well 'well' meets the fault at \((.*)\) m, where cells have a "
                                 r"size of ([0-9.]+) m: (.*)$", told[0])
                self.assertEqual((found[1], found[3]), (place.strip("{}"), nodes))
                self.assertLess(float(found[2]), 100.0)


if __name__ == "__main__":
    unittest.main()
