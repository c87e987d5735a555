"""One table of all runs: what varied, what happened, what it cost; as CSV and HDF5."""

import csv
import io
from pathlib import Path
from typing import Dict, List, Tuple

import h5py
import numpy as np

from asperity.errors import InputError
from asperity.journal import Journal
from asperity.run import Run
from asperity.selection import Selection
from asperity_plot import events

from .runner import Job
from .study import Study

QUARTILES = ((25, "lower_quartile"), (50, "median"), (75, "upper_quartile"))
COSTS = ("coupled_steps", "rate_problems", "tnnmg_iterations", "v_cycles", "failed_steps")
NAMES = {"run", "state", "starts", "events", "complete_events", "time", "steps", *COSTS,
         "wall_time", "warnings",
         *(f"{name}_{word}" for _, name, _ in events.QUANTITIES + events.SIZES
           for _, word in QUARTILES)}  # of columns that are no variables

Column = Tuple[str, str, List]  # name, unit, a value for each run


def require_other_names(study: Study) -> None:
    """InputError where a variable has the name of another column."""
    for variable in study.variables:
        if variable.name in NAMES:
            raise InputError(f"Variables: '{variable.name}' is the name of another column of "
                             "results.csv. Choose another name for this variable.")


def columns(study: Study, jobs: List[Job], values: List[Dict[str, str]],
            selection: Selection = Selection()) -> List[Column]:
    """The columns of the table, for the events that count; nan where a run has no value."""
    rows = [_row(job, selection) for job in jobs]
    table: List[Column] = [("run", "", [job.number for job in jobs])]
    table += [(variable.name, variable.unit, [_value(each[variable.name]) for each in values])
              for variable in study.variables]
    table += [("state", "", [job.state for job in jobs]),
              ("starts", "", [job.starts for job in jobs])]
    for key in list(dict.fromkeys(key for row in rows for key in row)):
        table.append((*key, [row.get(key, float("nan")) for row in rows]))
    return table


def _value(text: str):
    """A number if the whole text is one, otherwise the text."""
    try:
        return float(text)
    except ValueError:
        return text


def _row(job: Job, selection: Selection) -> Dict[Tuple[str, str], float]:
    row: Dict[Tuple[str, str], float] = {}
    try:
        run = Run(job.folder, selection)
        if run.has("events.csv"):
            row["events", ""] = len(run.events)
            row["complete_events", ""] = len(run.complete_events)
            samples = events.samples(run)
            for _, name, unit in events.quantities(run):
                for percent, word in QUARTILES:
                    found = samples[name]
                    row[f"{name}_{word}", unit] = float(np.percentile(found, percent)) \
                        if found.size else float("nan")
        if run.has("steps.csv") and len(run.steps):
            row["time", "s"] = float(run.steps["time"][-1])
            row["steps", ""] = len(run.steps)
            row.update({(name, ""): int(run.steps[name].sum()) for name in COSTS
                        if name in run.steps})
        journal = Journal.read(job.folder)
        row["wall_time", "s"] = np.nan if journal.wall_time is None else journal.wall_time
        row["warnings", ""] = job.warnings = len(journal.warnings)
    except InputError as error:
        job.message = job.message or str(error)
    return row


def write(folder: Path, table: List[Column], selection: Selection = Selection()) -> List[Path]:
    """results.csv and results.h5, each replaced as a whole."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    writer.writerow([f"{name} [{unit}]" if unit else name for name, unit, _ in table])
    writer.writerows(zip(*([_cell(value) for value in values] for _, _, values in table)))
    paths = [folder / "results.csv", folder / "results.h5"]
    replace(paths[0], lambda path: path.write_text(text.getvalue(), encoding="utf-8"))
    replace(paths[1], lambda path: _write_h5(path, table, selection))
    return paths


def _cell(value) -> str:
    return repr(value) if isinstance(value, float) else str(value)


def _write_h5(path: Path, table: List[Column], selection: Selection) -> None:
    with h5py.File(path, "w") as file:
        file.attrs["format"] = "asperity study"
        file.attrs["selection"] = str(selection)
        for number, (name, unit, values) in enumerate(table):
            is_text = any(isinstance(value, str) for value in values)
            data = [str(value) for value in values] if is_text else np.array(values)
            entry = file.create_dataset(name.replace("/", " "), data=data,
                                        dtype=h5py.string_dtype() if is_text else None)
            entry.attrs["unit"] = unit
            entry.attrs["column"] = number


def replace(path: Path, write_to) -> None:
    """With what `write_to` writes, as a whole."""
    temporary = path.with_name(path.name + ".new")
    write_to(temporary)
    temporary.replace(path)
