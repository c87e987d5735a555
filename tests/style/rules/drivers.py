"""A main program is under 80 lines: it starts things and leaves the work to the packages."""

import re

from . import source

LONGEST_MAIN = 79
_MAIN = re.compile(r"^int main\(", re.MULTILINE)


def check(root):
    breaches = []
    for path in source.files(root, ["drivers"], source.CXX):
        text = path.read_text()
        lines = len(text.splitlines())
        if _MAIN.search(source.without_comments(text)) and lines > LONGEST_MAIN:
            message = f"a main program of {lines} lines, more than {LONGEST_MAIN}"
            breaches.append(source.breach(root, path, lines, message))
    return breaches
