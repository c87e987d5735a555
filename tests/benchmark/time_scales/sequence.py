"""Events of a run, and how far numbers lie from what was published."""

import asperity_run
import numpy

YEAR = 3.15576e7  # s


def check(what, found, expected, tolerance):
    """True if found / expected - 1 is within the tolerance; one line on stdout."""
    error = found / expected - 1
    fine = abs(error) <= tolerance
    print(f"{what}: {found:.5g}, expected {expected:.5g}: {error:+.2%} of {tolerance:.1%}"
          f"{'' if fine else ', MISSED'}")
    return fine


def catalogue(folder):
    """Rows of events.csv."""
    return asperity_run.table(folder / "events.csv")


def slip_in_events(folder, receiver):
    """Slip of a receiver on the fault in each event [m], from its onset to its end."""
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    slip = history["on_fault/fields/slip"][:, names.index(receiver)]
    return [float(numpy.diff(numpy.interp((row["onset"], row["end"]), history["time"], slip))[0])
            for row in catalogue(folder)]
