"""No marks of unfinished work, no test that cannot fail or is skipped without a reason."""

import re

from . import source

# Written in pieces, so that a search for the marks does not find this file.
_UNFINISHED = ["TO" "DO", "FIX" "ME", "XX" "X", "HA" "CK", "st" "ub", "place" "holder",
               "not imple" "mented"]
_TOOTHLESS = [r"(EXPECT|ASSERT)_TRUE\(" r"true\)", "DIS" "ABLED_", "GTEST_" r"SKIP\(\)(?!\s*<<)",
              r"EXPECT_NO_THROW\(" r"\)"]
_MARK = re.compile(r"\b(" + "|".join(_UNFINISHED) + r")\b|" + "|".join(_TOOTHLESS))


def check(root):
    breaches = []
    for path in source.files(root, ["packages", "drivers", "python", "cmake", "tests", "xml"]):
        if path.suffix not in source.SOURCE | {"", ".md"}:
            continue
        for number, line in enumerate(path.read_text().split("\n"), 1):
            match = _MARK.search(line)
            if match:
                breaches.append(source.breach(root, path, number, f"'{match.group(0)}'"))
    return breaches
