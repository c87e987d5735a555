"""A rupture between unlike rocks (rupture.xml) on cells that are halved, and its warning.

Where friction follows the normal stress with time, what one sees of the rupture converges. Where it
follows at once, the shorter the waves that cells resolve, the faster they grow: it does not.
"""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("rupture.xml")
CHANGE = "Friction/Normal Stress Change"
HALVINGS = {"Prakash-Clifton": (0, 1), "Coupled": (0, 1, 2)}  # of cells and steps of rupture.xml
PLACE = 3000          # along the fault, far from where it is forced to slip
PEAK = f"peak rate at {PLACE} m [m/s]"
TOPIC = "The rock differs across the fault"


def observed(change, halvings):
    """{quantity: value} of a run."""
    folder = asperity_run.run_to_end(
        f"{change}_{halvings}", DECK, *asperity_run.settings({
            CHANGE: change, "Mesh/Rectangle/Cell Size Factor": 0.5**halvings,
            "Time Stepping/Prescribed/Levels": f"{{{halvings}}}"}), timeout=900)
    assert (TOPIC in (folder / "run.log").read_text()) == (change == "Coupled")
    history = asperity_run.series(folder / "fault.h5")
    x, t = history["geometry/coordinates"][:, 0], history["time"]
    node = numpy.abs(x - PLACE).argmin()
    rate, slip = history["fields/slip_rate"], history["fields/slip"]
    order = numpy.argsort(x)
    potency = numpy.trapz(slip[-1][order], x[order])
    # the time when it has slipped by 1 cm, between steps
    before = numpy.argmax(abs(slip[:, node]) > 0.01) - 1
    share = (0.01 - abs(slip[before, node])) / abs(slip[before + 1, node] - slip[before, node])
    return {PEAK: rate[:, node].max(),
            f"slip at {PLACE} m [m]": abs(slip[-1, node]), "potency [m^2]": abs(potency),
            f"arrival at {PLACE} m [s]": t[before] + share * (t[before + 1] - t[before])}


def table(change):
    """{quantity: its relative changes from each size of cells to the next}"""
    answers = [observed(change, halvings) for halvings in HALVINGS[change]]
    result = {}
    for name in answers[0]:
        values = [answer[name] for answer in answers]
        result[name] = [fine / coarse - 1 for coarse, fine in zip(values, values[1:])]
        print(f"{change:16s} {name:26s} {' '.join(f'{value:9.5g}' for value in values)}  changes "
              f"{' '.join(f'{each:+.1%}' for each in result[name])}", flush=True)
    return result


def warned():
    """Of the three together alone, by --validate; of a contrast above 1 %."""
    def warns(settings):
        result = asperity_run.run(DECK, *asperity_run.settings(settings), "--validate")
        assert result.returncode == 0, result.stderr
        return TOPIC in result.stdout

    modulus = "Bulk/Shear Modulus"
    cases = [({CHANGE: "Coupled"}, True), ({CHANGE: "Lagged"}, True), ({CHANGE: "Fixed"}, False),
             ({}, False), ({CHANGE: "Coupled", modulus: 2.4e10}, False),
             ({CHANGE: "Coupled", modulus: "y > 0 ? 2.4e10 : 2.412e10"}, False),
             ({CHANGE: "Coupled", modulus: "y > 0 ? 2.44e10 : 2.4e10"}, True),
             # rock that varies in space differs by 2 % between the cells on the two sides
             ({CHANGE: "Coupled", modulus: "3e10 + 1e7 * y"}, False),
             ({CHANGE: "Coupled", modulus: 2.4e10, "Bulk/Density": "y > 0 ? 2600 : 2700"}, True)]
    quasi_dynamic = {CHANGE: "Coupled", "Bulk/Dynamics": "Quasi-dynamic",
                     "Time Stepping/Scheme": "Generalised Alpha",
                     **{f"Boundary Conditions/{side}/Type": "Fixed"
                        for side in ("Left", "Right", "Bottom", "Top")}}
    passed = []
    for settings, expected in [*cases, (quasi_dynamic, False)]:
        fine = warns(settings) == expected
        print(f"warning {expected}: {settings}{'' if fine else ' NO'}", flush=True)
        passed.append(fine)
    return passed


def main():
    passed = warned()
    regularised, at_once = table("Prakash-Clifton"), table("Coupled")
    passed += [abs(change) < 0.03 for change, in regularised.values()]
    first, last = at_once[PEAK]
    passed.append(last > 0.1 and last > first > 0)
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
