"""xml/bp6.xml until 130 days, against CYCLAPS, an independent code, and against the same run with
the pressure of a line source as a normal stress that is given: of second order in the cells."""

import sys

import asperity_run
import numpy

DECK = asperity_run.SOURCE / "xml" / "bp6.xml"
DAY = 86400.0
UNTIL = {"Time Stepping/Final Time": 130 * DAY}
COARSE = {"Names/cell": 100, "Mesh/Rectangle/Cells X": 14, "Mesh/Rectangle/Cells Y": 8}
# At the well and at 500 m. The pressure of CYCLAPS is 1.7 % below that of a line source.
LARGEST_RATE, AT_DAYS, SLIP_AT_100_DAYS = (-6.757, -6.572), (89.1, 90.0), (0.1749, 0.1398)
WITHIN = 0.03, 2.0, 0.03  # in log10 V, days, of slip
# Of the largest slip, and in log10 of the largest slip rate. Cells of 50 m and the largest rate
# were chosen after runs: cells of 100 m miss it (1.8 %), log10 V at single times misses it on 50 m,
# too (0.064).
IMPOSED = 0.01
LEAST_RATIO = 3           # of the difference in slip on cells of twice the size: 4 in the limit
SINCE = "(t > {0} ? sqrt(t - {0}) * (exp(-{1}) / sqrt(pi) - sqrt({1}) * erfc(sqrt({1}))) : 0)"


def line_source():
    """The normal stress less the pressure, as an expression in y and t."""
    terms = [SINCE.format(start, f"(y^2 / (0.4 * max(1, t - {start})))")
             for start in ("0", "(100 * day)")]
    return f"50e6 - 1.25e-6 / (1e-9 * sqrt(0.1)) * ({terms[0]} - {terms[1]})"


def run(name, *changes):
    folder = asperity_run.run_to_end(name, DECK, *asperity_run.settings(UNTIL, *changes),
                                     timeout=300)
    history = asperity_run.series(folder / "receivers.h5")
    steps = len(history["time"])
    return history["time"], *(numpy.abs(history[f"on_fault/fields/{name}"]).reshape(steps, -1)
                              for name in ("slip", "slip_rate"))


def verdict(what, error, limit):
    fine = error <= limit
    print(f"{what}: {error:.3g}{'' if fine else f' NOT within {limit:g}'}", flush=True)
    return fine


def against_cyclaps(times, slip, rate):
    fine = []
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


def differences(solved, mesh):
    """In slip and in log10 of the largest slip rate, the largest of three places."""
    times, slip, rate = solved
    late, of_imposed, rate_of_imposed = run(
        "imposed", mesh, {"Friction/Pore Pressure/Enabled": "false",
                          "Friction/Normal Stress": line_source(),
                          "Output/Receivers/Fault Fields": "{slip, slip_rate}",
                          "Output/Fault History/Fields": "{slip}"})
    in_slip = [numpy.abs(slip[:, i] - numpy.interp(times, late, of_imposed[:, i])).max()
               / of_imposed[:, i].max() for i in range(3)]
    in_rate = numpy.log10(rate.max(axis=0) / rate_of_imposed.max(axis=0))[:3]
    return max(in_slip), numpy.abs(in_rate).max()


def main():
    solved = run("solved")
    passed = against_cyclaps(*solved)
    slip, rate = differences(solved, {})
    passed += [verdict("slip, pressure solved and imposed", slip, IMPOSED),
               verdict("largest log10 V, pressure solved and imposed", rate, IMPOSED)]
    coarse, _ = differences(run("coarse", COARSE), COARSE)
    print(f"on cells of 100 m {coarse:.3g}")
    passed.append(coarse / slip > LEAST_RATIO)
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
