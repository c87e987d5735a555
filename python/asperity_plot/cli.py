"""The command line: chooses figures of a run, and reports what is wrong."""

import argparse
import sys
from pathlib import Path
from typing import List, Optional, Tuple

from asperity import selection
from asperity.durations import seconds

MODULES = {"numpy": "python3-numpy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib"}
FIGURES = {
    "slip_rate": "slip rate over position and time, with a zoom into a rupture",
    "surface": "vertical displacement of the surface relative to its time average",
    "deformation": "displacement of the surface before and in an event; in 3D maps",
    "events": "box plots of recurrence time, rupture width, peak slip and more",
    "iterations": "fixed point iterations and step size",
    "slip": "profiles of cumulative slip",
    "energy": "balance of energy over the run",
    "slip_profiles": "cumulative slip, lines years apart and seconds apart in ruptures",
    "receivers": "slip rate, shear traction, state and slip at the receivers on the fault",
    "rupture_times": "first arrival of each rupture over the position",
    "moment_rate": "moment rate and moment of each event",
    "fault_maps": "in 3D: slip of an event and its rupture front on the fault",
    "rupture_patterns": "in 3D: rupture fronts of the last events side by side",
    "fault_history": "in 3D: peak slip rate, and slip rate along strike over time",
}
INPUT_ERROR = 2


def main(arguments: Optional[List[str]] = None) -> int:
    """Draws the figures; 0 if all is well, 2 if the input is at fault."""
    options = _parse(arguments)
    if options.dpi < 30 or options.dpi > 1200:
        return _fail(f"--dpi {options.dpi} is outside [30, 1200]. Use 200 for a printed page.")
    if options.every and min(options.every) <= 0.0:
        return _fail("--every needs two times above 0, such as 5yr 1s.")
    missing = _missing_modules()
    if missing:
        packages = " ".join(MODULES[name] for name in missing)
        return _fail(f"{sys.executable} has no module {', '.join(missing)}. On Debian: "
                     f"apt-get install {packages}")
    from .report import report  # needs the modules
    return report(options)


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    listing = "\n".join(f"  {name:<17}{meaning}" for name, meaning in FIGURES.items())
    parser = argparse.ArgumentParser(
        prog="asperity-plot", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draws figures of a run of asperity as PNG.", epilog="figures:\n" + listing)
    parser.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    parser.add_argument("--output", metavar="DIR", type=Path,
                        help="where the figures go (default: figures in the run's directory)")
    parser.add_argument("--figures", metavar="NAME[,NAME...]", type=_names,
                        help="which to draw (default: all that the run has data for)")
    parser.add_argument("--events", action="store_true",
                        help="print tables of events, cycles and energies in Markdown; figures "
                             "only with --figures")
    parser.add_argument("--window", metavar=("T0", "T1"), nargs=2, type=_time,
                        help="stretch of time to show, in seconds or as 196.4yr (default: about "
                             "five cycles around a median event of the run's second half)")
    parser.add_argument("--every", metavar=("BETWEEN", "DURING"), nargs=2, type=_time,
                        help="times from one slip profile to the next, between events and in "
                             "them (default: 5yr 1s, less for short runs and events)")
    parser.add_argument("--receivers", metavar="NAME[,NAME...]", type=_words, default=(),
                        help="which to show (default: all on the fault)")
    parser.add_argument("--reference", metavar="[RECEIVER=]FILE", action="append", default=[],
                        help="a series in the text format of SEAS to draw with the receivers")
    parser.add_argument("--at", metavar="DEPTH[,DEPTH...]", type=_lengths, default=(),
                        help="depths or positions on the fault [m] of the slips in the table of "
                             "events (default: the receivers)")
    selection.add_options(parser)
    parser.add_argument("--dpi", type=int, default=200, help="dots per inch (default: 200)")
    return parser.parse_args(arguments)


def _names(text: str) -> Tuple[str, ...]:
    names = _words(text)
    for name in names:
        if name not in FIGURES:
            raise argparse.ArgumentTypeError(
                f"there is no figure '{name}'; the figures are {', '.join(FIGURES)}")
    if not names:
        raise argparse.ArgumentTypeError(f"names no figure; the figures are {', '.join(FIGURES)}")
    return names


def _time(text: str) -> float:
    try:
        return seconds(text)
    except ValueError as error:
        raise argparse.ArgumentTypeError(str(error)) from None


def _words(text: str) -> Tuple[str, ...]:
    return tuple(word.strip() for word in text.split(",") if word.strip())


def _lengths(text: str) -> Tuple[float, ...]:
    try:
        return tuple(float(word) for word in _words(text))
    except ValueError:
        raise argparse.ArgumentTypeError(f"'{text}' is no list of lengths [m]; write for example "
                                         "5000,7500") from None


def _missing_modules() -> List[str]:
    missing = []
    for name in MODULES:
        try:
            __import__(name)
        except ImportError:
            missing.append(name)
    return missing


def _fail(message: str) -> int:
    print(f"asperity-plot: {message}", file=sys.stderr)
    return INPUT_ERROR
