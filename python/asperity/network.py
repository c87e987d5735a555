"""Which of several faults an event breaks, from the tables events_<fault>.csv of `Each Fault`."""

from typing import List, Tuple

import numpy as np

from .errors import InputError, NothingToShow
from .run import Run

SMALLEST_SHARE = 0.01  # of the moment of an event: a fault with less of it has not broken


def moments(run: Run) -> Tuple[List[str], np.ndarray]:
    """The names of the faults, and (events, faults) the moment of each event on each: per length of
    the fault [N] in two dimensions, [N m] in space; 0 where the event did not come. InputError if
    the run has no such tables."""
    tables = run.events_of_faults
    if not tables:
        raise InputError(f"{run.directory} has no tables of single faults. Run the deck with "
                         "Output / Event Catalogue / Each Fault = true.")
    events = run.events
    numbers, ends = events["number"], events["onset"] + events["duration"]
    result = np.zeros((len(events), len(tables)))
    for column, table in enumerate(tables.values()):
        # A merged event has the number of its first part, and events that do not count have none.
        row = np.searchsorted(numbers, table["number"], side="right") - 1
        counts = row >= 0
        counts[counts] = table["onset"][counts] <= ends[row[counts]]
        moment = table["moment" if "moment" in table else "moment_per_length"]
        np.add.at(result[:, column], row[counts], moment[counts])
    return list(tables), result


def broken(run: Run, smallest_share: float = SMALLEST_SHARE) -> Tuple[List[str], np.ndarray]:
    """The names of the faults, and (events, faults) whether an event breaks each: whether this
    share of its moment or more is there."""
    names, moment = moments(run)
    total = moment.sum(axis=1, keepdims=True)
    return names, (moment > 0.0) & (moment >= smallest_share * total)


def share_of_several(run: Run, smallest_share: float = SMALLEST_SHARE) -> float:
    """The share of the events that break more than one fault; NothingToShow without an event."""
    _, is_broken = broken(run, smallest_share)
    if not len(is_broken):
        raise NothingToShow("the run has no event")
    return float((is_broken.sum(axis=1) > 1).mean())
