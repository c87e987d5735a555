"""Finding and reading the files that the rules look at."""

import pathlib
import re

CXX = {".hpp", ".cpp"}
SOURCE = CXX | {".cmake", ".in", ".txt", ".py", ".sh", ".xml"}


def files(root, folders, suffixes=None):
    """Files below the folders, sorted, of the given suffixes or all; caches are left out."""
    for folder in folders:
        for path in sorted((pathlib.Path(root) / folder).rglob("*")):
            if path.is_file() and "__pycache__" not in path.parts:
                if suffixes is None or path.suffix in suffixes:
                    yield path


def breach(root, path, line, text):
    """One line of a report, as compilers write it."""
    return f"{path.relative_to(root)}:{line}: {text}"


_TOKEN = re.compile(
    r'R"(?P<mark>[^(\s]*)\(.*?\)(?P=mark)"'  # raw string
    r'|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'|//[^\n]*|/\*.*?\*/',
    re.DOTALL,
)


def without_comments(text):
    """C++ text whose comments are blanks; strings, and the numbers of lines, stay."""

    def blank(match):
        token = match.group(0)
        return re.sub(r"[^\n]", " ", token) if token.startswith("/") else token

    return _TOKEN.sub(blank, text)


def line_of(text, position):
    """The number of the line, from 1, of a position in the text."""
    return text.count("\n", 0, position) + 1
