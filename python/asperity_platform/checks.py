"""What a platform's checker asks of one file, from its size to its rows."""

import re
from pathlib import Path
from typing import List, NamedTuple

from . import values
from .problem import PROFILES, FileKind, plain
from .textfile import NOT_FINITE, TextFile, first_odd_byte, parse

MOST_BYTES = 10 * 2**20  # of a file; the platforms' guide says about 10 MB
DECIMAL = r"[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:[Ee][+-]?\d+)?"
ROW = re.compile(rf"{DECIMAL}(?:\s+{DECIMAL})*")


class Refusal(NamedTuple):
    """What is wrong, and where; `line` 0: with the file as a whole."""

    file: str
    line: int
    text: str

    def __str__(self) -> str:
        where = f"{self.file}, line {self.line}" if self.line else self.file
        return f"{where}: {self.text}."


def check_file(path: Path, kind: FileKind, name: str, has_equal_steps: bool) -> List[Refusal]:
    """The faults of the first kind that is found; `name` is that of the problem."""
    size = path.stat().st_size
    if size == 0:
        return [Refusal(path.name, 0, "is empty")]
    if size > MOST_BYTES:
        return [Refusal(path.name, 0, f"has {size / 2**20:.1f} MB, the platform takes "
                                      f"{MOST_BYTES / 2**20:.0f} MB; write fewer rows")]
    data = path.read_bytes()
    odd = first_odd_byte(data)
    if odd:
        return [Refusal(path.name, odd, "has a character that is not ASCII")]
    file = parse(data.decode("ascii"))
    for stage in (_header, _fields, _units, _rows):
        found = [Refusal(path.name, *fault) for fault in stage(file, kind, name)]
        if found:
            return found
    return [Refusal(path.name, *fault) for fault in values.faults(file, kind,
                                                                    has_equal_steps)]


def _header(file: TextFile, kind: FileKind, name: str):
    for keys in kind.keys:
        known = [file.keys[key] for key in keys.split("|") if key in file.keys]
        if not known:
            yield 0, f"the header has no line `# {keys.split('|')[0]}=`"
        elif not known[0][1]:
            yield known[0][0], f"nothing stands after `{keys.split('|')[0]}=`"
    line, problem = file.keys.get("problem", (0, name))
    if plain(problem) != plain(name):
        yield line, f"is of the problem {problem}, not of {name}"


def _fields(file: TextFile, kind: FileKind, _):
    expected = [column.name for column in kind.columns]
    names = file.names[1:] if kind.source == PROFILES else file.names  # the first is that of places
    if not file.fields:
        yield file.first_line, f"no line with the names of the fields, `{' '.join(expected)}`"
    elif names != expected:
        yield file.first_line, _difference(names, expected)


def _difference(names: List[str], expected: List[str]) -> str:
    missing = [name for name in expected if name not in names]
    extra = [name for name in names if name not in expected]
    if missing:
        return (f"column {expected.index(missing[0]) + 1} ({missing[0]}) is missing; the fields "
                f"are `{' '.join(expected)}`")
    if extra or len(names) != len(expected):
        odd = extra[0] if extra else next(name for name in names if names.count(name) > 1)
        return f"column {names.index(odd) + 1} ({odd}) is none of `{' '.join(expected)}`"
    return f"the order of the columns is not `{' '.join(expected)}`"


def _units(file: TextFile, kind: FileKind, _):
    for number, column in enumerate(kind.columns, start=1):
        line, words = file.columns.get(number, (0, ""))
        if not line:
            yield 0, f"the header has no line `# Column #{number} =` for {column.name}"
            continue
        unit = re.search(r"\(([^()]*)\)", words)
        if not unit:
            yield line, f"names no unit of column {number} ({column.name}): ({column.units[0]})"
        elif not column.has_unit(unit[1]):
            yield line, (f"column {number} ({column.name}) is in {unit[1]}, the platform takes "
                         f"{column.units[0]}")
    extra = [number for number in file.columns if number > len(kind.columns)]
    if extra:
        yield file.columns[extra[0]][0], f"describes a column {extra[0]} that is not there"


def _rows(file: TextFile, kind: FileKind, _):
    if len(file.rows) < (2 if kind.source == PROFILES else 1):
        yield 0, "has no rows of numbers"
        return
    width = len(file.rows[0][1].split()) if kind.source == PROFILES else len(kind.columns)
    for line, text in file.rows:
        words = text.split()
        if not ROW.fullmatch(text):
            odd = next(i for i, word in enumerate(words) if not re.fullmatch(DECIMAL, word))
            what = ("is not finite" if NOT_FINITE.fullmatch(words[odd])
                    else "is no decimal number such as 1.5E+09")
            name = kind.columns[min(odd, len(kind.columns) - 1)].name
            yield line, f"column {odd + 1} ({name}): `{words[odd][:30]}` {what}"
            return
        if len(words) != width:
            yield line, f"has {len(words)} numbers, not {width}"
            return
