"""Friction that follows the normal stress with slip and time (Prakash and Clifton), by whole runs.

    ds/dt = (V / L_pc + 1 / T_pc) (sigma - s),   sigma the normal stress less the pressure of fluids
"""

import math
import sys

import asperity_run
import comparisons
import normal_stress
import numpy
import time_orders

DECK = normal_stress.DECK
ANTIPLANE = DECK.parent.parent / "schemes" / "smooth.xml"
CHANGE = normal_stress.CHANGE
SLIP, TIME = 2e-5, 0.15  # L_pc, a fifth of the run's slip; T_pc, as long as the state needs
FIELDS = (*normal_stress.FIELDS, "regularised_normal_stress")
OUTPUT = "Output/Fault History/Fields"


def scales(slip=None, time=None):
    given = {"Slip Distance": slip, "Time": time}
    return {CHANGE: "Prakash-Clifton", **{f"Friction/Prakash-Clifton/{name}": value
                                          for name, value in given.items() if value is not None}}


REGULARISED = {**scales(SLIP, TIME), OUTPUT: "{slip, slip_rate, alpha, traction, normal_stress, "
                                             "regularised_normal_stress, effective_normal_stress}"}


def run(folder, settings, deck=DECK, **options):
    return asperity_run.run_to_end(folder, deck, *asperity_run.settings(settings), **options)


def verdict(name, value, fine):
    print(f"{name}: {value}{'' if fine else ' NO'}", flush=True)
    return fine


def followed(history, slip_distance, time):
    """s at the ends of the steps, from the slip and the effective stress of each step."""
    sigma = history["fields/effective_normal_stress"]
    s = [sigma[0]]
    for n, tau in enumerate(numpy.diff(history["time"])):
        x = abs(history["fields/slip"][n + 1] - history["fields/slip"][n]) / slip_distance
        x += tau / time
        s.append(sigma[n + 1] + (s[-1] - sigma[n]) * numpy.exp(-x)
                 + (sigma[n + 1] - sigma[n]) * numpy.expm1(-x) / x)
    return numpy.array(s)


def equation():
    """Of its value, in the plane and, where no motion presses, antiplane under a normal stress
    that changes in time and a pressure that rises; and friction bears mu s."""
    fluid = {"Enabled": "true", "Permeability": 1e-20, "Storage": 1e-9, "Width": 1,
             "Injection": 4e-6}
    pressure = {**{f"Friction/Pore Pressure/{name}": value for name, value in fluid.items()},
                "Friction/Normal Stress": "1e4 * (1 + 0.1 * sin(9 * t))"}
    passed = []
    for name, deck, more in (("plane strain", DECK, {}), ("antiplane", ANTIPLANE, pressure)):
        history = asperity_run.series(run("out", {**REGULARISED, **more}, deck) / "fault.h5")
        found, sigma = (history[f"fields/{field}"] for field in
                        ("regularised_normal_stress", "effective_normal_stress"))
        error = numpy.abs(found - followed(history, SLIP, TIME)).max() / 1e4
        apart = numpy.abs(found - sigma).max() / 1e4
        V, alpha = history["fields/slip_rate"][1:], history["fields/alpha"][1:]
        mu = 0.010 * numpy.arcsinh(V / 2e-6 * numpy.exp((0.6 + 0.015 * alpha) / 0.010))
        of_friction = numpy.abs(history["fields/traction"][1:] / (mu * found[1:]) - 1).max()
        fine = error < 1e-9 and of_friction < 1e-8 and apart > 0.01
        passed.append(verdict(f"{name}: {apart:.3f} from the effective stress",
                              f"errors {error:.1e}, {of_friction:.1e}", fine))
    return passed


def limits():
    """Followed at once, it is the answer of Coupled; never, that of Fixed."""
    passed = []
    for change, extreme in (("Coupled", scales(time=1e-12)), ("Coupled", scales(slip=1e-18)),
                            ("Fixed", scales(time=1e12)), ("Fixed", scales(slip=1e9))):
        settings = {"Time Stepping/Prescribed/Levels": "{1}"}
        expected, found = (time_orders.at_times(run("out", {**settings, **more}),
                                                ("slip", "slip_rate", "alpha", "traction"))
                           for more in ({CHANGE: change}, extreme))
        difference = max(numpy.abs(found[name] - values).max() / numpy.ptp(values)
                         for name, values in expected.items())
        passed.append(verdict(f"limit {change}", f"differs by {difference:.1e}", difference < 1e-6))
    return passed


def events():
    """Followed at once, a block that sticks and slips has the events of Coupled."""
    settings = {"Bulk/Shear Modulus": 2e6, "Time Stepping/Final Time": 9,
                "Time Stepping/Control": "Step Doubling",
                "Time Stepping/Step Doubling/Tolerance": 1e-4,
                "Output/Event Catalogue/Threshold": 4e-4}
    expected, found = (asperity_run.table(run("out", {**settings, **more}) / "events.csv")
                       for more in ({CHANGE: "Coupled"}, scales(time=1e-12)))
    columns = ("onset", "peak_slip_rate", "peak_slip")
    difference = max((abs(ours[name] / theirs[name] - 1) for ours, theirs in zip(found, expected)
                      for name in columns), default=math.inf)
    fine = len(found) == len(expected) >= 3 and difference < 1e-6
    return verdict(f"{len(found)} events, {len(expected)} with Coupled",
                   f"differ by {difference:.1e}", fine)


def convergence():
    def solve(level):
        folder = run("out", {**REGULARISED, "Time Stepping/Prescribed/Levels": f"{{{level}}}"})
        return time_orders.at_times(folder, FIELDS)

    solutions = [solve(level) for level in normal_stress.LEVELS]
    return time_orders.check("Prakash-Clifton", solutions, solve(normal_stress.REFERENCE_LEVEL),
                             numpy.ptp, *normal_stress.SECOND)


def solvers():
    """Two ranks and multigrid agree with one rank; the balance of energy closes; J never rises."""
    reference = run("direct", REGULARISED)
    answer = time_orders.at_times(reference, FIELDS)
    found = time_orders.at_times(
        run("out", {**REGULARISED, "TNNMG/Linear Correction": "Multigrid"}, ranks=2), FIELDS)
    difference = max(numpy.abs(numpy.sort(found[key], axis=1) -
                               numpy.sort(answer[key], axis=1)).max()
                     / numpy.ptp(answer[key]) for key in FIELDS)
    last = asperity_run.table(reference / "steps.csv")[-1]
    defect = abs(last["energy_defect"]) / last["friction_work"]
    return [verdict("multigrid, 2 ranks", f"differs by {difference:.1e}", difference < 1e-8),
            verdict("energy defect over friction work", f"{defect:.1e}", defect < 1e-9)]


def restarted():
    """Stopped half way and continued: the bytes of a run that was not."""
    settings = {**REGULARISED, "Time Stepping/Control": "Step Doubling",
                "Time Stepping/Step Doubling/Tolerance": 1e-5, "Time Stepping/Instants": "{0.24}"}
    whole = run("whole", settings)
    half = run("half", {**settings, "Time Stepping/Final Time": 0.24})
    asperity_run.go_on(half, DECK, *asperity_run.settings(settings))
    comparisons.assert_same_results(whole, half, ["fault.h5"], ["steps.csv"])
    print("restart: the same", flush=True)


def carried():
    """The state goes to another mesh, with its regularised stress."""
    half = run("half", {**REGULARISED, "Time Stepping/Final Time": 0.24})
    before = asperity_run.series(half / "fault.h5")
    finer = {**REGULARISED, "Mesh/Rectangle/Cells X": 12, "Mesh/Rectangle/Cells Y": 12}
    other = asperity_run.run_to_end("other", DECK, "--restart-from", half,
                                    *asperity_run.settings(finer))
    after = asperity_run.series(other / "fault.h5")
    name = "fields/regularised_normal_stress"
    order_there, order_here = (numpy.argsort(each["geometry/coordinates"][:, 0])
                               for each in (before, after))
    coarse, fine = before[name][-1][order_there], after[name][0][order_here]
    error = numpy.abs(fine[::2] - coarse).max() / 1e4
    lag = numpy.abs(coarse - before["fields/normal_stress"][-1][order_there]).max() / 1e4
    return verdict(f"another mesh, {lag:.3f} from the normal stress", f"error {error:.1e}",
                   error < 1e-12 and lag > 1e-3)


def refused():
    path = "Asperity / Friction / Prakash-Clifton"
    return [asperity_run.refuses(DECK, scales(), f"{path}: neither Slip Distance nor Time"),
            asperity_run.refuses(DECK, scales(slip=0), "Slip Distance"),
            asperity_run.refuses(DECK, scales(time=-1), "Time"),
            asperity_run.refuses(DECK, {**scales(time=1), "Friction/c": 0.2},
                                 "Normal Stress Floor")]


def main():
    passed = [*equation(), *limits(), events(), convergence(), *solvers(), carried(), *refused()]
    restarted()
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
