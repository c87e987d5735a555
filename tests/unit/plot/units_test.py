"""Readable units and numbers."""

import unittest

from asperity import durations
from asperity_plot import units


class Units(unittest.TestCase):
    def test_text_has_a_suitable_prefix(self):
        self.assertEqual(units.text(0.1543, "s"), "154 ms")
        self.assertEqual(units.text(17.0, "s"), "17.0 s")
        self.assertEqual(units.text(1800.0, "s"), "1800 s")
        self.assertEqual(units.text(0.2412, "m"), "24.1 cm")
        self.assertEqual(units.text(0.00245, "m"), "2.45 mm")
        self.assertEqual(units.text(12345.0, "m"), "12.3 km")
        self.assertEqual(units.text(1e-9, "m/s"), "1.00 nm/s")
        self.assertEqual(units.text(0.0, "m"), "0 m")
        self.assertEqual(units.text(0.02, "s", 1), "20 ms")

    def test_years_for_real_faults(self):
        unit = units.duration(200.0 * units.YEAR)
        self.assertEqual(unit.name, "yr")
        self.assertAlmostEqual(float(unit(units.YEAR)), 1.0)

    def test_times_as_people_write_them(self):
        for text, expected in (("5yr", 5 * 3.15576e7), ("1", 1.0), (" 2.5 h ", 9000.0),
                               ("20ms", 0.02), ("1e3s", 1000.0), ("-3d", -259200.0)):
            self.assertAlmostEqual(durations.seconds(text), expected, places=9)
        for text in ("", "yr", "5 weeks", "1e999", "five", "1 2s"):
            with self.assertRaisesRegex(ValueError, f"'{text}' is"):
                durations.seconds(text)

    def test_plain_text_has_no_idle_digits(self):
        self.assertEqual(units.plain(5 * units.YEAR, "s"), "5 yr")
        self.assertEqual(units.plain(1.0, "s"), "1 s")
        self.assertEqual(units.plain(0.25, "s"), "250 ms")
        self.assertEqual(units.plain(1e-3, "m/s"), "1 mm/s")

    def test_powers_of_ten_for_what_is_large(self):
        unit = units.scientific([2.5e17, -3.0], "N")
        self.assertEqual((unit.name, unit.factor), ("$10^{15}$ N", 1e15))
        self.assertEqual(units.scientific([2500.0], "N").name, "kN")

    def test_prefix_at_a_power_of_ten(self):
        self.assertEqual(units.prefixed([1e-3], "m").name, "mm")
        self.assertEqual(units.prefixed([999e-6], "m").name, "µm")

    def test_not_finite_values_do_not_set_the_unit(self):
        self.assertEqual(units.prefixed([float("nan"), 0.5], "J").name, "mJ")

    def test_nice_steps(self):
        for step, expected in ((2.13, 2.0), (0.0257, 0.02), (7.0, 5.0), (1.0, 1.0), (0.99, 0.5)):
            self.assertAlmostEqual(units.nice(step), expected)
