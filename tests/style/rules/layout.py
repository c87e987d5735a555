"""Lines of at most 100 characters, no tabs or blanks at their end; a newline at the end; length."""

from . import source

LONGEST_LINE = 100
LONGEST_FILE = 500
FOLDERS = ["packages", "drivers", "python", "cmake", "tests", "xml", "examples"]


def check(root):
    breaches = []
    for path in source.files(root, FOLDERS, source.SOURCE | {""}):
        text = path.read_text()
        lines = text.split("\n")
        for number, line in enumerate(lines, 1):
            for message in _line_breaches(line):
                breaches.append(source.breach(root, path, number, message))
        if text and not text.endswith("\n"):
            breaches.append(source.breach(root, path, len(lines), "no newline at the end"))
        if len(lines) > LONGEST_FILE:
            message = f"{len(lines)} lines; is there a second responsibility in it?"
            breaches.append(source.breach(root, path, len(lines), message))
        if path.suffix == ".hpp" and not text.startswith("#pragma once\n"):
            breaches.append(source.breach(root, path, 1, "does not start with #pragma once"))
    return breaches


def _line_breaches(line):
    if len(line) > LONGEST_LINE:
        yield f"{len(line)} characters, more than {LONGEST_LINE}"
    if "\t" in line:
        yield "a tab"
    if line != line.rstrip():
        yield "blanks at the end"
