"""The command line of asperity-report."""

import argparse
import sys
from pathlib import Path
from typing import List, Optional

from asperity import selection
from asperity.program import what_to_install

INPUT_ERROR = 2


def main(arguments: Optional[List[str]] = None) -> int:
    """0, or 2 if the input is at fault; what can be shown is shown nevertheless."""
    options = _parse(arguments)
    try:
        from asperity.errors import InputError  # here, since modules may be missing
        from .report import report
    except ImportError as error:
        return _fail([what_to_install(error)])
    path = options.output or options.directory / "report.html"
    try:
        text, wrong = report(options.directory, selection.chosen(options))
        path.write_text(text, encoding="utf-8")
    except InputError as error:
        return _fail([str(error)])
    except OSError as error:
        return _fail([f"{path} cannot be written ({error.strerror}). Choose another place with "
                      "--output."])
    print(path)
    return _fail(wrong) if wrong else 0


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="asperity-report",
        description="Writes one page of HTML about a run of asperity, which needs no network: "
                    "parameters, events, figures, solver, provenance.")
    parser.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    selection.add_options(parser)
    parser.add_argument("--output", metavar="FILE", type=Path,
                        help="the page (default: report.html in the run's directory)")
    return parser.parse_args(arguments)


def _fail(messages: List[str]) -> int:
    for message in messages:
        print(f"asperity-report: {message}", file=sys.stderr)
    return INPUT_ERROR
