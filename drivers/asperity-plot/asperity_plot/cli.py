"""The command line: which figures of which run, and what went wrong if anything did."""

import argparse
import sys
from pathlib import Path
from typing import List, Optional

MODULES = {"numpy": "python3-numpy", "h5py": "python3-h5py", "matplotlib": "python3-matplotlib"}
FIGURES = {
    "slip_rate": "slip rate over position and time, with a zoom into a rupture",
    "surface": "vertical displacement of the surface relative to its time average",
    "events": "box plots of recurrence time, rupture width, peak slip and more",
    "iterations": "fixed point iterations and step size",
    "slip": "profiles of cumulative slip",
    "energy": "balance of energy over the run",
}
INPUT_ERROR = 2


def main(arguments: Optional[List[str]] = None) -> int:
    """Draws the figures; 0 if all is well, 2 if the input is at fault."""
    options = _parse(arguments)
    if options.dpi < 30 or options.dpi > 1200:
        return _fail(f"--dpi {options.dpi} is outside [30, 1200]. 200 suits a page.")
    missing = _missing_modules()
    if missing:
        packages = " ".join(MODULES[name] for name in missing)
        return _fail(f"{sys.executable} has no module {', '.join(missing)}. On Debian: "
                     f"apt-get install {packages}")
    from .report import report  # needs the modules
    return report(options)


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    listing = "\n".join(f"  {name:<12}{meaning}" for name, meaning in FIGURES.items())
    parser = argparse.ArgumentParser(
        prog="asperity-plot", formatter_class=argparse.RawDescriptionHelpFormatter,
        description="Draws figures of a run of asperity as PNG.", epilog="figures:\n" + listing)
    parser.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    parser.add_argument("--output", metavar="DIR", type=Path,
                        help="where the figures go (default: figures in the run's directory)")
    parser.add_argument("--figures", metavar="NAME[,NAME...]", type=_names,
                        help="which to draw (default: all that the run has data for)")
    parser.add_argument("--window", metavar=("T0", "T1"), nargs=2, type=float,
                        help="stretch of time to show [s] (default: about five cycles around a "
                             "median event of the run's second half)")
    parser.add_argument("--dpi", type=int, default=200, help="dots per inch (default: 200)")
    return parser.parse_args(arguments)


def _names(text: str) -> List[str]:
    names = [name.strip() for name in text.split(",") if name.strip()]
    for name in names:
        if name not in FIGURES:
            raise argparse.ArgumentTypeError(
                f"there is no figure '{name}'; there are {', '.join(FIGURES)}")
    if not names:
        raise argparse.ArgumentTypeError(f"names no figure; there are {', '.join(FIGURES)}")
    return names


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
