"""The frame of the boundary that drives a run."""

import unittest

import numpy as np

from asperity_plot import loading
from asperity.parameters import Parameters

CONDITION = {"Boundary Conditions/Back/Type": "Prescribed Velocity",
             "Boundary Conditions/Back/Velocity": "2.0",
             "Boundary Conditions/Back/Direction": "{-3, 4}",
             "Boundary Conditions/Back/Ramp Duration": "10"}


class LoadingTest(unittest.TestCase):
    def test_the_displacement_is_the_integral_of_the_ramped_velocity(self):
        boundary = loading.read(Parameters(CONDITION))
        times = np.linspace(0, 30, 3001)
        middle = (times[1:] + times[:-1]) / 2
        ramp = np.where(middle < 10, (1 - np.cos(np.pi * middle / 10)) / 2, 1)
        expected = np.concatenate([[0], np.cumsum(ramp) * (times[1] - times[0])])
        shown = boundary.displacement(times)
        np.testing.assert_allclose(shown[:, 0], -0.6 * 2 * expected, atol=1e-5)
        np.testing.assert_allclose(shown[:, 1], 0.8 * 2 * expected, atol=1e-5)

    def test_without_one_driving_boundary_there_is_no_frame(self):
        self.assertIsNone(loading.read(Parameters({})))
        fixed = dict(CONDITION)
        fixed["Boundary Conditions/Back/Type"] = "Fixed"
        self.assertIsNone(loading.read(Parameters(fixed)))
        second = {path.replace("Back", "Front"): value for path, value in CONDITION.items()}
        self.assertIsNone(loading.read(Parameters({**CONDITION, **second})))
