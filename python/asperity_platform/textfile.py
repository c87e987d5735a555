"""A platform's file in its parts: header, names of the fields, rows."""

import re
from dataclasses import dataclass, field
from pathlib import Path
from typing import Dict, List, Tuple

COLUMN = re.compile(r"Columns? #(\d+)(?:-(\d+))? *= *(.*)")
NOT_FINITE = re.compile(r"[+-]?(nan|inf|infinity)", re.IGNORECASE)
KEY = re.compile(r"([A-Za-z][A-Za-z _]*?) *= *(.*)")

Line = Tuple[int, str]  # its number, from 1, and its text


@dataclass
class TextFile:
    """`columns` are the numbers in 'Column #3 = ...' with the line and the words after it; a
    range, as in 'Column #3-80', counts by its first number."""

    keys: Dict[str, Line] = field(default_factory=dict)
    columns: Dict[int, Line] = field(default_factory=dict)
    fields: List[Line] = field(default_factory=list)
    rows: List[Line] = field(default_factory=list)

    @property
    def names(self) -> List[str]:
        return " ".join(text for _, text in self.fields).split()

    @property
    def first_line(self) -> int:
        """Where the names of the fields are, or should be."""
        return self.fields[0][0] if self.fields else (self.rows[0][0] if self.rows else 1)


def first_odd_byte(data: bytes) -> int:
    """The number of the line with a byte beyond ASCII, 0 if there is none."""
    odd = re.search(rb"[^\t\n\r -~]", data)
    return data.count(b"\n", 0, odd.start()) + 1 if odd else 0


def parse(text: str) -> TextFile:
    file = TextFile()
    for number, line in enumerate(text.splitlines(), start=1):
        words = line.strip()
        if words.startswith("#"):
            _add_remark(file, number, words.lstrip("# "))
        elif words and not file.rows and _is_name(words.split()[0]):
            file.fields.append((number, words))
        elif words:
            file.rows.append((number, words))
    return file


def _is_name(word: str) -> bool:
    return word[0].isalpha() and not NOT_FINITE.fullmatch(word)


def _add_remark(file: TextFile, number: int, words: str) -> None:
    column, key = COLUMN.match(words), KEY.match(words)
    if column:
        file.columns[int(column[1])] = (number, column[3])
    elif key:
        file.keys.setdefault(re.sub(r"[ _]+", "_", key[1]).lower(), (number, key[2].strip()))


def problem_in(path: Path, most: int = 4096) -> str:
    """What the header calls the problem, '' if it does not say; reads the beginning only."""
    with path.open("rb") as file:
        text = file.read(most).decode("ascii", "replace")
    return parse(text).keys.get("problem", (0, ""))[1]
