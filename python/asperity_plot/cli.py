"""The command line: chooses figures of a run, and reports what is wrong."""

import argparse
import textwrap
from pathlib import Path
from typing import List, Optional, Tuple

from asperity import selection
from asperity.errors import InputError
from asperity.program import program, time, words

from .figures import FIGURES

PROGRAM = "asperity-plot"
FORMATS = ("png", "pdf", "svg")


@program(PROGRAM)
def main(arguments: Optional[List[str]] = None) -> int:
    """Draws the figures; 0 if all is well, 2 if the input is at fault."""
    options = _parse(arguments)
    if options.dpi < 30 or options.dpi > 1200:
        raise InputError(f"--dpi {options.dpi} is outside [30, 1200]. Use 200 for a printed page.")
    if options.directory.is_file():
        from .mesh_report import report_mesh  # here, since modules may be missing
        return report_mesh(options)
    if options.every and min(options.every) <= 0.0:
        raise InputError("--every needs two times above 0, such as 5yr 1s.")
    from .report import report  # here, since modules may be missing
    return report(PROGRAM, options)


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    listing = "\n".join(_line(name, *of) for name, of in FIGURES.items())
    parser = argparse.ArgumentParser(
        prog=PROGRAM, formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draws figures of a run of asperity, or of a mesh file, as PNG, PDF or SVG.",
        epilog="figures, and the file of the run that each needs:\n" + listing)
    parser.add_argument("directory", metavar="DIR or MESH.h5", type=Path,
                        help="the run's output directory, or a file of a mesh in space, of which "
                             "a map and a section are drawn")
    parser.add_argument("--output", metavar="DIR", type=Path,
                        help="where the figures go (default: figures in the run's directory, or "
                             "beside the mesh file)")
    parser.add_argument("--up", choices=("y", "z"), default="z",
                        help="of a mesh: the axis that points up (default: z)")
    parser.add_argument("--figures", metavar="NAME[,NAME...]", type=_names,
                        help="which to draw (default: all that the run has data for)")
    parser.add_argument("--events", action="store_true",
                        help="print tables of events, cycles and energies in Markdown; figures "
                             "only with --figures")
    parser.add_argument("--window", metavar=("T0", "T1"), nargs=2, type=time,
                        help="stretch of time to show, in seconds since the start of the run or as "
                             "196.4yr; also that over which the figure surface takes averages "
                             "(default: about five cycles around a median event of the run's "
                             "second half)")
    parser.add_argument("--every", metavar=("BETWEEN", "DURING"), nargs=2, type=time,
                        help="times from one slip profile to the next, between events and in "
                             "them (default: 5yr 1s, less for short runs and events)")
    parser.add_argument("--receivers", metavar="NAME[,NAME...]", type=words, default=(),
                        help="which to show, on the fault and in the body (default: all)")
    parser.add_argument("--reference", metavar="[RECEIVER=]FILE", action="append", default=[],
                        help="a series in the text format of SEAS to draw with the receivers")
    parser.add_argument("--at", metavar="DISTANCE[,DISTANCE...]", type=_lengths, default=(),
                        help="places of the slips in the table of --events: distances [m] along "
                             "the fault from its upper end, or from its end with the smaller x if "
                             "it is level (default: the receivers)")
    selection.add_options(parser)
    parser.add_argument("--format", choices=FORMATS, default=FORMATS[0],
                        help="of the files: png, or pdf or svg, whose lines and texts are sharp at "
                             "any size, for papers (default: png)")
    parser.add_argument("--dpi", type=int, default=200, help="dots per inch (default: 200)")
    return parser.parse_args(arguments)


def _line(name: str, meaning: str, file: str) -> str:
    """Of the list of figures: what it shows, and the file of the run that it needs."""
    return textwrap.fill(f"{meaning} [{file}]", 78, initial_indent=f"  {name:<17}",
                         subsequent_indent=19 * " ")


def _names(text: str) -> Tuple[str, ...]:
    names, known = words(text), f"the figures are {', '.join(FIGURES)}"
    for name in names:
        if name not in FIGURES:
            raise argparse.ArgumentTypeError(f"there is no figure '{name}'; {known}")
    if not names:
        raise argparse.ArgumentTypeError(f"names no figure; {known}")
    return names


def _lengths(text: str) -> Tuple[float, ...]:
    try:
        return tuple(float(word) for word in words(text))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no list of lengths [m]; write for example "
                                         "5000,7500") from None
