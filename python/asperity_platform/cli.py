"""The command line of asperity-platform."""

import argparse
import sys
from pathlib import Path
from typing import List, Optional

from asperity.program import DONE, number, positive, program

REFUSED = 1  # exit status
ENDS = """exit status:
  0   `write`: the files are written; `check`: the platform would take them; `zip`: FILE.zip is
      written
  1   the platform would refuse them: each line says which file, where, and why
  2   the command line is at fault, or DIR holds no results or files of which this can be made"""


@program("asperity-platform")
def main(arguments: Optional[List[str]] = None) -> int:
    options = _parse(arguments)
    return options.command(options)


def _write(options: argparse.Namespace) -> int:
    from .write import write  # here and below, since numpy or h5py may be missing
    written = write(options)
    for line in written.lacking:
        print(f"Not written: {line}.")
    if written.warning:
        print(f"WARNING: {written.warning}", file=sys.stderr)
    print(f"{written.directory}: {len(written.files)} files for {written.platform.name}.")
    return DONE


def _check(options: argparse.Namespace) -> int:
    from . import archive, folder
    verdict = folder.check(options.directory, options.problem)
    for refusal in verdict.refusals:
        print(refusal)
    for path in verdict.spare:
        print(f"{path.name}: {verdict.problem} has no such station; the platform does not take it.")
    if verdict.is_outdated:
        print(f"WARNING: the run of {verdict.directory.parent} has gone on since these files were "
              "written. `asperity-platform write` writes them anew.", file=sys.stderr)
    of_problem = f"{verdict.directory}: files of {verdict.problem} ({verdict.platform.name})"
    if verdict.refusals:
        print(f"{of_problem}, {len(verdict.refusals)} to be put right: refused.")
        return REFUSED
    if options.archive:
        archive.write(options.archive, verdict.taken)
    print(f"{of_problem}, {len(verdict.taken)} of them: accepted.")
    return DONE


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="asperity-platform", formatter_class=argparse.RawDescriptionHelpFormatter,
        epilog=ENDS, description="Writes the files that the platforms SEAS and SCEC take, of a run "
                                 "that is done or goes on; checks them as those would, packs them.")
    commands = parser.add_subparsers(metavar="COMMAND", required=True)
    _add_write(commands.add_parser("write", help="write the files of a run into its folder"))
    for name, words in (("check", "say whether the platform would take the files"),
                        ("zip", "the same, and pack what it takes")):
        command = commands.add_parser(name, help=words)
        command.set_defaults(command=_check, archive=None)
        command.add_argument("directory", metavar="DIR", type=Path,
                             help="the folder with the files, or the run's")
        if name == "zip":
            command.add_argument("archive", metavar="FILE.zip", type=Path,
                                 help="the archive to write")
        command.add_argument("--problem", metavar="NAME", default="",
                             help="the benchmark, as in BP1-QD (default: what most headers name)")
    return parser.parse_args(arguments)


def _add_write(command: argparse.ArgumentParser) -> None:
    command.set_defaults(command=_write)
    command.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    command.add_argument("problem", metavar="PROBLEM",
                         help="the benchmark, as in BP1-QD or TPV101")
    command.add_argument("--format", metavar="PLATFORM", choices=("seas", "scec"), default="",
                         help="seas or scec (default: that of the problem)")
    group = command.add_argument_group("what the headers say")
    group.add_argument("--author", metavar="NAME", default="unknown",
                       help="who ran the benchmark (default: unknown)")
    group.add_argument("--date", metavar="2024/05/31", default="",
                       help="the day of the run (default: when its last process was started)")
    group.add_argument("--code-version", metavar="TEXT", default="",
                       help="the version of the program (default: what run.log says)")
    group.add_argument("--element-size", metavar="METRES", type=positive(number), default=None,
                       help="size of the elements on the fault (default: of the shortest one; in "
                            "three dimensions the side of a square that two of them fill)")
    group = command.add_argument_group("what the rows are")
    group.add_argument("--depth-of-upper-end", metavar="METRES", type=number, default=0.0,
                       help="distance down dip of the fault's upper end in files of rupture times, "
                            "where the model is the part of space below a plane of symmetry and "
                            "the problem counts from the surface (default: 0)")
    group.add_argument("--time-step", metavar="SECONDS", type=positive(number), default=0.01,
                       help="step of the rows for SCEC, which takes equal steps (default: 0.01)")
