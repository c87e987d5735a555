"""A rupture by another method: the spectral boundary integral of Geubelle & Rice (1995) for slip
along a line in the whole space, in explicit steps.

    tau = tau_0 + f - G / (2 c_s) V
    f_k(t) = -G |k| / 2 int_0^t C(|k| c_s s) D_k(t - s) |k| c_s ds
    C(T) = J_1(T) / T + 4 T [W(r T) - W(T)] - 4 / r J_0(r T) + 3 J_0(T),   r = c_p / c_s,
    W(T) = 1 - int_0^T J_1(x) / x dx
in plane strain, C(T) = J_1(T) / T in antiplane shear, with the slip D, its rate V, and their
Fourier components along the line, which is periodic: longer than waves travel. The slip rate
follows from the friction that equals tau.
"""

import copy
import math

import asperity_run
import numpy
from sequence import check


def bessel(order, x):
    """J_0 or J_1 at x >= 0: the integral of Bessel as a sum, for large x Hankel's expansion."""
    small = numpy.minimum(x, 30)
    angles = (numpy.arange(100) + 0.5) * math.pi / 100
    near = sum(numpy.cos(order * a - small * math.sin(a)) for a in angles) / 100
    large = numpy.maximum(x, 30)
    terms, term = [], numpy.ones_like(large)
    for k in range(1, 8):
        terms.append(term)
        term = term * (4 * order**2 - (2 * k - 1)**2) / (8 * k * large)
    p = terms[0] - terms[2] + terms[4] - terms[6]
    q = terms[1] - terms[3] + terms[5]
    angle = large - order * math.pi / 2 - math.pi / 4
    far = numpy.sqrt(2 / (math.pi * large)) * (p * numpy.cos(angle) - q * numpy.sin(angle))
    return numpy.where(x < 30, near, far)


def kernel(largest, ratio, spacing=0.01):
    """Values of T up to `largest` and C there; in antiplane shear `ratio` is None."""
    x = numpy.arange(0, (ratio or 1) * largest + 2 * spacing, spacing)
    j1 = bessel(1, x)
    over_x = numpy.concatenate([[0.5], j1[1:] / x[1:]])
    if ratio is None:
        return x, over_x
    w = 1 - numpy.concatenate([[0], numpy.cumsum((over_x[1:] + over_x[:-1]) / 2 * spacing)])
    t = x[x <= largest + spacing]
    at = ratio * t
    return t, (over_x[:len(t)] + 4 * t * (numpy.interp(at, x, w) - w[:len(t)])
               - 4 / ratio * bessel(0, at) + 3 * bessel(0, t))


class SlipWeakening:
    """The fault rests below strength(slip) [Pa], which is infinite where it is locked."""

    def __init__(self, strength):
        self.strength = strength

    def rate(self, traction, impedance, slip):
        """Where traction - impedance V is the friction at V."""
        return numpy.maximum(traction - self.strength(slip), 0) / impedance

    def advance(self, rate, step):
        """Strength depends on slip alone."""


class RateAndState:
    """tau = sigma a asinh[V / (2 V0) exp(psi / a)], psi' = -(V / L) (psi - psi_ss(V))."""

    def __init__(self, a, normal_stress, reference_rate, distance, steady, psi):
        self.a, self.normal_stress, self.reference_rate = a, normal_stress, reference_rate
        self.distance, self.steady, self.psi = distance, steady, psi

    def rate(self, traction, impedance, slip):
        """By bisection of log V: friction grows with V."""
        del slip
        low, high = numpy.full(len(self.a), -90.0), numpy.log(traction / impedance)
        for _ in range(55):
            middle = (low + high) / 2
            z = middle - math.log(2 * self.reference_rate) + self.psi / self.a
            friction = self.normal_stress * self.a * numpy.arcsinh(numpy.exp(z))
            too_fast = friction + impedance * numpy.exp(middle) > traction
            low, high = numpy.where(too_fast, low, middle), numpy.where(too_fast, middle, high)
        return numpy.exp((low + high) / 2)

    def advance(self, rate, step):
        """Exact at this rate."""
        steady = self.steady(rate)
        self.psi = steady + (self.psi - steady) * numpy.exp(-rate * step / self.distance)


class Rupture:
    """x [m], the slip `slip` [m] and the first time `arrival` [s] at which its rate is 1 mm/s."""

    def __init__(self, length, num_nodes, rock, stress, friction=None):
        """rock: (G [Pa], c_s, c_p [m/s]), in antiplane shear without c_p; stress(x, t) [Pa] that
        loads the fault."""
        self.x = (numpy.arange(num_nodes) - num_nodes // 2) * length / num_nodes
        self.modulus, self.shear_speed = rock[:2]
        self.ratio = rock[2] / self.shear_speed if len(rock) > 2 else None
        self.stress, self.friction = stress, friction
        self.slip = numpy.zeros(num_nodes)
        self.arrival = numpy.full(num_nodes, math.inf)
        self.wavenumbers = 2 * math.pi * numpy.fft.rfftfreq(num_nodes, length / num_nodes)

    def rate(self, functional, time):
        return self.friction.rate(self.stress(self.x, time) + functional,
                                  self.modulus / (2 * self.shear_speed), self.slip)

    def run(self, final_time, courant=0.3):
        num_nodes = len(self.x)
        step = courant * (self.x[1] - self.x[0]) / self.shear_speed
        num_steps = math.ceil(final_time / step)
        speeds = self.wavenumbers * self.shear_speed
        t, values = kernel(speeds[-1] * step * num_steps, self.ratio)
        # Weights of the trapezoidal sum, latest slip first.
        weights = numpy.array([numpy.interp(speeds * step * n, t, values)
                               for n in range(num_steps + 1)])
        weights *= -self.modulus / 2 * self.wavenumbers * speeds * step
        weights[0] /= 2
        history = numpy.zeros((num_steps + 1, len(speeds)), complex)

        def functional(n):
            past = numpy.einsum("mk,mk->k", weights[n:0:-1], history[:n]) if n else 0
            return past, lambda: numpy.fft.irfft(
                past + weights[0] * numpy.fft.rfft(self.slip), num_nodes)

        before = self.rate(functional(0)[1](), 0)
        for n in range(1, num_steps + 1):
            _, with_slip = functional(n)
            start, friction = self.slip, self.friction
            self.friction = copy.copy(friction)
            self.slip = start + step * before
            self.friction.advance(before, step)
            mean = (before + self.rate(with_slip(), n * step)) / 2
            self.friction = friction
            self.slip = start + step * mean
            self.friction.advance(mean, step)
            after = self.rate(with_slip(), n * step)
            history[n] = numpy.fft.rfft(self.slip)
            reached = (after >= 1e-3) & ~numpy.isfinite(self.arrival)
            share = (1e-3 - before) / numpy.where(after > before, after - before, 1)
            self.arrival[reached] = (n - 1 + numpy.clip(share[reached], 0, 1)) * step
            before = after
        return self


def meets(expected, folder, places, of_arrivals, of_slip):
    """Whether a run has the arrivals and the last slips of a Rupture at the places [m]."""
    rupture = asperity_run.series(folder / "rupture.h5")
    receivers = asperity_run.series(folder / "receivers.h5")
    x, slip = receivers["on_fault/coordinates"][:, 0], receivers["on_fault/fields/slip"][-1]
    fine = True
    for place in places:
        at = numpy.flatnonzero(expected.x == place)[0]
        arrival = numpy.interp(place, rupture["geometry/coordinates"][:, 0],
                               rupture["first_rupture_time"])
        fine = check(f"arrival at {place / 1e3} km [s]", arrival, expected.arrival[at],
                     of_arrivals) and fine
        found = abs(slip[numpy.flatnonzero(x == place)[0]].ravel()[0])
        fine = check(f"slip at {place / 1e3} km [m]", found, expected.slip[at], of_slip) and fine
    return fine
