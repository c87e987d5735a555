"""Tables of docs/validation: what stands between <!-- values: CASE --> and <!-- end -->."""

import re

BLOCK = re.compile(r"(<!-- values: (\S+) -->\n).*?(<!-- end -->)", re.DOTALL)
FORMS = {"yr": ".2f", "s": ".3f", "m": ".3f", "mm": ".4f", "MPa": ".2f", "m/s": ".4g",
         "mm/s": ".4f", "km": ".0f"}
SMALL = 5e-5  # a relative difference that has no digits as a percentage
STEPS = ("accepted steps", "coupled steps", "rate problems", "TNNMG iterations")


def rewritten(text, cases, entries):
    """The page with new blocks; ValueError where a block is of no case."""
    known = {case.name: case for case in cases}

    def block(found):
        if found[2] == "index":
            content = index(cases, entries)
        elif found[2] in known:
            content = of_case(known[found[2]], known, entries)
        else:
            raise ValueError(f"there is no case '{found[2]}'")
        return f"{found[1]}\n{content}\n\n{found[3]}"

    return BLOCK.sub(block, text)


def of_case(case, known, entries):
    """Commands, table and effort of a case."""
    other = known.get(case.against)
    commands = [other.commands()] if other and not other.has_table else []
    code = "\n".join([*commands, case.commands()])
    parts = ["\n".join(f"    {line}" for line in code.split("\n"))]
    entry = entries.get(case.name)
    if not entry:
        return "\n\n".join([*parts, "Not collected yet."])
    rows = [(quantity, row) for quantity, row in _rows(case, entry)]
    if any(row["reference"] is not None for _, row in rows):
        lines = ["| quantity | reference | Asperity | difference |", "|---|---|---|---|"]
        lines += [_line(_label(quantity), *_numbers(quantity, case, row)) for quantity, row in rows]
    else:
        lines = ["| quantity | Asperity |", "|---|---|"]
        lines += [_line(_label(quantity), _text(row["value"], quantity)) for quantity, row in rows]
    parts.append("\n".join(lines))
    steps = [f"{entry['steps'][name]:,} {name}" for name in STEPS if name in entry["steps"]]
    if steps:
        parts.append(f"The run takes {', '.join(steps)}.")
    return "\n\n".join(parts)


def index(cases, entries):
    lines = ["| case | quantity | reference | reference value | Asperity | difference |",
             "|---|---|---|---|---|---|"]
    for case in cases:
        for quantity, row in _rows(case, entries.get(case.name, {"quantities": []})):
            if quantity.name in case.in_index:
                lines.append(_line(f"[{case.title}]({case.page}.md)", _label(quantity),
                                   case.source, *_numbers(quantity, case, row)))
    return "\n".join(lines)


def _rows(case, entry):
    """The quantities of the case that were collected, with what values.json has of them."""
    by_name = {row["quantity"]: row for row in entry["quantities"]}
    return [(quantity, by_name[quantity.name]) for quantity in case.quantities
            if quantity.name in by_name]


def _line(*cells):
    return "| " + " | ".join(cells) + " |"


def _label(quantity):
    return f"{quantity.name} [{quantity.unit}]" if quantity.unit else quantity.name


def _numbers(quantity, case, row):
    """Reference, value and difference as texts."""
    value, reference = row["value"], row["reference"]
    if reference is None:
        return "", _text(value, quantity), ""
    if isinstance(reference, (list, tuple)):
        shown = f"{reference[0]:.10g} to {reference[1]:.10g}"
    elif quantity.reference is None and case.against:
        shown = _text(reference, quantity)
    else:
        shown = f"{reference:.10g}"
    return shown, _text(value, quantity), difference(value, reference, quantity)


def _text(value, quantity):
    if value is None:
        return "none"
    form = quantity.form or FORMS.get(quantity.unit, "d" if isinstance(value, int) else ".1e")
    return format(value, form)


def difference(value, reference, quantity):
    """Relative, of whole numbers and of those whose reference is 0 absolute."""
    if value is None:
        return ""
    if isinstance(reference, (list, tuple)):
        least, most = reference
        if least <= value <= most:
            return "within"
        reference = least if value < least else most
    if reference == 0:
        return _text(value, quantity)
    if isinstance(value, int) and not quantity.unit:
        return f"{value - reference:+d}"
    relative = value / reference - 1
    if quantity.reference is None and abs(relative) < SMALL:  # of another run of Asperity
        return f"{relative:+.0e}" if relative else "0"
    percent = f"{100 * relative:+.2f}"
    return f"{percent} %" if float(percent) else "0.00 %"
