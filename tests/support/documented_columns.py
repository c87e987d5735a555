"""The columns of tables that docs/reference/outputs.md lists, against those that a run writes."""

import csv
import re

import asperity_run

PAGE = asperity_run.SOURCE / "docs" / "reference" / "outputs.md"
SECTION = re.compile(r"^## (\w+\.csv)\n(.*?)(?=^## |\Z)", re.MULTILINE | re.DOTALL)
ROW = re.compile(r"^\| (`.*?) \| (.*) \|$", re.MULTILINE)
OF_ONE_FAULT = re.compile(r"events_.+\.csv")


def documented(dimension):
    """{file: columns} of models of this dimension. A row of a page's table names one or more
    columns, or those from one "to" another of steps.csv; its meaning may begin with "2D:" or
    "3D:"."""
    other = {2: "3D:", 3: "2D:"}[dimension]
    rows = {name: [names for names, meaning in ROW.findall(text) if not meaning.startswith(other)]
            for name, text in SECTION.findall(PAGE.read_text(encoding="utf-8"))}
    of_steps = [name for names in rows["steps.csv"] for name in re.findall(r"`(\w+)`", names)]

    def columns(names):
        found = re.findall(r"`(\w+)`", names)
        if " to " not in names:
            return found
        first, last = (of_steps.index(name) for name in found)
        return of_steps[first:last + 1]

    return {name: [column for names in of_file for column in columns(names)]
            for name, of_file in rows.items()}


def written(file_name):
    """The columns of a .csv file without their units."""
    with open(file_name, newline="", encoding="utf-8") as file:
        return [name.split(" [")[0] for name in next(csv.reader(file))]


def assert_documented(test, folder, dimension, without=()):
    """The run has all tables of the manual, with all their columns but those `without`, in this
    order, and neither other tables nor other columns. A table of one of several faults has no
    energies."""
    expected = documented(dimension)
    for columns in expected.values():
        test.assertGreater(len(columns), 3)
    names = {path.name for path in folder.glob("*.csv")}
    for name in filter(OF_ONE_FAULT.fullmatch, names):
        expected[name] = [column for column in expected["events.csv"]
                          if column not in expected["steps.csv"] or column == "peak_slip_rate"]
    test.assertEqual(names, set(expected))
    for name, columns in expected.items():
        test.assertEqual(written(folder / name),
                         [column for column in columns if column not in without], name)
