"""The events of a run, and which of them count."""

import numpy as np

from .errors import InputError
from .selection import Selection
from .tables import Table

LARGEST = {"width", "length", "area", "peak_slip", "peak_slip_rate"}
SUMS = {"moment", "moment_per_length"}
LAST = {"end"}
LEVEL = 1e-6  # of the length of a fault: ends that differ less in height are equally high
NUCLEATION, FROM_UPPER_END = "nucleation", "nucleation_from_upper_end"


def with_nucleation(table: Table) -> Table:
    """The events with `nucleation` [m] from the upper end of the fault, if it is a curve."""
    return _renamed(table, FROM_UPPER_END, NUCLEATION) if FROM_UPPER_END in table else table


def _renamed(table: Table, name: str, new: str) -> Table:
    columns, units = ({new if each == name else each: value for each, value in part.items()}
                      for part in (table.columns, table.units))
    return Table(table.path, columns, units)


def select(table: Table, selection: Selection) -> Table:
    """The events that count. A merged event has the first onset, place and number, the last end,
    the sums of moments and energies, and the largest size, slip and rate of its parts, which are
    lower bounds for those of the whole."""
    if selection.merging_time > 0.0 and len(table):
        table = _merged(table, selection.merging_time)
    if selection.smallest_width > 0.0:
        table = table.select(table["width"] >= selection.smallest_width)
    if selection.smallest_magnitude is not None:
        if "magnitude" not in table:
            raise InputError(f"{table.path} has no magnitudes, since the run is two-dimensional. "
                             "Choose events by a smallest width.")
        table = table.select(table["magnitude"] >= selection.smallest_magnitude)
    if selection.start > 0.0:
        table = table.select(table["onset"] >= selection.start)
    return table


def magnitude(moment: np.ndarray) -> np.ndarray:
    """Mw of moments [N m]; -inf of 0."""
    with np.errstate(divide="ignore"):
        return (np.log10(moment) - 9.1) / 1.5


def _merged(table: Table, merging_time: float) -> Table:
    onset = table["onset"]
    end = table["end"] if "end" in table else onset + table["duration"]
    first = np.flatnonzero(np.concatenate(([True], onset[1:] - end[:-1] >= merging_time)))
    last = np.append(first[1:], len(table)) - 1
    columns = {}
    for name, values in table.columns.items():
        if name in LARGEST:
            columns[name] = np.maximum.reduceat(values, first)
        elif name in SUMS or table.units[name].startswith("J"):
            columns[name] = np.add.reduceat(values, first)
        elif name == "complete":
            columns[name] = np.minimum.reduceat(values, first)
        else:
            columns[name] = values[last if name in LAST else first]
    columns["duration"] = end[last] - onset[first]
    if "magnitude" in columns and "moment" in columns:
        columns["magnitude"] = magnitude(columns["moment"])
    return Table(table.path, columns, table.units)
