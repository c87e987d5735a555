"""Times with a unit, such as 5yr, 36h, 20ms, or in seconds without one.

A year has 365.25 days, 3.15576e7 s, as in the descriptions of the SEAS benchmarks.
"""

import math
import re

MINUTE, HOUR, DAY, YEAR = 60.0, 3600.0, 86400.0, 365.25 * 86400.0
SECONDS = {"us": 1e-6, "ms": 1e-3, "s": 1.0, "min": MINUTE, "h": HOUR, "d": DAY, "yr": YEAR}


def seconds(text: str) -> float:
    """The duration `text` in seconds; ValueError says what is wrong with it."""
    match = re.fullmatch(r"\s*([-+0-9.eE]+?)\s*([a-z]*)\s*", text)
    unit = match.group(2) or "s" if match else ""
    try:
        value = float(match.group(1)) * SECONDS[unit]
    except (AttributeError, KeyError, ValueError):
        raise ValueError(f"'{text}' is no time; write a number of seconds, or one with a unit of "
                         f"{', '.join(SECONDS)}, such as 196.4yr") from None
    if not math.isfinite(value):
        raise ValueError(f"'{text}' is too large for a time")
    return value


def text(seconds_: float) -> str:
    """A duration as the program's log has it: '42 s', '12 min 4 s', '1 h 6 min', '3 d 2 h'."""
    if seconds_ < 10.0:
        return f"{seconds_:.3g} s"
    for large, small, names in ((MINUTE, 1.0, ("min", "s")), (HOUR, MINUTE, ("h", "min")),
                                (DAY, HOUR, ("d", "h"))):
        limit = {MINUTE: HOUR, HOUR: DAY}.get(large, YEAR)
        if seconds_ < large:
            break
        count = round(seconds_ / small)
        if count * small < limit:
            whole, rest = divmod(count, round(large / small))
            return f"{whole} {names[0]}" + (f" {rest} {names[1]}" if rest else "")
    return f"{seconds_:.0f} s" if seconds_ < MINUTE else f"{seconds_ / YEAR:.3g} yr"
