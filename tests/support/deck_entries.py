"""The entries that a deck may have, as docs/reference/parameters.md lists them."""

import functools
import os
import pathlib
import re

PAGE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"]) / "docs" / "reference" / "parameters.md"
SECTION = re.compile(r"^## ([^\n]*)\n(.*?)(?=^## |\Z)", re.MULTILINE | re.DOTALL)
ROW = re.compile(r"^\| `([^`]+)` \| (\w*)", re.MULTILINE)
# Lists whose entries another library reads.
FOREIGN = ("TNNMG / Multigrid / MueLu", "TNNMG / Multigrid / Belos")


@functools.lru_cache(maxsize=None)
def _known():
    """An expression for the paths of all entries; a field may also be a list of regions."""
    paths = [f"{name} / .*" for name in FOREIGN]
    for heading, text in SECTION.findall(PAGE.read_text(encoding="utf-8")):
        where = _expression(heading.replace("&lt;", "<").split(", with ")[0])
        paths += [f"{where} / {_expression(name)}" + ("( / [^/]+)?" if allowed == "field" else "")
                  for name, allowed in ROW.findall(text)]
    return re.compile("|".join(path.replace(" / ", "/") for path in paths))


def _expression(words):
    """Of a path in which <names> may be any."""
    return "[^/]+".join(map(re.escape, re.split("<[^>]+>", words))).replace(r"\ ", " ")


def require_known(path, of_plugin=()):
    """Raises ValueError unless the program or a plugin, as the caller says, has this entry."""
    if path not in of_plugin and not _known().fullmatch(path):
        raise ValueError(f"'{path}' is no entry of a deck: {PAGE.name} does not have it. Name the "
                         "entries of a plugin in `of_plugin`.")
