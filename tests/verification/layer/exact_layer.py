"""The layer of layer.xml by its characteristics: no mesh, and errors of second order in the step.

What comes down to the fault at time t is what left it at t - 2T and met the driven top at t - T:
    tau(t) + Z V(t) = tau(t - 2T) - Z V(t - 2T) + 2 Z V_L(t - T),   Z = rho c, T = H / c.
Regularised friction and the ageing law close it.
"""

import math

import numpy

DENSITY, SHEAR_MODULUS, HEIGHT, SIGMA = 1000.0, 1e6, 1.0, 1e4
A, B, L, V_STAR, MU_STAR = 0.010, 0.015, 1e-5, 1e-6, 0.6
V_BEFORE, V_DRIVE = 1e-4, 1.5e-4

IMPEDANCE = math.sqrt(DENSITY * SHEAR_MODULUS)
TRAVEL_TIME = HEIGHT * math.sqrt(DENSITY / SHEAR_MODULUS)


def friction(V, theta):
    """Shear traction in Pa and its derivatives by V and ln(theta)."""
    growth = math.exp((MU_STAR + B * math.log(V_STAR * theta / L)) / A) / (2 * V_STAR)
    direct = SIGMA * A / math.hypot(1, V * growth)
    return SIGMA * A * math.asinh(V * growth), direct * growth, direct * V * growth * B / A


def aged(theta, V, dt):
    """theta after dt at the rate V, and its derivative by V."""
    decay, gain = math.exp(-V * dt / L), -math.expm1(-V * dt / L)
    return theta * decay + gain * L / V, -theta * decay * dt / L - gain * L / V**2 + decay * dt / V


def advance(V, guess, theta, dt, arriving):
    """V, theta and tau after dt where tau + Z V = arriving: Newton's method from the guess."""
    new = guess
    for _ in range(50):
        theta_new, slope = aged(theta, (V + new) / 2, dt)
        tau, by_V, by_log = friction(new, theta_new)
        excess = tau + IMPEDANCE * new - arriving
        change = -excess / (by_V + by_log * slope / 2 / theta_new + IMPEDANCE)
        new = max(new + change, new / 4)
        if abs(change) < 1e-12 * new:
            theta_new, _ = aged(theta, (V + new) / 2, dt)
            return new, theta_new, arriving - IMPEDANCE * new
    raise ArithmeticError(f"no slip rate found from {V} m/s")


def jump(t):
    """The rate of the top of layer.xml."""
    return V_BEFORE + (V_DRIVE - V_BEFORE) * numpy.heaviside(t, 0.5)


def solve(final_time, steps_per_echo, drive=jump):
    """Times and slip rates at the fault; an echo takes 2T, and its number of steps is even. The top
    has the rate drive(t), V_BEFORE for t < 0."""
    dt = 2 * TRAVEL_TIME / steps_per_echo
    size = int(final_time / dt) + 1
    V, tau = numpy.full(size, V_BEFORE), numpy.empty(size)
    theta = L / V_BEFORE
    tau[0] = steady = friction(V_BEFORE, theta)[0]
    for i in range(1, size):
        late = i - steps_per_echo
        left = (tau[late], V[late]) if late >= 0 else (steady, V_BEFORE)
        top = drive((i - steps_per_echo // 2) * dt)
        arriving = left[0] - IMPEDANCE * left[1] + 2 * IMPEDANCE * top
        guess = max(2 * V[i - 1] - V[i - 2], V[i - 1] / 2) if i > 1 else V_BEFORE
        V[i], theta, tau[i] = advance(V[i - 1], guess, theta, dt, arriving)
    return dt * numpy.arange(size), V
