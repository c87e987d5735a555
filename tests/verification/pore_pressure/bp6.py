"""xml/bp6.xml on cells of 100 m until 130 days, against CYCLAPS, an independent code, and against
the same run with the pressure of a line source in a normal stress that is given."""

import pathlib
import sys

import asperity_run
import numpy

DECK = asperity_run.SOURCE / "xml" / "bp6.xml"
DAY = 86400.0
SETTINGS = {"Names/cell": 100, "Mesh/Rectangle/Cells X": 14, "Mesh/Rectangle/Cells Y": 8,
            "Time Stepping/Final Time": 130 * DAY}
# At the well and at 500 m. The pressure of CYCLAPS is 1.7 % below that of a line source.
LARGEST_RATE, AT_DAYS, SLIP_AT_100_DAYS = (-6.757, -6.572), (89.1, 90.0), (0.1749, 0.1398)
WITHIN = 0.03, 2.0, 0.03  # in log10 V, days, of slip
IMPOSED = 0.01            # of the largest slip, and in log10 V after the first day
SINCE = "(t > {0} ? sqrt(t - {0}) * (exp(-{1}) / sqrt(pi) - sqrt({1}) * erfc(sqrt({1}))) : 0)"


def line_source():
    """The normal stress less the pressure, as an expression in y and t."""
    terms = [SINCE.format(start, f"(y^2 / (0.4 * max(1, t - {start})))")
             for start in ("0", "(100 * day)")]
    return f"50e6 - 1.25e-6 / (1e-9 * sqrt(0.1)) * ({terms[0]} - {terms[1]})"


def run(name, changes=None):
    folder = asperity_run.run_to_end(name, DECK, *asperity_run.settings(SETTINGS, changes or {}),
                                     timeout=300)
    history = asperity_run.series(pathlib.Path(folder) / "receivers.h5")
    return history["time"], {key.split("/")[-1]: values for key, values in history.items()
                             if key.startswith("on_fault/fields/")}


def verdict(what, error, limit):
    fine = error <= limit
    print(f"{what}: {error:.3g}{'' if fine else f' NOT within {limit:g}'}", flush=True)
    return fine


def against_cyclaps(times, fields):
    fine = []
    slip, rate = (numpy.abs(fields[name]).reshape(len(times), -1) for name in ("slip", "slip_rate"))
    for i, place in enumerate(("at the well", "at 500 m")):
        peak = rate[:, i].argmax()
        at_100 = numpy.interp(100 * DAY, times, slip[:, i])
        print(f"{place}: log10 V {numpy.log10(rate[peak, i]):.3f} after {times[peak] / DAY:.1f} d, "
              f"{at_100:.4f} m after 100 d")
        fine += [verdict("largest rate", abs(numpy.log10(rate[peak, i]) - LARGEST_RATE[i]),
                         WITHIN[0]),
                 verdict("its time", abs(times[peak] / DAY - AT_DAYS[i]), WITHIN[1]),
                 verdict("slip", abs(at_100 / SLIP_AT_100_DAYS[i] - 1), WITHIN[2])]
    return fine


def main():
    times, solved = run("solved")
    passed = against_cyclaps(times, solved)
    late, imposed = run("imposed", {"Friction/Pore Pressure/Enabled": "false",
                                    "Friction/Normal Stress": line_source(),
                                    "Output/Receivers/Fault Fields": "{slip, slip_rate}",
                                    "Output/Fault History/Fields": "{slip}"})
    for i, place in enumerate(("at the well", "at 500 m", "at 1000 m")):
        slip, rate = ([values[name].reshape(len(values[name]), -1)[:, i]
                       for values in (solved, imposed)] for name in ("slip", "slip_rate"))
        difference = slip[0] - numpy.interp(times, late, slip[1])
        passed.append(verdict(f"slip {place}, solved and imposed",
                              numpy.abs(difference).max() / numpy.abs(slip[1]).max(), IMPOSED))
        of_imposed = numpy.interp(times, late, numpy.log10(rate[1]))
        passed.append(verdict(f"log10 V {place}, solved and imposed",
                              numpy.abs(numpy.log10(rate[0]) - of_imposed)[times > DAY].max(),
                              IMPOSED))
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
