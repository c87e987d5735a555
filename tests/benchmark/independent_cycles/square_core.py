"""The first event of SEAS BP5-QD by the independent program: square_core.py CELL [m]. Slip goes
along strike alone. No answer of another group is at hand that has converged at the surface, so
this one stands for it: the limits are its own numbers."""

import dataclasses
import sys

import numpy
from earthquake_cycles import Cycles, Problem
from strike_slip_operators import StrikeSlipElements

LENGTH, DEPTH = 100e3, 40e3  # of the fault with friction [m]
END = 90  # s
# Receiver: where it is, along strike and down [m]; with cells of 500 m when it slips at 1 cm/s [s],
# its peak rate [m/s], its slip after 60 s [m]. Limits chosen when these had been found.
PLACES = {"strk+00dp+10": ((0, 10e3), (26.28, 0.874, 6.96)),
          "strk+16dp+10": ((16e3, 10e3), (33.77, 0.985, 6.19)),
          "strk+00dp+00": ((0, 0), (40.17, 0.663, 4.58)),
          "strk+16dp+00": ((16e3, 0), (45.72, 0.511, 3.52)),
          "strk-24dp+00": ((-24e3, 0), (47.48, 0.256, 2.07))}
LIMIT = 0.01


@dataclasses.dataclass(frozen=True)
class Bp5(Problem):
    """Jiang et al. (2022), doi 10.1029/2021JB023519."""
    positions: numpy.ndarray = None  # along strike from the middle, depth [m]
    b: float = 0.03
    normal_stress: float = 25e6

    def a(self, positions):
        x, depth = positions.T
        beyond = numpy.maximum(abs(depth - 10e3) - 6e3, abs(x) - 30e3)
        return 0.004 + 0.036 * numpy.clip(beyond / 2e3, 0, 1)

    def square(self):
        x, depth = self.positions.T
        return (abs(x + 24e3) < 6e3) & (abs(depth - 10e3) < 6e3)

    def initial_stress(self):
        a = self.a(self.positions)
        rate = numpy.where(self.square(), 0.03, self.plate_rate)
        state = self.initial_state(self.positions)
        return (self.normal_stress * a
                * numpy.arcsinh(rate / (2 * self.reference_rate) * numpy.exp(state / a))
                + self.damping * rate)

    def initial_state(self, positions):
        steady = (self.reference_friction
                  + self.b * numpy.log(self.reference_rate / self.plate_rate))
        return numpy.full(len(positions), steady)


def problem_on(operator):
    whole = Bp5(critical_slip=0.14, positions=operator.positions)
    return dataclasses.replace(whole, critical_slip=numpy.where(whole.square(), 0.13, 0.14))


def check_against_screw_dislocations():
    """Slip that does not change along strike is antiplane: in the middle of a long fault."""
    cell, rows = 1e3, 6
    operator = StrikeSlipElements(cell, 400, rows, Problem.shear_modulus)
    found = operator.kernel[:, :, 0] + 2 * operator.kernel[:, :, 1:].sum(axis=2)
    depth, ends = operator.depths[:, None], cell * numpy.arange(rows + 1)
    dislocations = 1 / (depth - ends) - 1 / (depth + ends)  # and their images
    exact = Problem.shear_modulus / (2 * numpy.pi) * numpy.diff(dislocations, axis=1)
    assert numpy.abs(found - exact).max() < 1e-3 * numpy.abs(exact).max()


def main(cell):
    check_against_screw_dislocations()
    operator = StrikeSlipElements(cell, round(LENGTH / cell), round(DEPTH / cell),
                                  Problem.shear_modulus)
    operator.positions[:, 0] -= LENGTH / 2
    cycles = Cycles(problem_on(operator), operator, 1e-5, first_step=1e-3)
    # The elements that touch a place, whose mean is taken.
    near = [numpy.abs(operator.positions - place).max(axis=1) < 0.51 * cell
            for place, _ in PLACES.values()]
    times, rates, slips = [], [], []
    while cycles.time < END:
        cycles.advance()
        times.append(cycles.time)
        rates.append([cycles.rates[chosen].mean() for chosen in near])
        slips.append([cycles.total_slip()[chosen].mean() for chosen in near])
    rates, slips = numpy.array(rates), numpy.array(slips)
    misses = []
    for number, (name, (_, expected)) in enumerate(PLACES.items()):
        fast = numpy.flatnonzero(rates[:, number] > 0.01)
        arrival = times[fast[0]] if len(fast) else numpy.inf
        found = (arrival, rates[:, number].max(), numpy.interp(60, times, slips[:, number]))
        print(f"{name}: 1 cm/s after %.2f s, at most %.3f m/s, %.2f m after 60 s" % found)
        misses.append(numpy.abs(numpy.divide(found, expected) - 1).max())
    return int(max(misses) > LIMIT)


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1])))
