"""The spring-slider of xml/spring_slider.xml as an ordinary differential equation.

    m dV/dt = tau0 + k (V_L t - u) - sigma mu(V, alpha),   du/dt = V,
with regularised friction and the ageing law, m = rho H / 3 and k = G / H. Two steps back for the
momentum (BDF2, variable steps), the trapezoidal rule for u, the exact flow for alpha, and the
logarithm of the slip rate as the unknown; a step may change neither it nor alpha by much.
"""

import dataclasses
import math

A, B, L, SIGMA = 0.010, 0.015, 10e-6, 5e6
V_STAR, MU_STAR, V_DRIVE, TAU0 = 1e-6, 0.6, 1e-6, 3e6
STIFFNESS, MASS = 0.5e9, 2700 / 3
ALPHA, LARGEST_STEP = -0.1, 0.5


@dataclasses.dataclass
class State:
    t: float
    V: float
    u: float
    alpha: float


def aged(alpha, V, dt):
    decay = math.exp(-V * dt / L)
    return math.log(math.exp(alpha) * decay - V_STAR / V * math.expm1(-V * dt / L))


def friction(V, alpha):
    return SIGMA * A * math.asinh(V / (2 * V_STAR) * math.exp((MU_STAR + B * alpha) / A))


def attempt(before, now, dt):
    """The state after dt, or None where Newton's method does not find it."""
    ratio = dt / (now.t - before.t)
    newest, older = (1 + 2 * ratio) / (1 + ratio), ratio**2 / (1 + ratio)

    def after(log_V):
        V = math.exp(log_V)
        mean = (now.V + V) / 2
        return State(now.t + dt, V, now.u + dt * mean, aged(now.alpha, mean, dt))

    def excess(log_V):
        new = after(log_V)
        inertia = MASS * (newest * new.V - (1 + ratio) * now.V + older * before.V) / dt
        spring = STIFFNESS * (V_DRIVE * new.t - new.u)
        return inertia + friction(new.V, new.alpha) - TAU0 - spring

    x = math.log(now.V) + ratio * math.log(now.V / before.V)
    for _ in range(30):
        force = excess(x)
        change = -force * 1e-7 / (excess(x + 1e-7) - force)
        x += max(-1, min(1, change))
        if abs(change) < 1e-9:
            return after(x)
    return None


def solve(final_time, largest_change=0.05):
    """The states of all steps; none changes ln V or alpha by more than twice the largest change."""
    now = State(0, V_STAR * math.exp(-B / A * ALPHA), 0, ALPHA)
    before = dataclasses.replace(now, t=-1e-3)
    states, dt = [now], 1e-3
    while now.t < final_time:
        new = attempt(before, now, dt)
        change = new and max(abs(math.log(new.V / now.V)), abs(new.alpha - now.alpha), 1e-12)
        if new is None or change > 2 * largest_change:
            dt /= 2
            continue
        before, now = now, new
        states.append(now)
        dt = min(LARGEST_STEP, dt * max(0.5, min(1.5, largest_change / change)))
    return states


def events(states, threshold):
    """(onset, peak slip rate, slip) of every time above the threshold."""
    found, begin = [], None
    for last, new in zip(states, states[1:]):
        if new.V > threshold and begin is None:
            begin, peak = last, new.V
        elif begin is not None:
            peak = max(peak, new.V)
            if new.V <= threshold:
                found.append((begin.t, peak, new.u - begin.u))
                begin = None
    return found
