"""Line coverage by package, of a build with the preset `coverage` whose tests have run:

    cmake --preset coverage && cmake --build --preset coverage && ctest --preset coverage
    python3 cmake/coverage.py build-coverage [--least 90 friction tnnmg dynamics]

Counts lines of packages/ and drivers/, headers too, each once however often it is compiled. Needs
gcovr (a Debian package). Status 1 if one of the packages named has less than --least percent.
"""

import argparse
import collections
import json
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(__file__).resolve().parent.parent


def summary(build):
    """[{filename, line_total, line_covered}, ...]"""
    words = ["gcovr", "--root", SOURCE, "--object-directory", build, "-j", "2",
             "--filter", f"{SOURCE}/packages/", "--filter", f"{SOURCE}/drivers/",
             "--gcov-ignore-parse-errors", "--merge-mode-functions", "merge-use-line-min",
             "--json-summary", "-", build]
    result = subprocess.run([str(word) for word in words], stdout=subprocess.PIPE, check=True)
    return json.loads(result.stdout)["files"]


def package_of(name):
    parts = pathlib.PurePath(name).parts
    return parts[1] if parts[0] == "packages" else f"drivers/{parts[1]}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("packages", nargs="*")
    parser.add_argument("--least", type=float, default=90)
    options = parser.parse_args()
    lines = collections.defaultdict(lambda: [0, 0])
    for entry in summary(options.build.resolve()):
        count = lines[package_of(entry["filename"])]
        count[0] += entry["line_covered"]
        count[1] += entry["line_total"]
    print("| package | lines | run by tests |\n|---|---|---|")
    for name, (covered, total) in sorted(lines.items()):
        print(f"| {name} | {total:,} | {100 * covered / total:.1f} % |")
    low = [name for name in options.packages
           if 100 * lines[name][0] < options.least * lines[name][1]]
    if low:
        print(f"below {options.least:g} %: {', '.join(low)}", file=sys.stderr)
    return 1 if low else 0


if __name__ == "__main__":
    sys.exit(main())
