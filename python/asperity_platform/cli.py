"""The command line of asperity-platform."""

import argparse
from pathlib import Path
from typing import List, Optional

from asperity.program import DONE, program

REFUSED = 1  # exit status
ENDS = """exit status:
  0   the platform would take the files; with `zip`: FILE.zip is written
  1   it would refuse them: each line says which file, where, and why
  2   the command line is at fault, or DIR holds no files of a known problem"""


@program("asperity-platform")
def main(arguments: Optional[List[str]] = None) -> int:
    options = _parse(arguments)
    from . import archive, folder  # here, since numpy may be missing
    verdict = folder.check(options.directory, options.problem)
    for refusal in verdict.refusals:
        print(refusal)
    for path in verdict.spare:
        print(f"{path.name}: {verdict.problem} has no such station; the platform does not take it.")
    of_problem = f"{verdict.directory}: files of {verdict.problem} ({verdict.platform})"
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
        epilog=ENDS, usage="asperity-platform check DIR | zip DIR FILE.zip [--problem NAME]",
        description="Checks the files of a run for the platforms SEAS and SCEC as those would, and "
                    "packs them.")
    parser.add_argument("command", choices=("check", "zip"),
                        help="only check, or check and pack what the platform takes")
    parser.add_argument("directory", metavar="DIR", type=Path,
                        help="the folder with the files, or the run's")
    parser.add_argument("archive", metavar="FILE.zip", type=Path, nargs="?",
                        help="with `zip`: the archive to write")
    parser.add_argument("--problem", metavar="NAME", default="",
                        help="the benchmark, as in BP1-QD (default: what most headers name)")
    options = parser.parse_args(arguments)
    if (options.command == "zip") != (options.archive is not None):
        parser.error("`zip` needs DIR and FILE.zip, `check` needs DIR alone")
    return options
