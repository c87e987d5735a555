"""What each scheme leaves of the mode of stiff_mode.xml, a million times faster than the steps."""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("stiff_mode.xml")
FINEST_LEVEL = 30  # 1000 steps a period


def peak_rates(scheme, levels=(0,), **settings):
    """After each step, the first one included; 1 m/s to begin with."""
    settings = {"Scheme": scheme, "Prescribed/Levels": "{%s}" % ",".join(map(str, levels)),
                **settings}
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {f"Time Stepping/{name}": value for name, value in settings.items()}))
    history = asperity_run.series(folder / "fault.h5")
    return history["fields/slip_rate"].max(axis=1)


def alpha(spectral_radius):
    return {"scheme": "Generalised Alpha", "Generalised Alpha/Spectral Radius": spectral_radius}


def verdict(name, fine, V):
    shown = " ".join(f"{value:.3g}" for value in V[[1, 2, 3, 10, -1]])
    print(f"{name:42s} V after 1, 2, 3, 10, {len(V) - 1} steps: {shown} m/s{'' if fine else ' NO'}")
    return fine


def long_steps():
    """Newmark keeps it; radius r has the double factor -r, so that the first step, which starts
    without acceleration, decides: |V| = r^n (1 + n (1 - r^2) / (2 r))."""
    passed = []
    for name, settings in (("Newmark", {"scheme": "Newmark"}), ("Generalised Alpha, 1", alpha(1))):
        V = peak_rates(**settings)
        passed.append(verdict(name, numpy.abs(V - 1).max() < 1e-6, V))
    for radius in (0.5, 0.9):
        V, n = peak_rates(**alpha(radius)), numpy.arange(31)
        expected = radius**n * (1 + n * (1 - radius**2) / (2 * radius))
        fine = numpy.abs(V / expected - 1).max() < 1e-5
        passed.append(verdict(f"Generalised Alpha, {radius:g}", fine, V))
    for name, settings, forgotten in (("Generalised Alpha, 0", alpha(0), 2),
                                      ("Backward Euler", {"scheme": "Backward Euler"}, 1)):
        V = peak_rates(**settings)
        passed.append(verdict(name, V.max() <= 1 and V[forgotten:].max() < 1e-10, V))
    return passed


def growing_steps(repeats, cases):
    """From a thousandth of the period to a million periods, as after an earthquake: `repeats` steps
    of each size. Nothing may grow on the way; cases have the least and the most that may be left.
    """
    levels = [k for k in range(FINEST_LEVEL, -1, -1) for _ in range(repeats)]
    levels = [FINEST_LEVEL] * 500 + levels
    passed = []
    for name, settings, least, most in cases:
        V = peak_rates(levels=levels, **settings)[:len(levels) + 1]
        fine = V.max() < 1 + 1e-6 and least <= V[-4:].max() <= most
        passed.append(verdict(f"{name}, {repeats} steps of a size", fine, V))
    return passed


def main():
    backward_euler = {"scheme": "Backward Euler"}
    passed = long_steps()
    passed += growing_steps(2, [("Newmark", {"scheme": "Newmark"}, 0.5, 1),
                                ("Generalised Alpha, 0.5", alpha(0.5), 0, 1e-6),
                                ("Backward Euler", backward_euler, 0, 1e-8)])
    passed += growing_steps(1, [("Generalised Alpha, 0.5", alpha(0.5), 0, 1e-2),
                                ("Backward Euler", backward_euler, 0, 1e-8)])
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
