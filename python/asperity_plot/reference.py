"""Series in the text format of the SEAS benchmarks in two dimensions, of any code."""

from pathlib import Path
from typing import Iterable, List, Optional, Sequence

import numpy as np

from asperity.errors import InputError
from asperity.series import Series

COLUMNS = "t [s], slip [m], log10 V [m/s], shear stress [MPa], log10 theta [s]"
NAMES = ("t", "slip", "slip_rate", "shear_stress", "state")  # of these columns in SEAS files


def read_all(entries: Iterable[str], names: Sequence[str]) -> List[Series]:
    """Each entry is 'FILE' or 'RECEIVER=FILE', with RECEIVER one of `names`."""
    return [_entry(entry, names) for entry in entries]


def _entry(entry: str, names: Sequence[str]) -> Series:
    name, equals, file = entry.partition("=")
    if not equals or Path(entry).exists():
        return read(Path(entry), _receiver_of(Path(entry), names))
    if name not in names:
        raise InputError(f"--reference {entry}: no receiver '{name}' is shown. There are "
                         f"{', '.join(names)}.")
    return read(Path(file), name)


def _receiver_of(path: Path, names: Sequence[str]) -> Optional[str]:
    """The only receiver, or the longest name that stands in the name of the file."""
    if len(names) == 1:
        return names[0]
    return max((name for name in names if name in path.stem), key=len, default=None)


def read(path: Path, receiver: Optional[str] = None) -> Series:
    """COLUMNS, or those of a line of NAMES, after lines of text; InputError for anything else."""
    try:
        lines = path.read_text(encoding="utf-8").splitlines()
    except (OSError, UnicodeDecodeError) as error:
        raise InputError(f"{path} cannot be read ({error}).") from error
    lines = [line for line in lines if line.strip() and not line.lstrip().startswith("#")]
    names: Sequence[str] = NAMES
    while lines and _numbers(lines[0]) is None:
        words = lines.pop(0).lower().split()
        names = words if set(NAMES) <= set(words) else names
    rows = [_numbers(line) for line in lines]
    if not rows or any(row is None or len(row) != len(names) for row in rows):
        raise InputError(f"{path} is no series of SEAS: it needs five columns of numbers, "
                         f"{COLUMNS}, or a line with the names of its columns, among them "
                         f"{' '.join(NAMES)}.")
    time, slip, rate, stress, theta = np.array(rows).T[[names.index(name) for name in NAMES]]
    with np.errstate(over="ignore"):
        values = {"slip_rate": 10.0**rate, "traction": 1e6 * stress, "theta": 10.0**theta,
                  "slip": slip}
    return Series(path.stem, time, values, receiver)


def _numbers(line: str) -> Optional[List[float]]:
    """None unless the line has nothing but numbers, of which Fortran writes some with a D."""
    try:
        return [float(word) for word in line.replace("D", "E").replace(",", " ").split()]
    except ValueError:
        return None
