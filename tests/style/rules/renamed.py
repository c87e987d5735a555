"""Functions that Kokkos 4 and Trilinos 14 to 17 renamed are called by portability/Renamed.hpp, and
MueLu's functions around Xpetra, which come and go, by nobody."""

import re

from . import source

FOLDERS = ["packages", "drivers", "tests", "examples"]
HEADER = "packages/portability/Renamed.hpp"
_RAW = re.compile(r"\b(?:getNodeNum\w*|getNodeMax\w*|getNodeElementList|getLocalNum(?:Rows|Cols|"
                  r"Entries|Elements)|getLocalMaxNumRowEntries|getLocalElementList|"
                  r"Kokkos::Experimental::\w+)\b")
# Xpetra's classes themselves, TpetraCrsMatrix and TpetraMultiVector, are in every release.
_XPETRA = re.compile(r"\b(?:MV2(?:NonConst)?TpetraMV\w*|Op2(?:NonConst)?Tpetra\w+|"
                     r"Tpetra(?:Crs|MultiVector)_To_Xpetra\w+|Xpetra::to[TX]petra)\b")


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
        for match in _XPETRA.finditer(text):
            message = f"{match.group(0)} is not in every release of Trilinos; take Xpetra's classes"
            breaches.append(source.breach(root, path, source.line_of(text, match.start()), message))
    return breaches
