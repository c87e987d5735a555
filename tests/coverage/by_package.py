"""Writes which share of each package's lines the tests have run, as a table in Markdown.

    cmake --preset coverage && cmake --build --preset coverage && ctest --preset coverage
    /usr/bin/python3 tests/coverage/by_package.py build-coverage

Reads gcov's counters in the build folder with gcovr (Debian's package of that name). A line counts
where gcov sees code in it, in headers and sources of packages/, once for all that include it.
Packages that stand after the folder must have 90 % or more; the exit status is 1 where one has not.
"""

import argparse
import collections
import json
import pathlib
import subprocess

ROOT = pathlib.Path(__file__).resolve().parents[2]
LEAST = 90.0


def counts(summary):
    """{package: [lines, lines that ran]} of gcovr's summary, the packages by name."""
    found = collections.defaultdict(lambda: [0, 0])
    for file in summary["files"]:
        package = pathlib.PurePath(file["filename"]).parts[1]
        found[package][0] += file["line_total"]
        found[package][1] += file["line_covered"]
    return dict(sorted(found.items()))


def table(packages):
    rows = [f"| `{name}` | {lines:,} | {ran:,} | {100 * ran / lines:.1f} % |"
            for name, (lines, ran) in packages.items()]
    return "\n".join(["| package | lines | that ran | share |", "|---|---|---|---|", *rows])


def read(build, jobs):
    command = ["gcovr", build, "--root", ROOT, "--filter", f"{ROOT}/packages/", "-j", str(jobs),
               "--json-summary"]
    result = subprocess.run(command, check=True, stdout=subprocess.PIPE, text=True)
    return json.loads(result.stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", help="folder of the preset coverage")
    parser.add_argument("packages", nargs="*", help=f"must have {LEAST:.0f} %% or more")
    parser.add_argument("-j", "--jobs", type=int, default=2)
    given = parser.parse_args()
    packages = counts(read(given.build, given.jobs))
    print(table(packages))
    too_few = [name for name in given.packages
               if name not in packages or 100 * packages[name][1] < LEAST * packages[name][0]]
    if too_few:
        raise SystemExit(f"Less than {LEAST:.0f} % of the lines ran in: {', '.join(too_few)}")


if __name__ == "__main__":
    main()
