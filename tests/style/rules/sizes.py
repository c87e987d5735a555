"""A folder of packages/ holds at most 25 sources, a package at most 70; headers count."""

import collections

from . import source

LARGEST_FOLDER = 25
LARGEST_PACKAGE = 70


def check(root):
    folders, packages = collections.Counter(), collections.Counter()
    for path in source.files(root, ["packages"], source.CXX):
        folders[path.parent.relative_to(root)] += 1
        packages[path.relative_to(root).parts[1]] += 1
    return [*_breaches(folders, LARGEST_FOLDER, "{}:1: {} sources in one folder, more than {}"),
            *_breaches(packages, LARGEST_PACKAGE, "packages/{}:1: {} sources, more than {}")]


def _breaches(counts, limit, text):
    return [text.format(name, count, limit) for name, count in counts.items() if count > limit]
