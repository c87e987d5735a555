"""A main program is under 80 lines: it starts things and leaves the work to the packages.

Each program is in the target asperity-programs, which `quickstart.sh run` builds.
"""

import re

from . import source

LONGEST_MAIN = 79
_MAIN = re.compile(r"^int main\(", re.MULTILINE)


_PROGRAM = re.compile(r"asperity_add_driver\((\S+)")
_BUILT = re.compile(r"foreach\(program ([^)]*)\)")


def forgotten_programs(root):
    """Programs that the quick start does not build, though the README goes on with them."""
    lists = list(source.files(root, ["drivers"], {".txt"}))
    named = {name: path for path in lists for name in _PROGRAM.findall(path.read_text())}
    built = {name for path in lists for names in _BUILT.findall(path.read_text())
             for name in names.split()}
    return [source.breach(root, path, 1, f"quickstart.sh run does not build {name}")
            for name, path in named.items() if name not in built]


def check(root):
    breaches = forgotten_programs(root)
    quickstart = root / "cmake" / "quickstart.sh"
    if quickstart.exists() and "--target asperity-programs" not in quickstart.read_text():
        breaches.append(source.breach(root, quickstart, 1, "builds not all programs"))
    for path in source.files(root, ["drivers"], source.CXX):
        text = path.read_text()
        lines = len(text.splitlines())
        if _MAIN.search(source.without_comments(text)) and lines > LONGEST_MAIN:
            message = f"a main program of {lines} lines, more than {LONGEST_MAIN}"
            breaches.append(source.breach(root, path, lines, message))
    return breaches
