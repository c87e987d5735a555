"""The command line of asperity-study."""

import argparse
import json
import os
from pathlib import Path
from typing import List, Optional

from asperity import selection
from asperity.errors import InputError
from asperity.program import DONE, program

SOME_FAILED, STOPPED = 3, 4  # exit status
ENDS = """exit status:
  0   all runs are finished
  2   the study, its deck or the command line is at fault; nothing was computed
  3   some runs failed; the table says which, DIR/runs/*/output.txt why
  4   stopped by a signal; the same command goes on"""


@program("asperity-study")
def main(arguments: Optional[List[str]] = None) -> int:
    options = _parse(arguments)
    from . import of_deck, runner, study  # here, since modules may be missing
    if options.convergence:
        what = of_deck.convergence(options.convergence, runner.find_program(options.program),
                                   options.changes, options.coarser)
    else:
        what = study.read(options.study)
    values = what.runs()
    if options.list:
        if expectation(what, values):
            print(expectation(what, values))
        for number, each in enumerate(values, start=1):
            print(number, *(f"{name}={value}" for name, value in each.items()))
        return DONE
    try:
        return _run(what, values, options)
    except OSError as error:
        raise InputError(f"{error.filename or options.output}: {error.strerror}.") from error


def _run(what, values, options: argparse.Namespace) -> int:
    """Of the study `what`, whose runs have the `values` of its variables."""
    from . import convergence, figure, results, runner, study
    name = f"{options.convergence.stem}_convergence" if options.convergence else options.study.stem
    folder = options.output or Path("results") / name
    chosen = selection.chosen(options)
    results.require_other_names(what)
    jobs = _jobs(what, values, folder)
    team = runner.Runner(runner.find_program(options.program),
                         max(1, options.cores // what.ranks),
                         runner.launcher(what.ranks, options.mpirun),
                         tell=lambda text: print(text, flush=True))
    if expectation(what, values):
        print(expectation(what, values), flush=True)
    team.validate([job for job in jobs if job.state == "waiting"])
    with runner.alone(folder):
        runner.mark_finished(jobs)
        _remember(folder, what, values)
        complete = team.run(jobs)
        table = results.columns(what, jobs, values, chosen)
        for path in results.write(folder, table, chosen):
            print(path)
        print(figure.draw(what, table, folder / "study.png", str(chosen)))
        if complete and what.sampling == study.CONVERGENCE:
            _tell_errors(convergence.parts(what, jobs, values, chosen), folder)
    print(runner.summary(jobs))
    if not complete:
        return STOPPED
    return SOME_FAILED if any(job.state == "failed" for job in jobs) else DONE


def expectation(what, values) -> str:
    """What a study of convergence costs, as far as theory tells: '' where it does not."""
    costs = []
    for each in values:
        factor = 1.0
        for variable in what.variables:
            how = variable.refinement
            if how is None or how.cost is None:
                return ""
            factor *= float(each[variable.name]) ** how.cost
        costs.append(factor)
    return (f"{len(costs)} runs, which together cost about {sum(costs):.3g} times what the deck "
            f"itself does, the dearest {max(costs):.3g} times: cells count by their number, "
            "tolerances and largest steps as if they alone set the steps. Steps that follow the "
            "cells, and solvers that need more of them, cost more.")


def _tell_errors(parts, folder: Path) -> None:
    """Of a study of convergence."""
    from . import convergence_text
    for path in convergence_text.write(folder, parts):
        print(path)
    print(f"\n{convergence_text.text_of(parts)}\n")


def _jobs(what, values, folder: Path):
    from .runner import Job, mark_finished
    digits = max(4, len(str(len(values))))
    jobs = []
    for number, each in enumerate(values, start=1):
        arguments = [str(what.deck)]
        for override in what.overrides(each):
            arguments += ["--set", override]
        jobs.append(Job(number, folder / "runs" / f"{number:0{digits}d}", arguments))
    mark_finished(jobs)
    return jobs


def _remember(folder: Path, what, values) -> None:
    """Writes what the runs of this folder are; InputError if it holds those of another study."""
    text = json.dumps({"deck": str(what.deck.resolve()), "ranks": what.ranks,
                       "runs": [what.overrides(each) for each in values]}, indent=1) + "\n"
    path = folder / "study.json"
    if path.exists() and path.read_text(encoding="utf-8") != text:
        raise InputError(f"{folder} holds the runs of another study, or of this one before it was "
                         "changed. Choose another place with --output, or remove the folder.")
    path.write_text(text, encoding="utf-8")


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="asperity-study", formatter_class=argparse.RawDescriptionHelpFormatter, epilog=ENDS,
        description="Runs a deck with many values side by side, continues what was killed, and "
                    "writes one table and one figure. The same command goes on where it was "
                    "stopped.")
    parser.add_argument("study", metavar="STUDY.xml", type=Path, nargs="?")
    parser.add_argument("--convergence", metavar="DECK.xml", type=Path,
                        help="instead of a study: halves cells, steps by their tolerances, and the "
                             "largest step of this deck, twice each, and tells the errors of its "
                             "events and of arrivals at its receivers")
    parser.add_argument("--coarser", action="store_true",
                        help="with --convergence: doubles them, so that the deck is the finest")
    parser.add_argument("--set", metavar="PATH=VALUE", dest="changes", action="append", default=[],
                        help="with --convergence: replaces a parameter in all runs; repeatable")
    parser.add_argument("--output", metavar="DIR", type=Path,
                        help="where runs and results go (default: results/<name of the study>)")
    parser.add_argument("--cores", metavar="N", type=_count, default=len(os.sched_getaffinity(0)),
                        help="cores to use at a time (default: all of this machine)")
    parser.add_argument("--program", metavar="FILE", type=Path, help="the program asperity")
    parser.add_argument("--mpirun", metavar="COMMAND", default="mpirun",
                        help="starts runs with more than one rank, with its options (default: "
                             "mpirun)")
    selection.add_options(parser)
    parser.add_argument("--list", action="store_true", help="only list the runs, start none")
    options = parser.parse_args(arguments)
    if bool(options.study) == bool(options.convergence):
        parser.error("either STUDY.xml or --convergence DECK.xml is wanted")
    if options.study and (options.coarser or options.changes):
        parser.error("--coarser and --set go with --convergence; a study has Settings")
    return options


def _count(text: str) -> int:
    if not text.isdigit() or int(text) < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is no number of cores")
    return int(text)
