"""Quasi-dynamic earthquakes on a fault with the regularised law and the ageing law, by an explicit
Runge-Kutta scheme: SEAS BP1, BP2 and BP3, independent of everything that the program does.

An operator has `positions`, the distances down dip [m] at which slip and stress are known, and
`stress_of(slip)`: what slip beyond that of the plates adds to shear stress and compression [Pa].
"""

import dataclasses

import numpy

YEAR = 31557600.  # s


@dataclasses.dataclass(frozen=True)
class Problem:
    """SEAS BP1-QD (Erickson et al. 2020) but for L, and BP3-QD (Erickson et al. 2023) with 8 mm;
    psi = f* + b ln(V* theta / L)."""
    critical_slip: float  # L [m]
    shear_modulus: float = 32.038120320e9
    shear_speed: float = 3464.
    b: float = 0.015
    largest_a: float = 0.025
    normal_stress: float = 50e6
    reference_rate: float = 1e-6
    reference_friction: float = 0.6
    plate_rate: float = 1e-9
    length: float = 40e3  # of the fault, down dip [m]

    def imposed(self, time):
        """Shear stress and compression that come with time [Pa]."""
        return 0., 0.

    @property
    def damping(self):
        return self.shear_modulus / (2 * self.shear_speed)

    def a(self, positions):
        return 0.010 + 0.015 * numpy.clip((positions - 15e3) / 3e3, 0, 1)

    def initial_stress(self):
        at_plate_rate = (self.reference_friction
                         + self.b * numpy.log(self.reference_rate / self.plate_rate))
        strength = numpy.arcsinh(self.plate_rate / (2 * self.reference_rate)
                                 * numpy.exp(at_plate_rate / self.largest_a))
        return (self.normal_stress * self.largest_a * strength
                + self.damping * self.plate_rate)

    def initial_state(self, positions):
        """psi in balance with the initial stress at the plate rate."""
        a = self.a(positions)
        x = (self.initial_stress() - self.damping * self.plate_rate) / (a * self.normal_stress)
        return a * (numpy.log(self.reference_rate / self.plate_rate) + x
                    + numpy.log1p(-numpy.exp(-2 * x)))


class Cycles:
    """Goes on from step to step: `time` [s], `slip` beyond that of the plates, `rates` [m/s]."""

    def __init__(self, problem, operator, tolerance, first_step=1e3):
        self.problem, self.operator, self.tolerance = problem, operator, tolerance
        self.a = problem.a(operator.positions)
        self.time, self.step = 0., first_step
        count = len(operator.positions)
        self.slip = numpy.zeros(count)
        self.psi = problem.initial_state(operator.positions)
        self._log_rate = numpy.full(count, numpy.log(problem.plate_rate))
        self._slope = self._slopes(0., self.slip, self.psi)

    @property
    def rates(self):
        return numpy.exp(self._log_rate)

    def total_slip(self):
        return self.slip + self.problem.plate_rate * self.time

    def _balance(self, stress, sigma, psi):
        """ln V with stress = a sigma asinh(V / (2 V*) exp(psi / a)) + eta V, by Newton."""
        p, log_rate = self.problem, self._log_rate
        for _ in range(60):
            rate = numpy.exp(log_rate)
            q = log_rate - numpy.log(2 * p.reference_rate) + psi / self.a
            small = numpy.exp(numpy.minimum(q, 20))  # asinh(e^q) is q + ln 2 beyond, to rounding
            strength = numpy.where(q > 20, q + numpy.log(2), numpy.arcsinh(small))
            growth = numpy.where(q > 20, 1., small / numpy.sqrt(1 + small ** 2))
            rest = p.damping * rate + self.a * sigma * strength - stress
            change = -rest / (p.damping * rate + self.a * sigma * growth)
            log_rate = log_rate + numpy.clip(change, -2, 2)
            if numpy.abs(change).max() < 1e-11:
                break
        return log_rate

    def _slopes(self, time, slip, psi):
        p = self.problem
        shear, compression = self.operator.stress_of(slip)
        imposed = p.imposed(time)
        self._log_rate = self._balance(p.initial_stress() + shear + imposed[0],
                                       p.normal_stress + compression + imposed[1], psi)
        rate = self.rates
        ageing = (p.b * p.reference_rate / p.critical_slip
                  * (numpy.exp((p.reference_friction - psi) / p.b) - rate / p.reference_rate))
        return numpy.array([rate - p.plate_rate, ageing])

    def advance(self):
        """One step of Bogacki and Shampine's third-order pair; its last slope is the next first."""
        p, count = self.problem, len(self.psi)
        scale = 10 * self.tolerance * numpy.array([numpy.broadcast_to(p.critical_slip, count),
                                                   numpy.full(count, p.b)])
        start = numpy.array([self.slip, self.psi])
        while True:
            dt, k1, before = self.step, self._slope, self._log_rate
            k2 = self._slopes(self.time + dt / 2, *(start + dt / 2 * k1))
            k3 = self._slopes(self.time + dt * 3 / 4, *(start + dt * 3 / 4 * k2))
            end = start + dt * (2 / 9 * k1 + 1 / 3 * k2 + 4 / 9 * k3)
            k4 = self._slopes(self.time + dt, *end)
            error = dt * (-5 / 72 * k1 + 1 / 12 * k2 + 1 / 9 * k3 - 1 / 8 * k4)
            error = numpy.abs(error / scale).max()
            self.step = dt * (min(4., max(0.2, 0.9 * error ** (-1 / 3)))
                              if 0 < error < numpy.inf else 0.25)
            if error <= 1:
                self.time += dt
                self.slip, self.psi = end
                self._slope = k4
                return
            self._log_rate = before


@dataclasses.dataclass
class Event:
    onset: float           # [yr], when the fastest node passes 1 mm/s
    slip: numpy.ndarray    # [m]


def events(problem, operator, end, tolerance=1e-6):
    """Yields the events up to `end` [yr]; one has ended when all is slower than 0.1 mm/s."""
    cycles = Cycles(problem, operator, tolerance)
    onset = before = None
    while cycles.time < end * YEAR or onset is not None:
        cycles.advance()
        fastest = cycles.rates.max()
        if onset is None and fastest > 1e-3:
            onset, before = cycles.time / YEAR, cycles.total_slip()
        elif onset is not None and fastest < 1e-4:
            yield Event(onset, cycles.total_slip() - before)
            onset = None
