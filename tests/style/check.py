#!/usr/bin/env python3
"""Checks the tree against one of the rules of style in rules/; `check.py RULE [ROOT]`.

Breaches are printed as file:line: text, and the exit status is 1 if there are any.
"""

import importlib
import pathlib
import sys

RULES = ["includes", "kernels", "layout", "marks", "drivers", "decks", "names",
         "folders", "readmes", "renamed", "devices", "format"]


def main(arguments):
    if not arguments or arguments[0] not in RULES:
        print(__doc__, "Rules:", *RULES, file=sys.stderr)
        return 2
    root = pathlib.Path(arguments[1] if len(arguments) > 1 else __file__).resolve()
    if root.is_file():
        root = root.parents[2]
    rule = importlib.import_module(f"rules.{arguments[0]}")
    breaches = rule.check(root)
    print(*breaches, sep="\n")
    if breaches:
        print(f"\n{len(breaches)} breaches of: {rule.__doc__}")
    return 1 if breaches else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
