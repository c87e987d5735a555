#!/usr/bin/env python3
"""Writes the pages of parameters from what the programs say; `--check` compares.

    python3 docs/parameters.py [--check] [PROGRAM]      build/drivers/asperity by default

`asperity --print-parameters` makes docs/reference/parameters.md; `asperity-mesh build
--print-parameters`, of the program beside it if there is one, docs/reference/mesh_parameters.md.
"""

import pathlib
import re
import subprocess
import sys

PAGE = pathlib.Path(__file__).parent / "reference" / "parameters.md"
MESH_PAGE = PAGE.with_name("mesh_parameters.md")
TOP = """# Parameters

All parameters of a deck, in the order in which `asperity --print-parameters` prints them. **This page
is made by `docs/parameters.py`; a test compares it with the program.** Units are SI. A deck is an
XML file of lists; a path such as `Time Stepping / Final Time` is a parameter in the list
`Time Stepping`, and `--set "Time Stepping/Final Time=100"` changes it. Names in `<angle brackets>`
are yours. "field" stands for a number, an expression in `x`, `y`, `z`, `t`, a dataset
`"file.h5:/dataset"` with one value for each vertex, or a list with one entry for each region;
fields of `Friction`, and `Slip Rate` and `alpha` of `Initial State`, also take a list with one
entry for each fault. A "field without dataset" is needed at places that are no vertices.
Laws and outputs of plugins add their own: `asperity --print-parameters --plugin libmine.so`.
"""
MESH_TOP = """# Parameters of meshes

All parameters of a deck of `asperity-mesh build`, in the order in which `asperity-mesh build
--print-parameters` prints them. **This page is made by `docs/parameters.py`; a test compares it with
the program.** Units are SI, and z points up. [Surfaces from files](surfaces.md) explains the lists of
faults and ground, [Bring your fault](../first_model/your_fault.md) has an example. Names in
`<angle brackets>` are yours; a "field without dataset" is a number or an expression in x, y, z.
"""
FIELD = 'a number, an expression in x, y, z, t, "file.h5:/dataset" or a list of regions'
WITHOUT_DATASET = FIELD.replace(', "file.h5:/dataset"', "")
HEADING, NOTHING = "\n## ", "There is nothing to set.\n"
ENTRY = re.compile(
    r"(?P<allowed>.*?); (?:(?P<need>required|optional)|default (?P<default>.*?))\."
    r"(?: Unit: (?P<unit>.+?)\.(?= |$))?(?: (?P<text>.*))?")


def page(printed: str, top: str = TOP) -> str:
    parts, remark, table = [top], "", False
    lines = iter(printed.splitlines()[1:])  # without the root
    for line in lines:
        if line.startswith("# "):
            remark = line[2:]
        elif line.startswith("Asperity /"):
            if parts[-1].startswith(HEADING):
                parts.append(NOTHING)
            path = line[len("Asperity / "):].split(", with ")
            parts.append(f"{HEADING}{path[0].replace('<', '&lt;')}"
                         + (f", with {path[1]}" if len(path) > 1 else "") + "\n")
            if remark:
                parts.append(escaped(remark) + "\n")
            remark, table = "", False
        elif line.startswith("  ") and line.strip():
            if not table:
                parts += ["| name | allowed | default | unit | meaning |", "|---|---|---|---|---|"]
                table = True
            parts.append(row(line.strip(), next(lines).strip()))
    if parts[-1].startswith(HEADING):
        parts.append(NOTHING)
    return "\n".join(parts) + "\n"


def row(name: str, text: str) -> str:
    """A line of the table; ValueError where the program prints another form."""
    found = ENTRY.fullmatch(text)
    if not found:
        raise ValueError(f"'{name}': the text '{text}' has not the form that this script knows.")
    allowed = found["allowed"].replace(FIELD, "field")
    allowed = allowed.replace(WITHOUT_DATASET, "field without dataset")
    unit = found["unit"] or ""
    if unit and allowed.endswith(" " + unit):
        allowed = allowed[:-len(unit) - 1]
    default = f"`{found['default']}`" if found["default"] is not None else found["need"]
    unit = "" if unit == "1" else unit
    cells = [f"`{name}`", escaped(allowed), default, escaped(unit), escaped(found["text"] or "")]
    return f"| {' | '.join(cells)} |"


def escaped(text: str) -> str:
    for letter in "|<*_":
        text = text.replace(letter, "\\" + letter)
    return text


def compare(path, text, program):
    """The exit status: 1 if the page is not the text."""
    old = path.read_text(encoding="utf-8").splitlines() if path.exists() else []
    for number, (is_there, wanted) in enumerate(zip(old + [""] * len(text), text.splitlines()), 1):
        if is_there != wanted:
            print(f"docs/reference/{path.name}:{number}: is not what the program says. Run "
                  f"python3 docs/parameters.py {program}\n  page:    {is_there}\n"
                  f"  program: {wanted}")
            return 1
    return int(len(old) != len(text.splitlines()))


def main(arguments):
    check = "--check" in arguments
    rest = [word for word in arguments if word != "--check"]
    program = rest[0] if rest else "build/drivers/asperity"
    mesh_tool = pathlib.Path(program).with_name("asperity-mesh")
    pages = [(PAGE, TOP, [program])]
    if mesh_tool.exists():
        pages.append((MESH_PAGE, MESH_TOP, [mesh_tool, "build"]))
    status = 0
    for path, top, command in pages:
        printed = subprocess.run([*command, "--print-parameters"], check=True, capture_output=True,
                                 text=True).stdout
        text = page(printed, top)
        if check:
            status = status or compare(path, text, program)
        else:
            path.write_text(text, encoding="utf-8")
    return status


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
