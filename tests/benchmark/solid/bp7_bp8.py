"""SEAS BP7-QD-A or BP8-QD-GS against the converged answer of an independent program of boundary
integrals (independent_cycles/whole_space.py with cells of 10 m): slip of stations at some times.

For BP8 the limit was 3 % before a run, which the corner at (200, 200) misses; there is no time at
which the front passes a station, as at (0, 200) after 100 hours, where the deck is 9 % behind."""

import pathlib
import sys

import asperity_run
import numpy
from sequence import check

sys.path.append(str(pathlib.Path(__file__).parent.with_name("independent_cycles")))
from whole_space import ANSWERS  # noqa: E402


def main(deck, limit, *changes):
    folder = asperity_run.run_to_end(
        "out", asperity_run.SOURCE / "xml" / f"{deck}.xml", *asperity_run.settings(*changes),
        timeout=14000)
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    fine = []
    for (strike, dip), answers in ANSWERS[deck].items():
        number = names.index(f"strk{strike:+04d}dp{dip:+04d}")
        slip = numpy.abs(history["on_fault/fields/slip"][:, number, 0])
        fine += [check(f"slip at ({strike}, {dip}) after {time:g} s [m]",
                       numpy.interp(time, history["time"], slip), expected, float(limit))
                 for time, expected in answers.items()]
    return fine.count(False)


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
