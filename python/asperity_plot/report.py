"""Draws the figures of a run one by one and prints which were drawn."""

from argparse import Namespace
from pathlib import Path
from typing import List

from asperity import selection
from asperity.errors import InputError, NothingToShow, OtherModel
from asperity.journal import Journal
from asperity.program import fail
from asperity.run import Run

from . import event_table, events, figures, style, windows
from .windows import Options


def report(program: str, options: Namespace) -> int:
    """Exit status: 0, or 2 if the input is at fault; the other figures are drawn nevertheless."""
    run = Run(options.directory, selection.chosen(options)).readable()
    _print_failure(run)
    view = windows.choose(run, options.window, _options(options))
    if options.events:
        print(event_table.text(run, view))
    if options.events and not options.figures:
        return 0
    folder = _make_folder(options.output or options.directory / "figures")
    errors = _wrong_files(run, options) + _draw_all(run, view, folder, options)
    if not options.events:
        _print_summary(run)
    return fail(program, *errors)


def _print_failure(run: Run) -> None:
    """Figures of a failed run end early, and files may be incomplete: why it failed comes first."""
    try:
        journal = Journal.read(run.directory)
    except InputError:
        return
    if journal.how == "failed":
        print(f"The run has failed: {journal.message or 'run.log says why.'}")


def _wrong_files(run: Run, options: Namespace) -> List[str]:
    """What is wrong with those that the figures need; events and parameters choose the view."""
    needed = {figures.FIGURES[name][1] for name in options.figures or figures.FIGURES}
    return [text for name, text in run.damage.items()
            if name in needed | {"events.csv", "parameters.xml"}]


def _options(given: Namespace) -> Options:
    return Options(intervals=given.every and tuple(given.every), receivers=given.receivers,
                   references=tuple(given.reference), depths=given.at)


def _draw_all(run: Run, view: windows.View, folder: Path, options: Namespace) -> List[str]:
    """What was wrong with the input of single figures."""
    style.use()
    errors: List[str] = []
    for name in options.figures or figures.FIGURES:
        try:
            figure = figures.draw(name, run, view, bool(options.figures))
            print(style.save(figure, folder / f"{name}.{options.format}", options.dpi,
                             options.format))
        except NothingToShow as reason:
            # that of a call with other options
            (folder / f"{name}.{options.format}").unlink(missing_ok=True)
            if options.figures or not isinstance(reason, OtherModel):
                print(f"No figure '{name}': {reason}.")
        except InputError as error:
            errors.append(str(error))
    return errors


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
        rows = events.summary(run)
        count = style.counted(len(run.events), "event")
    except InputError:
        return
    unfinished = len(run.events) - len(run.complete_events)
    last = "the last of them " if len(run.events) > 1 else ""
    remark = f", {last}cut off by the end of the run" if unfinished else ""
    print(f"\n{count[0].upper()}{count[1:]}{remark}. {run.selection}".rstrip())
    if rows:
        print(f"{'':<17}{'number':>7}{'quartile':>14}{'median':>14}{'quartile':>14}")
    for name, count, low, median, high in rows:
        print(f"{name:<17}{count:>7}{low:>14}{median:>14}{high:>14}")
