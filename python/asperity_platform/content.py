"""What a platform's files are made of: the text of each, from the results of a run."""

import math
from typing import Dict, Iterable, Iterator, List, Tuple

import numpy as np

from asperity.errors import InputError
from asperity.h5file import H5File
from asperity.run import Run

from .columns import Column
from .header import (NUMBER, TIME, Facts, count_line, exact, header, names_of, remarks_of, rows,
                     short, size_line)
from .model import Model
from .problem import ON_FAULT, PROFILES, RUPTURE, TOTALS, FileKind, Platform

MOST_ROWS = 1e7  # more than a day of SCEC's time step; the rows of cycles would fill any disk
WHERE = {ON_FAULT: "on fault"}
File = Tuple[str, Iterable[str]]  # its name and its text, in pieces


class Content:
    """The files of a kind, as far as the run has come. `top` [m] is the distance down dip of the
    fault's upper end, `time_step` [s] the step of rows that are equally far from each other."""

    def __init__(self, run: Run, platform: Platform, model: Model, facts: Facts, top: float,
                 time_step: float):
        self.run, self.platform, self.model, self.facts = run, platform, model, facts
        self.top, self.time_step = top, time_step

    def files(self, kind: FileKind) -> Iterator[File]:
        """InputError if the run lacks what the files are made of."""
        make = {TOTALS: self._totals, PROFILES: self._profiles, RUPTURE: self._rupture}
        return make.get(kind.source, self._stations)(kind)

    def _stations(self, kind: FileKind) -> Iterator[File]:
        receivers = self.run.receivers
        names = receivers.strings(f"{kind.source}/names")
        columns = kind.columns[1:]
        fields = {"time": receivers.time}
        for field in dict.fromkeys(column.field for column in columns):
            if not receivers.has(f"{kind.source}/fields/{field}"):
                raise InputError(self._lacks(kind, field))
            fields[field] = receivers.values(kind.source, field)
        directions = self.platform.directions(self.model, kind.source)
        values = [column.made_of(fields, directions) for column in columns]
        time, steps = receivers.time, self._step_lines(receivers.time)
        if self.platform.has_equal_steps:
            time, values = self._at_equal_steps(time, values)
            steps = [size_line("time_step", self.time_step), count_line(time.size)]
        for i, name in enumerate(names):
            text = self._header([f"location={WHERE.get(kind.source, 'off fault')}, "
                                 f"{self._place(kind.source, i)}", *steps,
                                 *remarks_of(kind.columns)], names_of(kind.columns))
            table = np.column_stack((time, *(each[:, i] for each in values)))
            yield kind.prefix + name, self._text(text, table)

    def _lacks(self, kind: FileKind, field: str) -> str:
        if kind.source == ON_FAULT and not self.run.receivers.has("on_fault/fields/normal_stress") \
                and not self.model.state:
            return (f"{self.run.directory}: {self.platform.name} needs a fault with friction, "
                    "whose stresses and state its files of receivers on the fault have.")
        where = "Fault Fields" if kind.source == ON_FAULT else "Body Fields"
        return (f"{self.run.receivers.path} has no field '{field}' of receivers "
                f"{kind.source.replace('_', ' ')}, which {self.platform.name} takes. It belongs to "
                f"'Output / Receivers / {where}' of the deck, and is among those that are written "
                "if the deck has no such entry, provided that the laws and processes on the fault "
                "have it.")

    def _place(self, group: str, receiver: int) -> str:
        """'(0, -7500) m, 7500 m from the upper end'."""
        receivers = self.run.receivers
        point = receivers.array(f"{group}/coordinates")[receiver]
        text = f"({', '.join(map(exact, point))}) m"
        if not receivers.has(f"{group}/positions"):
            return text
        end = "end of smaller x" if self.model.is_level else "upper end"
        parts = self._parts()
        return (f"{text}, {short(receivers.array(f'{group}/positions')[receiver])} m from the "
                f"{end}" + (f" ({parts})" if parts else ""))

    def _parts(self) -> str:
        """'main: 0 to 20000 m, splay: 20000 to 24000 m' of a fault of several, or ''."""
        for name in ("fault.h5", "rupture.h5"):
            if self.run.has(name):
                file = H5File(self.run.directory / name)
                if file.has("geometry/part_names"):
                    return ", ".join(f"{part}: {short(begin)} to {short(end)} m"
                                     for part, (begin, end) in zip(
                                         file.strings("geometry/part_names"),
                                         file.array("geometry/part_ends")))
        return ""

    def _at_equal_steps(self, time: np.ndarray,
                        values: List[np.ndarray]) -> Tuple[np.ndarray, List[np.ndarray]]:
        """Linear between the rows."""
        count = math.floor(time[-1] / self.time_step)
        if count > MOST_ROWS:
            raise InputError(
                f"--time-step {short(self.time_step)} s gives each receiver {short(count)} rows "
                f"until {short(time[-1])} s. These files are for single ruptures, with at most "
                f"{MOST_ROWS:g} rows. Choose a larger one, or the form of another platform.")
        equal = np.arange(count + 2) * self.time_step
        equal = equal[equal <= time[-1]]
        after = np.searchsorted(time, equal)
        before = np.maximum(after - 1, 0)
        length = time[after] - time[before]
        part = np.divide(equal - time[before], length, out=np.zeros(equal.size), where=length > 0.0)
        return equal, [each[before] + part[:, None] * (each[after] - each[before])
                       for each in values]

    def _totals(self, kind: FileKind) -> Iterator[File]:
        totals = self.run.totals
        fields = {column.field: totals[column.field] for column in kind.columns}
        time = fields["time"]
        text = self._header([*self._step_lines(time), *remarks_of(kind.columns)],
                            names_of(kind.columns))
        values = [column.made_of(fields, {}) for column in kind.columns]
        yield kind.prefix, self._text(text, np.column_stack(values))

    def _profiles(self, kind: FileKind) -> Iterator[File]:
        fault = self.run.fault
        for name in ("peak_slip_rate", "fields/slip"):
            if not fault.has(name):
                raise InputError(f"{fault.path} has no '{name}', of which {kind.prefix} is made."
                                 + (" It belongs to 'Output / Fault History / Fields' of the deck."
                                    if "/" in name else ""))
        places, parts = fault.array("geometry/positions"), self._parts()
        remarks = [f"Row #1 = Distance along the fault from its upper end (m) with two zeros first"
                   f"{'; ' + parts if parts else ''}", *remarks_of(kind.columns[:2]),
                   f"Column #3-{places.size + 2} = {kind.columns[2].description()}"]
        first = "".join(rows(np.concatenate(([0.0, 0.0], places))[None], TIME, NUMBER))
        text = self._header([*self._step_lines(fault.time), *remarks],
                            "z\n" + names_of(kind.columns).replace(" ", "\n")) + first
        yield kind.prefix, self._profile_text(text, kind.columns)

    def _profile_text(self, text: str, columns: Tuple[Column, ...]) -> Iterator[str]:
        fault = self.run.fault
        yield text
        for part, slip in fault.blocks("slip", slice(0, fault.time.size), np.ones(1)):
            peak = columns[1].made_of({"peak_slip_rate": fault.array("peak_slip_rate", part)}, {})
            yield from rows(np.column_stack((fault.time[part], peak,
                                             self.model.thrust_sign * slip)), TIME, NUMBER)

    def _rupture(self, kind: FileKind) -> Iterator[File]:
        ruptures, never = self.run.ruptures, self._never()
        places, origin = self._places(ruptures)
        arrival = ruptures.array("first_rupture_time")
        threshold = ruptures.array("threshold")[0]
        remarks = remarks_of(kind.columns, origin=origin, top=short(self.top, 8),
                             threshold=short(threshold, 8), never=TIME % never)
        fields = {**places, "arrival": np.where(np.isnan(arrival), never, arrival)}
        table = np.column_stack([column.made_of(fields, {}) for column in kind.columns])
        yield kind.prefix, self._text(self._header(remarks, names_of(kind.columns)), table,
                                      NUMBER, NUMBER, TIME)

    def _never(self) -> float:
        """1e9 s is what the platforms agreed on. In longer runs it is a time like others."""
        time, end = 1e9, self.run.parameters.number("Time Stepping/Final Time") or 0.0
        while time <= end:
            time *= 10.0
        return time

    def _places(self, ruptures: H5File) -> Tuple[Dict[str, np.ndarray], str]:
        """Along strike and down dip, of each node; and what counts as 0 along strike."""
        if self.model.in_space:
            nodes = ruptures.array("geometry/coordinates")
            strike, dip = ((d[0] * nodes[:, 0] + d[1] * nodes[:, 1]) + d[2] * nodes[:, 2]
                           for d in map(self.model.along, ("strike", "dip")))
            return {"along_strike": strike,
                    "down_dip": self.top + (dip - self.model.fault["top"])}, "the mesh's origin"
        along = ruptures.array("geometry/positions")
        strike, dip = (along, 0.0 * along) if self.model.is_level else (0.0 * along, along)
        return ({"along_strike": strike, "down_dip": self.top + dip},
                "the fault's end of smaller x")

    def _step_lines(self, time: np.ndarray) -> List[str]:
        """Of the steps up to the last row; nothing if the run has no table of them."""
        if not self.run.has("steps.csv"):
            return []
        steps = self.run.steps
        sizes = steps["step_size"][steps["time"] <= time[-1]]
        shortest, longest = (sizes.min(), sizes.max()) if sizes.size else (0.0, 0.0)
        return [size_line("minimum_time_step", shortest), size_line("maximum_time_step", longest),
                count_line(sizes.size)]

    def _header(self, remarks: List[str], fields: str) -> str:
        return header(self.facts, remarks, fields)

    @staticmethod
    def _text(text: str, table: np.ndarray, *formats: str) -> Iterator[str]:
        yield text
        yield from rows(table, *(formats or (TIME, NUMBER)))
