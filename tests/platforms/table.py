"""The table of docs/cost/platforms.md.

    table.py row FOLDER RUN_SECONDS TEST_SECONDS [--cached]    writes FOLDER/row.json, for roots.sh
    table.py page ROW.json...                                  puts rows into docs/cost/platforms.md

A row takes the place of the one of the same suite that the page has.
"""

import argparse
import json
import pathlib
import re

PAGE = pathlib.Path(__file__).resolve().parents[2] / "docs" / "cost" / "platforms.md"
RELEASES = {"bookworm": "Debian 12 (bookworm)", "trixie": "Debian 13 (trixie)",
            "sid": "Debian sid", "experimental": "Debian sid, Trilinos of experimental"}
UNKNOWN = "?"
# What `asperity --version` prints.
VERSIONS = {"compiler": r"Built from .*?\b(GNU \S+?),", "trilinos": r"Trilinos (\S+?)[,.]?\s",
            "kokkos": r"Kokkos (\S+?),", "mpi": r"Open MPI v?(\S+?)\.?\s", "hdf5": r"HDF5 (\S+?),"}


def version_row(text):
    found = {name: re.search(pattern, text + "\n") for name, pattern in VERSIONS.items()}
    return {name: match.group(1) if match else UNKNOWN for name, match in found.items()}


def test_row(text):
    """What ctest's summary, the last in the text, says: numbers of tests, and {name: how} of those
    that did not pass. A test that runs ctest itself has printed its summary before, if it failed.
    """
    totals = list(re.finditer(r"(\d+) tests? failed out of (\d+)", text))
    if not totals:
        return {"passed": 0, "of": 0, "others": {}}
    total = totals[-1]
    others = dict(re.findall(r"^\s+\d+ - (\S+) \(([^()]+)\)", text[total.end():], re.MULTILINE))
    skipped = sum(how == "Skipped" for how in others.values())
    return {"passed": int(total.group(2)) - int(total.group(1)) - skipped,
            "of": int(total.group(2)), "others": others}


def write_row(folder, run_seconds, test_seconds, cached):
    def text(name):
        path = folder / f"{name}.log"
        return path.read_text(errors="replace") if path.exists() else ""

    row = {"suite": folder.name, **version_row(text("version")), **test_row(text("test"))}
    if not cached:
        row.update(run_seconds=run_seconds, test_seconds=test_seconds)
    (folder / "row.json").write_text(json.dumps(row, indent=2) + "\n")
    print(line_of(row))


def line_of(row):
    others = ", ".join(f"`{name}` ({how.lower()})" for name, how in sorted(row["others"].items()))
    passed = f"{row['passed']} of {row['of']}" if row["of"] else "not built"
    seconds = [str(row.get(name, "")) for name in ("run_seconds", "test_seconds")]
    cells = [RELEASES[row["suite"]], row["compiler"].replace("GNU", "g++"), row["trilinos"],
             row["kokkos"], f"Open MPI {row['mpi']}", row["hdf5"], passed, others or "none",
             *seconds]
    return "| " + " | ".join(cells) + " |"


def page_with(page, rows):
    """The page's text with these rows after the head of its table, in the order of RELEASES."""
    head = re.search(r"^\| release .*\n\|[-| ]+\|\n", page, re.MULTILINE)
    body = re.compile(r"(?:\|.*\n)*").match(page, head.end())
    lines = {line.split("|")[1].strip(): line for line in body.group().splitlines()}
    lines.update({RELEASES[row["suite"]]: line_of(row) for row in rows})
    table = "".join(lines[name] + "\n" for name in RELEASES.values() if name in lines)
    return page[:head.end()] + table + page[body.end():]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    commands = parser.add_subparsers(dest="command", required=True)
    row = commands.add_parser("row")
    row.add_argument("folder", type=pathlib.Path)
    row.add_argument("run_seconds", type=int)
    row.add_argument("test_seconds", type=int)
    row.add_argument("--cached", action="store_true")
    page = commands.add_parser("page")
    page.add_argument("rows", type=pathlib.Path, nargs="+")
    given = parser.parse_args()
    if given.command == "row":
        write_row(given.folder, given.run_seconds, given.test_seconds, given.cached)
    else:
        rows = [json.loads(path.read_text()) for path in given.rows]
        PAGE.write_text(page_with(PAGE.read_text(), rows))


if __name__ == "__main__":
    main()
