"""The header of a platform's file, and its numbers as text."""

from dataclasses import dataclass
from typing import Iterator, List, Sequence

import numpy as np

from .columns import Column

TIME, NUMBER = "%21.14E", "%14.6E"  # times with 15 digits, others with 7


@dataclass(frozen=True)
class Facts:
    """What the header says of the run; `element_size` [m] is that on the fault."""

    problem: str
    author: str
    date: str  # "2024/05/31"
    code_version: str
    element_size: float


def short(value: float, digits: int = 6) -> str:
    return f"{value:.{digits}g}"


def exact(value: float) -> str:
    """The shortest text that reads back as the number, as the deck and messages have it."""
    return min(np.format_float_positional(value, trim="-"),
               np.format_float_scientific(value, trim="-", exp_digits=2), key=len)


def header(facts: Facts, remarks: Sequence[str], fields: str) -> str:
    """`fields`: the line, or lines, after the remarks, which name the columns."""
    lines = ["This is the file header:", f"problem={facts.problem}", f"author={facts.author}",
             f"date={facts.date}", "code=Asperity", f"code_version={facts.code_version}",
             f"element_size={short(facts.element_size)} m", *remarks,
             "The line below lists the names of the data fields:"]
    return "".join(f"# {line}\n" for line in lines) + fields + "\n"


def remarks_of(columns: Sequence[Column], **more: str) -> List[str]:
    return [f"Column #{number} = {column.description(**more)}"
            for number, column in enumerate(columns, start=1)]


def names_of(columns: Sequence[Column]) -> str:
    return " ".join(column.name for column in columns)


def size_line(name: str, seconds: float) -> str:
    return f"{name}={seconds:.6E}"


def count_line(count: int) -> str:
    return f"num_time_steps={count:<12d}"


def rows(values: np.ndarray, *formats: str) -> Iterator[str]:
    """The lines of (rows, columns); the last of `formats` holds for all further columns."""
    formats = formats + (formats[-1],) * (values.shape[1] - len(formats))
    line = " ".join(formats) + "\n"
    for row in values:
        yield line % tuple(row)
