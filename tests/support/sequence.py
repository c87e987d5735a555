"""Events of a run, and how far numbers lie from what was published."""

import asperity_run
import numpy

YEAR = 3.15576e7  # s
DAY = 86400  # s


def check(what, found, expected, tolerance):
    """True if found / expected - 1 is within the tolerance; one line on stdout."""
    error = found / expected - 1
    fine = abs(error) <= tolerance
    print(f"{what}: {found:.5g}, expected {expected:.5g}: {error:+.2%} of {tolerance:.2%}"
          f"{'' if fine else ', MISSED'}")
    return fine


def agree(found, expected, tolerances):
    """True if there are as many rows, and all their numbers are within {name: tolerance}, which is
    in the order of a row; one line for each number on stdout."""
    fine = len(found) == len(expected)
    print(f"{len(found)} rows, expected {len(expected)}")
    for row, reference in zip(found, expected):
        for (name, tolerance), value, target in zip(tolerances.items(), row, reference):
            fine = check(f"  {name}", value, target, tolerance) and fine
    return fine


def catalogue(folder):
    """Rows of events.csv."""
    return asperity_run.table(folder / "events.csv")


def sequence(folder):
    """The rows of events.csv, those that begin within a day of the one before in one list: an event
    that pauses is one event."""
    events = []
    for row in catalogue(folder):
        if events and row["onset"] <= events[-1][-1]["onset"] + DAY:
            events[-1].append(row)
        else:
            events.append([row])
    return events


def slip_in_events(folder, receiver):
    """Slip of a receiver on the fault in each event [m], the sum over its rows of events.csv."""
    history = asperity_run.series(folder / "receivers.h5")
    names = [name.decode() for name in history["on_fault/names"]]
    slip = history["on_fault/fields/slip"][:, names.index(receiver)]

    def slip_in(row):
        ends = numpy.interp((row["onset"], row["end"]), history["time"], slip)
        return float(ends[1] - ends[0])

    return [sum(map(slip_in, rows)) for rows in sequence(folder)]
