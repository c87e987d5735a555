"""Steps end at the instants of the deck, and a run at its final time, whatever the step control."""

import pathlib
import unittest

import asperity_run
from asperity_run import settings

DECK = pathlib.Path(__file__).parent.parent / "bad_input" / "square.xml"
TICK = 0.15 / 2**11  # the smallest step: no larger than 1e-4 s


class Instants(unittest.TestCase):
    def run_deck(self, name, *changes, control="Step Doubling"):
        folder = asperity_run.run_to_end(name, DECK, *settings(
            "Time Stepping/Largest Step=0.15", "Time Stepping/Control=" + control, *changes))
        return asperity_run.table(folder / "steps.csv")

    def assert_met(self, steps, instant):
        nearest = min(row["time"] - instant for row in steps if row["time"] - instant > -1e-9)
        self.assertLess(nearest, TICK)

    def test_a_run_ends_at_its_final_time(self):
        for control in ("Step Doubling", "Richardson", "Prescribed"):
            with self.subTest(control):
                steps = self.run_deck("end", control=control)
                self.assertAlmostEqual(steps[-1]["time"], 0.4, delta=TICK)
                self.assertGreaterEqual(steps[-1]["time"], 0.4 - 1e-9)

    def test_steps_meet_every_instant_once(self):
        times = "Time Stepping/Instants={0.25, 0.1007, 0.101}"
        for control in ("Step Doubling", "Richardson", "Prescribed"):
            with self.subTest(control):
                steps = self.run_deck("met", times, control=control)
                for instant in (0.1007, 0.101, 0.25, 0.4):
                    self.assert_met(steps, instant)
                # beside the steps that meet instants there are no more than before
                plain = self.run_deck("plain", control=control)
                self.assertLess(len(steps), len(plain) + 4 * 24)

    def test_outputs_have_rows_at_their_times(self):
        for control in ("Step Doubling", "Richardson", "Prescribed"):
            with self.subTest(control):
                self.run_deck("rows", *(f"Output/Fault History/{rule}" for rule in (
                    "Times={-1, 0.25, 0.1007, 7}", "Every n Steps=0", "Rate Change Factor=0")),
                              control=control)
                times = asperity_run.series("rows/fault.h5")["time"]
                self.assertEqual(len(times), 4, times)
                for time, expected in zip(times, (0, 0.1007, 0.25, 0.4)):
                    self.assertGreaterEqual(time, expected - 1e-9)
                    self.assertLess(time - expected, TICK)

    def warned(self, name):
        return "'Time Stepping / Instants'" in pathlib.Path(name, "run.log").read_text()

    def test_a_short_pulse_is_seen(self):
        """The fault is pushed for a millisecond, which steps of 0.15 s pass: a run without Instants
        does not see it, and warns, as does a run that begins with its state."""
        pulse = "Friction/Shear Traction=t > 0.2 && t < 0.202 ? 9000 : 0"
        quiet = max(row["peak_slip_rate"] for row in self.run_deck("quiet", control="Prescribed"))
        passed = max(row["peak_slip_rate"]
                     for row in self.run_deck("passed", pulse, control="Prescribed"))
        self.assertEqual(passed, quiet)
        seen = self.run_deck("seen", pulse, "Time Stepping/Instants={0.2, 0.201, 0.202}",
                             control="Prescribed")
        self.assertGreater(max(row["peak_slip_rate"] for row in seen), 10 * quiet)
        asperity_run.run_to_end("child", DECK, *settings(
            "Time Stepping/Largest Step=0.15", "Time Stepping/Control=Prescribed", pulse,
            "Time Stepping/Final Time=0.6"), "--restart-from", "passed")
        self.assertEqual([self.warned(name) for name in ("quiet", "passed", "seen", "child")],
                         [False, True, False, True])


if __name__ == "__main__":
    unittest.main()
