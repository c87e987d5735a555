#!/usr/bin/env python3
"""Gathers the numbers of docs/validation from runs, and writes its tables.

    collect.py RESULTS_DIR             reads the runs RESULTS_DIR/<case>, writes values.json, tables
    collect.py                         writes the tables anew from values.json
    collect.py --check                 compares pages and values.json; status 1 where they differ
    collect.py --commands RESULTS_DIR  prints the commands of the runs, with minutes on a core

A run is left out, with status 1, if it has not finished, has other settings than its case, or if
J rose in it. Entries of cases without a run stay. Cases are in benchmark_cases.py, zone_cases.py.
"""

import argparse
import json
import math
import pathlib
import sys

import benchmark_cases
import pages
import zone_cases
from tree import SOURCE

import asperity
from asperity.journal import Journal
from asperity.parameters import Parameters

CASES = benchmark_cases.CASES + zone_cases.CASES
PAGES = SOURCE / "docs" / "validation"
COLUMNS = {"coupled steps": "coupled_steps", "rate problems": "rate_problems",
           "TNNMG iterations": "tnnmg_iterations"}
DIGITS = 10  # of values in values.json


class Refused(Exception):
    """A run that is not that of its case; the message says why."""


def entry_of(case, folder):
    """What values.json has of a run; Refused, or an InputError where files are missing."""
    run = asperity.Run(folder)
    journal = Journal.read(folder)
    if journal.how != "finished":
        raise Refused("the run has not finished")
    difference = first_difference(case, run)
    if difference:
        raise Refused(difference)
    rises = int(run.steps["energy_increases"].sum())
    if rises:
        raise Refused(f"J rose {rises} times")
    steps = {"accepted steps": len(run.steps)}
    steps.update({name: int(run.steps[column].sum()) for name, column in COLUMNS.items()})
    rows = [{"quantity": quantity.name, "value": value_of(quantity, run)}
            for quantity in case.quantities]
    return {"source": " ".join(journal.log.environment[0].split()[:2]), "steps": steps,
            "quantities": rows}


def value_of(quantity, run):
    """None where the run has too few events for it."""
    try:
        value = quantity.read(run)
    except IndexError:
        return None
    if isinstance(value, int):
        return value
    return float(f"{value:.{DIGITS}g}") if math.isfinite(value) else None


def first_difference(case, run):
    """Between the run and the deck with the settings of the case, '' if there is none. Numbers
    alone are compared, settings, and what is the name of a setting; a mesh may have any name."""
    expected = Parameters.read(SOURCE / "xml" / f"{case.deck_name}.xml")
    settings = dict(setting.split("=", 1) for setting in case.settings)
    names = {path[len("Names/"):]: settings.pop(path)
             for path in list(settings) if path.startswith("Names/")}
    wanted = {path: names.get(expected.text(path), expected.text(path))
              for path in expected.paths() if not path.startswith(("Names/", *case.removed))
              and (expected.number(path) is not None or expected.text(path) in names)}
    wanted.update(settings)
    for path, text in wanted.items():
        found = run.parameters.text(path)
        if path != "Mesh/File/File Name" and not same(text, found):
            return f"'{path}' is {found} and not {text}"
    return ""


def same(text, found):
    try:
        return float(text) == float(found)
    except (TypeError, ValueError):
        return found is not None and "".join(text.split()) == "".join(found.split())


def collect(results, cases, entries):
    """Puts what lies in the folder into the entries; how many runs were left out."""
    left_out = 0
    for case in cases:
        folder = results / case.name
        if not folder.is_dir():
            continue
        try:
            entries[case.name] = entry_of(case, folder)
            print(f"{case.name}: collected")
        except (Refused, asperity.InputError) as error:
            print(f"{case.name}: left out, {error}", file=sys.stderr)
            left_out += 1
    return left_out


def completed(cases, entries):
    """The entries in the order of the cases, with what these know: unit and reference."""
    result = {}
    for case in cases:
        if case.name not in entries:
            continue
        values = values_of(entries, case.name)
        others = values_of(entries, case.against)
        rows = [{"quantity": quantity.name, "unit": quantity.unit,
                 "reference": quantity.reference if quantity.reference is not None
                 else others.get(quantity.name), "value": values[quantity.name]}
                for quantity in case.quantities if quantity.name in values]
        result[case.name] = {**entries[case.name], "quantities": rows}
    return result


def values_of(entries, name):
    rows = entries.get(name, {"quantities": []})["quantities"]
    return {row["quantity"]: row["value"] for row in rows}


def json_text(entries):
    """A line for each quantity, so that changes are easy to read."""
    parts = []
    for name, entry in entries.items():
        rows = ",\n".join(f"      {json.dumps(row)}" for row in entry["quantities"])
        parts.append(f'  {json.dumps(name)}: {{\n    "source": {json.dumps(entry["source"])},\n'
                     f'    "steps": {json.dumps(entry["steps"])},\n'
                     f'    "quantities": [\n{rows}\n    ]\n  }}')
    return "{\n" + ",\n".join(parts) + "\n}\n"


def texts(folder, cases, entries):
    """{path: what should stand there} of values.json and the pages."""
    entries = completed(cases, entries)
    result = {folder / "values.json": json_text(entries)}
    for page in sorted(folder.glob("*.md")):
        result[page] = pages.rewritten(page.read_text(encoding="utf-8"), cases, entries)
    return result


def read_entries(folder):
    path = folder / "values.json"
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def check(folder, cases):
    """The files that differ from what would be written, and cases without a table."""
    found = [f"{path.name} is not what values.json and the cases say: run collect.py"
             for path, text in texts(folder, cases, read_entries(folder)).items()
             if not path.exists() or path.read_text(encoding="utf-8") != text]
    shown = {name for page in folder.glob("*.md")
             for _, name, _ in pages.BLOCK.findall(page.read_text(encoding="utf-8"))}
    return found + [f"no page has a table of {case.name}" for case in cases
                    if case.has_table and case.name not in shown]


def main(arguments, cases=CASES):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("results", nargs="?", type=pathlib.Path, metavar="RESULTS_DIR")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--commands", action="store_true")
    parser.add_argument("--pages", type=pathlib.Path, default=PAGES, help="instead of %(default)s")
    options = parser.parse_args(arguments)
    if options.check:
        found = check(options.pages, cases)
        print("\n".join(found) or "pages and values agree")
        return 1 if found else 0
    entries = read_entries(options.pages)
    if options.commands:
        for case in cases:
            source = entries.get(case.name, {"source": "none"})["source"]
            print(f"# {case.minutes:g} min; values so far: {source}")
            print(case.commands(options.results or "results"))
        return 0
    left_out = collect(options.results, cases, entries) if options.results else 0
    for path, text in texts(options.pages, cases, entries).items():
        path.write_text(text, encoding="utf-8")
    return 1 if left_out else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
