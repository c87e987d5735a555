"""Doxygen's input filter: prints a header with its comments as plain text for Doxygen.

Every comment that has a line of its own becomes a documentation comment. What Doxygen would read as
HTML, a command or emphasis is escaped outside code spans and quotations, which it takes as they are.
"""

import re
import sys

COMMENT = re.compile(r"^( *)//( .*)?$")
TAKEN_AS_IT_IS_OR_SPECIAL = re.compile(r'(`[^`]*`|"[^"]*")|([<*#&@\\])')


def escaped(found):
    return found[1] or "\\" + found[2]


for line in open(sys.argv[1], encoding="utf-8").read().splitlines():
    if comment := COMMENT.match(line):
        text = TAKEN_AS_IT_IS_OR_SPECIAL.sub(escaped, comment[2] or "")
        line = f"{comment[1]}///{text}"
    print(line)
