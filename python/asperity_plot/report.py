"""Draws the figures of a run one by one and prints which were drawn."""

import sys
from argparse import Namespace
from pathlib import Path
from typing import List, Optional

from asperity import selection
from asperity.errors import InputError, NothingToShow, OtherDimension
from asperity.run import Run

from . import (boxes, deformation, energy, event_table, fault_history, fault_maps, iterations,
               moment_rate, receivers, rupture_patterns, rupture_times, slip, slip_profiles,
               slip_rate, style, surface, windows)
from .options import Options

FIGURES = {  # name: (module with draw(run, view), the file it needs)
    "slip_rate": (slip_rate, "fault.h5"),
    "surface": (surface, "surface.h5"),
    "deformation": (deformation, "surface.h5"),
    "events": (boxes, "events.csv"),
    "iterations": (iterations, "steps.csv"),
    "slip": (slip, "fault.h5"),
    "energy": (energy, "steps.csv"),
    "slip_profiles": (slip_profiles, "fault.h5"),
    "receivers": (receivers, "receivers.h5"),
    "rupture_times": (rupture_times, "rupture.h5"),
    "moment_rate": (moment_rate, "global.csv"),
    "fault_maps": (fault_maps, "fault.h5"),
    "rupture_patterns": (rupture_patterns, "rupture.h5"),
    "fault_history": (fault_history, "fault.h5"),
}


def report(options: Namespace) -> int:
    """Exit status: 0, or 2 if the input is at fault; the other figures are drawn nevertheless."""
    try:
        run = Run(options.directory, selection.chosen(options))
        view = windows.choose(run, options.window, _options(options))
        if options.events:
            print(event_table.text(run, view))
        if options.events and not options.figures:
            return 0
        folder = _make_folder(options.output or options.directory / "figures")
    except InputError as error:
        return _status([str(error)])
    errors = _draw_all(run, view, folder, options)
    if not options.events:
        _print_summary(run)
    return _status(errors)


def _options(given: Namespace) -> Options:
    return Options(intervals=given.every and tuple(given.every), receivers=given.receivers,
                   references=tuple(given.reference), depths=given.at)


def _draw_all(run: Run, view: windows.View, folder: Path, options: Namespace) -> List[str]:
    """What was wrong with the input of single figures."""
    style.use()
    errors: List[str] = []
    for name in options.figures or FIGURES:
        try:
            path = _draw(name, run, view, folder, options)
            if path is not None:
                print(path)
        except NothingToShow as reason:
            if options.figures or not isinstance(reason, OtherDimension):
                print(f"No figure '{name}': {reason}.")
        except InputError as error:
            errors.append(str(error))
    return errors


def _draw(name: str, run: Run, view: windows.View, folder: Path,
          options: Namespace) -> Optional[Path]:
    module, file = FIGURES[name]
    if options.figures is None and not run.has(file):
        raise NothingToShow(f"the run has no {file}")
    path = folder / f"{name}.png"
    try:
        return style.save(module.draw(run, view), path, options.dpi)
    except OSError as error:
        raise InputError(f"{path} cannot be written ({error}). Choose another place with "
                         "--output.") from error


def _make_folder(folder: Path) -> Path:
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder} cannot be made ({error}). Choose another place with "
                         "--output.") from error
    return folder


def _print_summary(run: Run) -> None:
    """The table of the run's events, if it has a sound one."""
    try:
        if not run.has("events.csv"):
            return
        rows = boxes.summary(run)
        count = style.counted(len(run.events), "event")
    except InputError:
        return
    unfinished = len(run.events) - len(run.complete_events)
    last = "the last of them " if len(run.events) > 1 else ""
    remark = f", {last}cut off by the end of the run" if unfinished else ""
    print(f"\n{count[0].upper()}{count[1:]}{remark}.{with_space(run)}")
    if rows:
        print(f"{'':<17}{'number':>7}{'quartile':>14}{'median':>14}{'quartile':>14}")
    for name, count, low, median, high in rows:
        print(f"{name:<17}{count:>7}{low:>14}{median:>14}{high:>14}")


def with_space(run: Run) -> str:
    return f" {run.selection}" if run.selection else ""


def _status(errors: List[str]) -> int:
    for message in dict.fromkeys(errors):
        print(f"asperity-plot: {message}", file=sys.stderr)
    return 2 if errors else 0
