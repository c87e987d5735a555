"""Functions that Kokkos 4 and Trilinos 14 to 16 renamed are called by portability/Renamed.hpp."""

import re

from . import source

FOLDERS = ["packages", "drivers", "tests", "examples"]
HEADER = "packages/portability/Renamed.hpp"
_RAW = re.compile(r"\b(?:getNodeNum\w*|getNodeMax\w*|getNodeElementList|getLocalNum(?:Rows|Cols|"
                  r"Entries|Elements)|getLocalMaxNumRowEntries|getLocalElementList|"
                  r"Kokkos::Experimental::\w+)\b")


def check(root):
    breaches = []
    for path in source.files(root, FOLDERS, source.CXX):
        name = path.relative_to(root).as_posix()
        if name == HEADER or name.startswith("tests/unit/portability/"):
            continue
        text = source.without_comments(path.read_text())
        for match in _RAW.finditer(text):
            message = f"{match.group(0)} has two names; {HEADER} has one for both"
            breaches.append(source.breach(root, path, source.line_of(text, match.start()), message))
    return breaches
