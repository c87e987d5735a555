"""Functions that Kokkos 4 and Trilinos 14 to 17 renamed are called by portability/Renamed.hpp; what
has no equal in every release, as MueLu's functions around Xpetra's classes, is used by nobody."""

import re

from . import source

FOLDERS = ["packages", "drivers", "tests", "examples"]
HEADER = "packages/portability/Renamed.hpp"
KOKKOS_3 = "tests/support/SeparateMemory.hpp"  # is for that release alone
_RAW = re.compile(r"\b(?:getNodeNum\w*|getNodeMax\w*|getNodeElementList|getLocalNum(?:Rows|Cols|"
                  r"Entries|Elements)|getLocalMaxNumRowEntries|getLocalElementList|"
                  r"Kokkos::Experimental::\w+)\b")
# Instead: Xpetra::TpetraCrsMatrix and TpetraMultiVector; the type of a copy that was made.
_GONE = re.compile(r"\b(?:MV2(?:NonConst)?TpetraMV\w*|Op2(?:NonConst)?Tpetra\w+|"
                   r"Tpetra(?:Crs|MultiVector)_To_Xpetra\w+|Xpetra::to[TX]petra|HostMirror)\b")


def check(root):
    breaches = []
    for path in source.files(root, FOLDERS, source.CXX):
        name = path.relative_to(root).as_posix()
        if name in (HEADER, KOKKOS_3) or name.startswith("tests/unit/portability/"):
            continue
        text = source.without_comments(path.read_text())
        for match in _RAW.finditer(text):
            message = f"{match.group(0)} has two names; {HEADER} has one for both"
            breaches.append(source.breach(root, path, source.line_of(text, match.start()), message))
        for match in _GONE.finditer(text):
            message = f"{match.group(0)} is not in every release of Kokkos and Trilinos"
            breaches.append(source.breach(root, path, source.line_of(text, match.start()), message))
    return breaches
