"""SEAS BP7-QD-A and BP8-QD-GS by the independent program: whole_space.py bp7|bp8 CELL [m]. Slip is
along strike alone, in a square of 800 m around which the fault moves with the plates. No answer of
another group is at hand: the limits are the program's own numbers with cells of 10 m."""

import dataclasses
import sys

import gaussian_source
import numpy
from earthquake_cycles import Cycles, Problem

SIDE = 800.0
PERIOD = 4 * SIDE  # copies of the square act on it with less than (1/4)^3 of its own stress
LIMIT = 0.005
# Place along strike and down from the middle [m]: {time [s]: slip [m]}.
ANSWERS = {
    "bp7": {(0, 0): {4: 0.022545, 1.8e7: 0.022546, 2e7: 0.041334},
            (100, 0): {4: 0.016587, 2e7: 0.035336}, (-100, 0): {4: 0.020118},
            (0, 100): {4: 0.016137}, (0, -100): {4: 0.019971}, (300, 0): {2e7: 0.023642}},
    "bp8": {(0, 0): {1e5: 0.0041801, 360e3: 0.037935, 2.592e6: 0.038124},
            (200, 0): {360e3: 0.010922, 2.592e6: 0.021876}, (0, 200): {2.592e6: 0.020021},
            (200, 200): {2.592e6: 0.016614}}}


class Square:
    """Elements of one slip each; stress of slip along x by Fourier series, whose waves have the
    stiffness G / 2 (kx^2 / (1 - nu) + ky^2) / |k|."""

    def __init__(self, cell, modulus, poissons_ratio=0.25):
        self.across, self.count = round(SIDE / cell), round(PERIOD / cell)
        along = (numpy.arange(self.across) + 0.5) * cell - SIDE / 2
        self.positions = numpy.stack(numpy.meshgrid(along, along), axis=-1).reshape(-1, 2)
        k_x, k_y = (2 * numpy.pi * frequencies(self.count, cell)
                    for frequencies in (numpy.fft.rfftfreq, numpy.fft.fftfreq))
        size = numpy.hypot(k_y[:, None], k_x)
        size[0, 0] = 1
        self.stiffness = modulus / 2 * (k_x**2 / (1 - poissons_ratio) + k_y[:, None]**2) / size

    def stress_of(self, slip):
        shape = (self.count, self.count)
        modes = numpy.fft.rfft2(slip.reshape(self.across, self.across), shape)
        stress = -numpy.fft.irfft2(self.stiffness * modes, shape)
        return stress[:self.across, :self.across].ravel(), 0.

    def near(self, place):
        """The elements that touch a place, whose mean is taken."""
        distance = numpy.abs(self.positions - place).max(axis=1)
        return distance < distance.min() * 1.01


@dataclasses.dataclass(frozen=True)
class Bp7(Problem):
    """A circle that weakens; the first event is started within a second."""
    critical_slip: float = 0.0005
    positions: numpy.ndarray = None
    b: float = 0.01
    normal_stress: float = 25e6

    def a(self, positions):
        return numpy.where(numpy.hypot(*positions.T) < 200, 0.004, 0.016)

    def initial_state(self, positions):
        steady = (self.reference_friction
                  + self.b * numpy.log(self.reference_rate / self.plate_rate))
        return numpy.full(len(positions), steady)

    def initial_stress(self):
        a = self.a(self.positions)
        growth = numpy.exp(self.initial_state(self.positions) / a)
        return (self.normal_stress * a
                * numpy.arcsinh(self.plate_rate / (2 * self.reference_rate) * growth)
                + self.damping * self.plate_rate)

    def imposed(self, time):
        square = ((self.positions + 50)**2).sum(axis=1)
        inside = numpy.where(square < 150**2, square, 0)
        place = numpy.where(square < 150**2, numpy.exp(inside / (inside - 150**2)), 0)
        growth = (1 if time >= 1 else
                  numpy.exp((time - 1)**2 / (time * (time - 2))) if time > 1e-6 else 0)
        return 1.75e6 * place * growth, 0.


@dataclasses.dataclass(frozen=True)
class Bp8(Problem):
    """Water is pumped into a fault that strengthens; beyond the square it is as good as locked."""
    critical_slip: float = 0.0005
    positions: numpy.ndarray = None
    b: float = 0.01
    normal_stress: float = 25e6
    plate_rate: float = 1e-12

    def a(self, positions):
        return numpy.full(len(positions), 0.016)

    def initial_stress(self):
        return 14.6e6

    def initial_state(self, positions):
        a = self.a(positions)
        return a * numpy.log(2 * self.reference_rate / self.plate_rate
                             * numpy.sinh(14.6e6 / (a * self.normal_stress)))

    def imposed(self, time):
        along = numpy.unique(self.positions)
        return 0., -gaussian_source.pressure(time, along, along[:, None]).ravel()


def misses(deck, cell):
    operator = Square(cell, Problem.shear_modulus)
    problem, first_step = (Bp7, 1e-3) if deck == "bp7" else (Bp8, 1.)
    cycles = Cycles(problem(positions=operator.positions), operator, 1e-5, first_step)
    answers = ANSWERS[deck]
    end = max(time for expected in answers.values() for time in expected)
    times, slips = [], []
    while cycles.time < end:
        cycles.advance()
        times.append(cycles.time)
        slips.append([cycles.total_slip()[operator.near(place)].mean() for place in answers])
    for slip, (place, expected) in zip(numpy.transpose(slips), answers.items()):
        for time, answer in expected.items():
            found = numpy.interp(time, times, slip)
            print(f"{place} after {time:g} s: {found:.5g} m")
            yield abs(found / answer - 1)


def main(deck, cell):
    return int(max(misses(deck, float(cell))) > LIMIT)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
