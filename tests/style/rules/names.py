"""Names say what a thing is: no Manager, Helper or Utils, neither as a file nor as a type.

Tests of C++ have names in UpperCamel.
"""

import re

from . import source

_EMPTY = re.compile(r"manager|helper|utils|utilities", re.IGNORECASE)
_TYPE = re.compile(r"\b(?:class|struct|enum class|namespace|using)\s+(\w+)")
_TEST = re.compile(r"^(?:TYPED_)?TEST(?:_F|_P)?\(\s*\w+,\s*([a-z]\w*)", re.MULTILINE)


def check(root):
    breaches = []
    for path in source.files(root, ["packages", "drivers", "python", "tests", "cmake"]):
        if _EMPTY.search(path.name):
            breaches.append(source.breach(root, path, 1, f"the name '{path.name}' says nothing"))
        if path.suffix in source.CXX:
            text = source.without_comments(path.read_text())
            found = [(match, "says nothing") for match in _TYPE.finditer(text)
                     if _EMPTY.search(match.group(1))]
            found += [(match, "begins with a small letter") for match in _TEST.finditer(text)]
            for match, fault in found:
                breaches.append(source.breach(root, path, source.line_of(text, match.start()),
                                              f"the name '{match.group(1)}' {fault}"))
    return breaches
