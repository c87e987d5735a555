"""Tables for docs: columns of numbers as Markdown."""

from dataclasses import dataclass
from typing import List, Sequence

import numpy as np

from . import units


@dataclass(frozen=True)
class Column:
    """`values` in SI, shown in `unit` with `digits` significant digits; 0: integers.

    Words stand as they are, nan is left blank.
    """

    name: str
    values: Sequence
    unit: units.Unit = units.Unit("", 1.0)
    digits: int = 4

    @property
    def header(self) -> str:
        return f"{self.name} [{self.unit.name}]" if self.unit.name else self.name

    def cells(self) -> List[str]:
        return [value if isinstance(value, str) else self._cell(value / self.unit.factor)
                for value in self.values]

    def _cell(self, value: float) -> str:
        if not np.isfinite(value):
            return ""
        if self.digits == 0:
            return f"{value:,.0f}"
        if value != 0.0 and not 1e-3 <= abs(value) < 1e6:
            return f"{value:.{self.digits - 1}e}"
        return units.rounded(value, self.digits)


def table(columns: List[Column]) -> str:
    """One line for the header, one below it, and one for each row."""
    rows = [[column.header for column in columns], ["---:"] * len(columns)]
    rows += [list(row) for row in zip(*(column.cells() for column in columns))]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)
