"""Slip and pressure in the decks of the example of a plugin, by the classical method of Runge and
Kutta, to rounding."""

import math

DISTANCE, RATE, FILM, END = 1e-3, 1e-6, 500.0, 1000.0
SHARE, RELAXATION = 0.75, 200.0  # of the shear modulus
PRESSURE, DRAINAGE = 0.5, 200.0  # of the normal stress
DILATANCY = 1e9  # Pa/m


def rates(time, slip, strained):
    """Of the slip and of the displacement whose stress relaxes; viscous.xml has the equations."""
    film = FILM * (1 - PRESSURE * math.exp(-time / DRAINAGE))
    rate = ((1 - SHARE) * (RATE * time - slip) + SHARE * strained) / film
    return rate, RATE - rate - strained / RELAXATION


def exact_slip(time):
    """By the classical method of Runge and Kutta, to rounding."""
    count = 1 + int(time)
    step, at = time / count, (0.0, 0.0)

    def moved(by, along):
        return [x + by * rate for x, rate in zip(at, along)]

    for k in (step * i for i in range(count)):
        first = rates(k, *at)
        second = rates(k + step / 2, *moved(step / 2, first))
        third = rates(k + step / 2, *moved(step / 2, second))
        fourth = rates(k + step, *moved(step, third))
        at = moved(step / 6, [a + 2 * b + 2 * c + d
                              for a, b, c, d in zip(first, second, third, fourth)])
    return at[0]


def exact_dilation(time):
    """Slip [m] and pressure [Pa] of gouge that dilates as well, by the classical method of Runge
    and Kutta."""
    count = 1 + int(4 * time)
    step, at = time / count, (0.0, 0.0, 0.0)

    def change(now, values):
        slip, strained, pressure = values
        share = 1 - PRESSURE * math.exp(-now / DRAINAGE) - pressure / 1e6
        rate = ((1 - SHARE) * (RATE * now - slip) + SHARE * strained) / (FILM * share)
        return (rate, RATE - rate - strained / RELAXATION,
                -pressure / DRAINAGE - DILATANCY * rate)

    for i in range(count):
        now = step * i
        first = change(now, at)
        second = change(now + step / 2, [x + step / 2 * r for x, r in zip(at, first)])
        third = change(now + step / 2, [x + step / 2 * r for x, r in zip(at, second)])
        fourth = change(now + step, [x + step * r for x, r in zip(at, third)])
        at = [x + step / 6 * (a + 2 * b + 2 * c + d)
              for x, a, b, c, d in zip(at, first, second, third, fourth)]
    return at[0], at[2]
