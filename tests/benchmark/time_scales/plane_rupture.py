"""TPV101 and TPV103 in plane strain: when the rupture arrives, and the slip after 6 s."""

import sys

import asperity_run
import numpy
from sequence import check

ARRIVALS = {  # m: s
    "tpv101_2d": {0: 0.569, 2500: 1.657, 5000: 2.615, 7500: 3.474, 9000: 3.978, 12000: 4.974},
    "tpv103_2d": {0: 0.571, 2500: 1.355, 5000: 1.941, 7500: 2.937, 9000: 3.500, 12000: 4.531}}
SLIP = {"tpv101_2d": {0: 10.16, 5000: 7.25, 9000: 5.62},  # m: m, at 6 s
        "tpv103_2d": {0: 17.36, 5000: 12.31, 9000: 9.75}}


def main(deck, cell_size_factor, of_arrivals, of_slip):
    """A cell size factor of 1 is 100 m on the fault; the last two are tolerances."""
    folder = asperity_run.run_to_end(
        "out", asperity_run.SOURCE / "xml" / f"{deck}.xml", "--set",
        f"Mesh/Rectangle/Cell Size Factor={cell_size_factor}", timeout=7000)
    rupture = asperity_run.series(folder / "rupture.h5")
    x = rupture["geometry/coordinates"][:, 0]
    fine = True
    for place, expected in ARRIVALS[deck].items():
        found = numpy.interp(place, x, rupture["first_rupture_time"])
        fine = check(f"arrival at {place / 1e3} km [s]", found, expected,
                     float(of_arrivals)) and fine
    receivers = asperity_run.series(folder / "receivers.h5")
    x, slip = receivers["on_fault/coordinates"][:, 0], receivers["on_fault/fields/slip"][-1]
    for place, expected in SLIP[deck].items():
        found = abs(slip[numpy.flatnonzero(x == place)[0]])
        fine = check(f"slip at {place / 1e3} km [m]", found, expected, float(of_slip)) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
