"""No two folders of a package include each other, directly or in a circle of several.

The folder detail/ of a folder is a part of it.
"""

import collections

from . import source
from .includes import QUOTED


def check(root):
    packages = sorted(path.name for path in (root / "packages").iterdir() if path.is_dir())
    return [breach for package in packages for breach in _breaches(root, package)]


def _folder(parts):
    return "/".join(part for part in parts if part != "detail")


def _breaches(root, package):
    includes = collections.defaultdict(list)  # (from folder, to folder) -> [(file, line, header)]
    for path in source.files(root, [f"packages/{package}"], source.CXX):
        here = _folder(path.relative_to(root / "packages").parts[:-1])
        text = source.without_comments(path.read_text())
        for match in QUOTED.finditer(text):
            *folders, _ = match.group(1).split("/")
            if folders[:1] == [package] and _folder(folders) != here:
                line = source.line_of(text, match.start(1))
                includes[here, _folder(folders)].append((path, line, match.group(1)))
    seen = _seen_from(includes)
    for (here, there), places in sorted(includes.items()):
        if here in seen[there]:
            for path, line, header in places:
                yield source.breach(root, path, line, f'includes "{header}", but {there} includes '
                                                      f"{here}, itself or through others")


def _seen_from(edges):
    """{folder: all folders that it includes, itself or through others}."""
    seen = collections.defaultdict(set)
    for here, there in edges:
        seen[here].add(there)
    for middle in list(seen):
        for here in list(seen):
            if middle in seen[here]:
                seen[here] |= seen[middle]
    return seen
