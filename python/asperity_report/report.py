"""Puts the page together."""

import io
from pathlib import Path
from typing import List, Tuple

from asperity.errors import InputError, NoStepYet, NothingToShow
from asperity.log import RunLog
from asperity.run import Run
from asperity.selection import Selection
from asperity_plot import figures, style, windows
from asperity_status.facts import facts

from . import page, provenance, sections

SILENT_AFTER = 1800.0  # [s], as asperity-status
DPI = 110


def report(directory: Path, selection: Selection = Selection()) -> Tuple[str, List[str]]:
    """The page, and what is wrong with single files; InputError if there is no run."""
    run = Run(directory, selection).readable()
    log = RunLog.read(directory / "run.log")
    wrong = list(run.damage.values())
    parts = [("state", "State", sections.summary(facts(directory, SILENT_AFTER))),
             ("model", "Size and resolution", sections.model(log))]
    try:
        view = windows.choose(run, None)
    except NoStepYet as reason:
        parts.append(("events", "Events", page.paragraph(str(reason))))
    except InputError as error:
        wrong.append(str(error))
    else:
        parts.append(("figures", "Figures", _figures(run, view, wrong)))
        if run.has("events.csv"):
            parts.append(("events", "Events", sections.events(run, view, wrong)))
    parts += [("parameters", "Parameters that differ from the defaults", sections.parameters(run)),
              ("solver", "Solver, and where time went", sections.solver(run, log)),
              ("provenance", "Provenance", provenance.section(run, log, wrong))]
    wrong = list(dict.fromkeys(wrong))
    if wrong:
        parts.insert(1, ("wrong", "What is wrong",
                         "\n".join(page.paragraph(each, "wrong") for each in wrong)))
    return page.page(f"Run {directory.resolve().name}", parts), wrong


def _figures(run: Run, view, wrong: List[str]) -> str:
    """All figures that asperity-plot draws of the run, as PNG, and why others are missing."""
    style.use()
    parts, missing = [], []
    for name, (caption, _) in figures.FIGURES.items():
        try:
            parts.append(page.picture(name, caption, _png(figures.draw(name, run, view))))
        except NothingToShow as reason:
            missing.append(f"{name}: {reason}")
        except InputError as error:
            wrong.append(str(error))
    if missing:
        parts.append(page.paragraph(f"Without data here: {'; '.join(missing)}.", "note"))
    return "\n".join(parts)


def _png(figure) -> bytes:
    buffer = io.BytesIO()
    style.save(figure, buffer, DPI)
    return buffer.getvalue()
