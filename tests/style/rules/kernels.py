"""Every Kokkos kernel of a package carries a label "asperity::<package>::...", for profilers."""

import re

from . import source

_KERNEL = re.compile(r"\b(parallel_(?:for|reduce|scan))\s*(?:<[^;(]*>)?\(\s*")
# Loops inside a team's kernel take no label.
_NESTED = re.compile(r"(?:Kokkos::)?(?:TeamThread|TeamVector|ThreadVector)Range\b")
_VARIABLE = re.compile(r"(\w+)\s*,")


def check(root):
    breaches = []
    for path in source.files(root, ["packages"], source.CXX):
        prefix = f'"asperity::{path.relative_to(root).parts[1]}::'
        text = source.without_comments(path.read_text())
        for match in _KERNEL.finditer(text):
            argument = _first_argument(text, match.end())
            if not argument.startswith(prefix) and not _NESTED.match(argument):
                message = f'{match.group(1)} without a label that starts with {prefix}"'
                breaches.append(
                    source.breach(root, path, source.line_of(text, match.start()), message))
    return breaches


def _first_argument(text, position):
    """The text from there on; of a variable the value it was last given as a string before."""
    variable = _VARIABLE.match(text, position)
    if variable:
        values = re.findall(rf'\b{variable.group(1)}\s*[=({{]\s*("[^"]*")', text[:position])
        return values[-1] if values else ""
    return text[position:]
