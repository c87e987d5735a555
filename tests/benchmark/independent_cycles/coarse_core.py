"""The first event of SEAS BP5-QD by the independent program: coarse_core.py CELL [m]. Slip goes along
strike alone. Prints, of the places that docs/results.md compares, when they pass 1 cm/s, their peak
slip rate and their slip after 60 s."""

import dataclasses
import sys

import numpy
from earthquake_cycles import Cycles, Problem
from strike_slip_operators import StrikeSlipElements

LENGTH, DEPTH = 100e3, 40e3  # of the fault with friction [m]
END = 90  # s
PLACES = {"strk+00dp10": (0, 10e3), "strk+16dp10": (16e3, 10e3), "strk+00dp00": (0, 0),
          "strk+16dp00": (16e3, 0), "strk-24dp00": (-24e3, 0)}


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


def main(cell):
    operator = StrikeSlipElements(cell, round(LENGTH / cell), round(DEPTH / cell),
                                  Problem.shear_modulus)
    operator.positions[:, 0] -= LENGTH / 2
    cycles = Cycles(problem_on(operator), operator, 1e-5, first_step=1e-3)
    # The elements that touch a place, whose mean is taken.
    near = {name: numpy.abs(operator.positions - place).max(axis=1) < 0.51 * cell
            for name, place in PLACES.items()}
    times, rates, slips = [], [], []
    while cycles.time < END:
        cycles.advance()
        times.append(cycles.time)
        rates.append([cycles.rates[chosen].mean() for chosen in near.values()])
        slips.append([cycles.total_slip()[chosen].mean() for chosen in near.values()])
        if len(times) % 200 == 0:
            print(f"{cycles.time:.3f} s, {len(times)} steps, {cycles.rates.max():.3g} m/s",
                  flush=True)
    rates, slips = numpy.array(rates), numpy.array(slips)
    for number, name in enumerate(near):
        fast = numpy.flatnonzero(rates[:, number] > 0.01)
        arrival = times[fast[0]] if len(fast) else numpy.inf
        print(f"{name}: 1 cm/s after {arrival:.2f} s, at most {rates[:, number].max():.3f} m/s, "
              f"{numpy.interp(60, times, slips[:, number]):.2f} m after 60 s", flush=True)


if __name__ == "__main__":
    sys.exit(main(float(sys.argv[1])))
