"""The command line of asperity-report."""

import argparse
from pathlib import Path
from typing import List, Optional

from asperity import selection
from asperity.errors import InputError
from asperity.program import fail, program

PROGRAM = "asperity-report"


@program(PROGRAM)
def main(arguments: Optional[List[str]] = None) -> int:
    """0, or 2 if the input is at fault; what can be shown is shown nevertheless."""
    options = _parse(arguments)
    from .report import report  # here, since modules may be missing
    path = options.output or options.directory / "report.html"
    text, wrong = report(options.directory, selection.chosen(options))
    try:
        path.write_text(text, encoding="utf-8")
    except OSError as error:
        raise InputError(f"{path} cannot be written ({error.strerror}). Choose another place with "
                         "--output.") from error
    print(path)
    return fail(PROGRAM, *wrong)


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog=PROGRAM,
        description="Writes one page of HTML about a run of asperity, which needs no network: "
                    "parameters, events, figures, solver, provenance.")
    parser.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    selection.add_options(parser)
    parser.add_argument("--output", metavar="FILE", type=Path,
                        help="the page (default: report.html in the run's directory)")
    return parser.parse_args(arguments)
