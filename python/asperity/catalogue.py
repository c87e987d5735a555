"""The events of a run: the origin of their positions, and which of them count."""

from typing import Optional

import numpy as np

from .errors import InputError
from .h5file import H5File
from .selection import Selection
from .tables import Table

LARGEST = {"width", "length", "area", "peak_slip", "peak_slip_rate"}
SUMS = {"moment", "moment_per_length"}
LAST = {"end"}
LEVEL = 1e-6  # of the length of a fault: ends that differ less in height are equally high
NUCLEATION, FROM_UPPER_END = "nucleation", "nucleation_from_upper_end"


def begins_at_upper_end(nodes: np.ndarray, positions: np.ndarray) -> bool:
    """Whether positions along a fault, of nodes (n, 2), count from its upper end. Earlier versions
    count from the end with smaller x, then y: from below on an upright fault."""
    return bool(nodes[-1, 1] - nodes[0, 1] <= LEVEL * positions[-1])


def with_origin(table: Table, geometry: Optional[H5File]) -> Table:
    """The events with `nucleation` [m] from the upper end of the fault; of an older run by the
    `geometry` of its fault and, without one, as `nucleation_from_smaller_coordinates`."""
    if FROM_UPPER_END in table:
        return _renamed(table, FROM_UPPER_END, NUCLEATION)
    if NUCLEATION not in table:
        return table
    if geometry is None or not geometry.has("geometry/positions"):
        return _renamed(table, NUCLEATION, "nucleation_from_smaller_coordinates")
    positions = geometry.array("geometry/positions")
    if begins_at_upper_end(geometry.array("geometry/coordinates"), positions):
        return table
    return Table(table.path, {**table.columns, NUCLEATION: positions[-1] - table[NUCLEATION]},
                 table.units)


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
