"""How a small disturbance of steady sliding on a linear body grows: e^(st) with

    a sigma - b sigma (V/L) / (s + V/L) + (K(s) + eta s) V / s = 0,

K and eta the traction per unit slip of the body and per unit slip rate of the radiation damping.
Both friction laws and both state laws have this linearisation.
"""

import dataclasses

import numpy


@dataclasses.dataclass(frozen=True)
class Fault:
    """Rate-and-state friction that slides at V."""
    a: float
    b: float
    L: float
    sigma: float
    V: float

    def critical_stiffness(self, damping=0):
        """Per slip; sliding on a spring without mass that is softer is unstable."""
        return ((self.b - self.a) * self.sigma - damping * self.V) / self.L

    def characteristic(self, s, stiffness):
        """s (s + V/L) times the equation above; stiffness is K + eta s."""
        r = self.V / self.L
        return self.sigma * s * (self.a * (s + r) - self.b * r) + stiffness * self.V * (s + r)


def rates(fault, stiffness, iterations=40):
    """All roots with Im s >= 0 that Newton's method finds from a grid of starts, the one with the
    largest real part first; stiffness(s) is K + eta s, s an array."""
    scale = fault.V / fault.L
    x, y = numpy.meshgrid(numpy.linspace(-1, 1, 11), numpy.linspace(1e-6, 4, 21))
    s, step = scale * (x + 1j * y).ravel(), 1e-6 * scale
    for _ in range(iterations):
        around = numpy.stack((s - step, s, s + step))
        with numpy.errstate(all="ignore"):
            before, here, after = fault.characteristic(around, stiffness(around))
            change = 2 * step * here / (after - before)
        s = s - change
        near = numpy.abs(s) < 10 * scale  # what strays is given up; so is nan
        s, change = s[near], change[near]
    s = s[(numpy.abs(change) < 1e-9 * scale) & (s.imag > -1e-9 * scale)]
    _, first = numpy.unique(numpy.round(s / (1e-6 * scale)), return_index=True)
    return sorted(s[first], key=lambda root: -root.real)
