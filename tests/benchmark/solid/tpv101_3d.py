"""TPV101 in three dimensions on cells of 400 m: when the rupture arrives along strike."""

import sys

import asperity_run
import numpy
from sequence import check

ARRIVALS = {4500: (2.77, 0.08), 9000: (4.80, 0.10)}  # m along strike: s, tolerance
DEPTH = 7500  # m, of the hypocentre


def main():
    folder = asperity_run.run_to_end("out", asperity_run.SOURCE / "xml" / "tpv101_3d.xml",
                                     timeout=7000)
    rupture = asperity_run.series(folder / "rupture.h5")
    places = rupture["geometry/coordinates"]
    line = numpy.flatnonzero(numpy.abs(places[:, 1] + DEPTH) < 1)
    line = line[numpy.argsort(places[line, 0])]
    fine = True
    for place, (expected, tolerance) in ARRIVALS.items():
        found = numpy.interp(place, places[line, 0], rupture["first_rupture_time"][line])
        fine = check(f"arrival at {place / 1e3} km [s]", found, expected, tolerance) and fine
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
