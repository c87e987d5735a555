#!/usr/bin/env python3
"""Every parameter's text is a sentence that says what the parameter does, and a number has a unit.

Reads what `asperity --print-parameters --format=xml` prints; `parameter_texts.py [PROGRAM]`.
"""

import os
import pathlib
import re
import subprocess
import sys

SHORTEST = 4  # words

# One of these forms is in every sentence; add the verb that a new text uses.
VERBS = set("""
    is are has have may
    absorbs accelerates accepts adapts adds allows applies balances bears begins bounds ceases
    chooses continues controls counts decays defines delays demands depends describes differs
    divides ends exceeds extends extrapolates falls fills fits flows follows gets give gives grow
    grows heats holds keeps knows lasts lies make makes maps means moves multiplies names needs
    passes points puts reaches reads receives refuses rejects removes repeats replaces resists say
    says selects sets solves spreads starts stops switches takes uses writes yields
    """.split())

# What PrintParameters.cpp writes before the meaning: what is allowed, default and unit.
_PARAMETER = re.compile(
    r"(?P<allowed>.*?); (?:required|optional|default .*?)\.(?: Unit: (?P<unit>.+?)\.)?"
    r"(?: (?P<text>.*))?")
_START = re.compile(r"(?:a|an) (?:number|integer|text|array|list)|one of|true or false|the name of")
_NUMBER = re.compile(r"(?:a number|an array of numbers)\b")


def entries(printed):
    """(name, comment) of all parameters and lists, those of lists in comments included."""
    comment, owner = None, None
    lines = iter(printed.splitlines()[1:])  # without the root
    for line in lines:
        text = line.strip()
        if text.startswith("<!-- A list with any number"):
            yield next(lines).strip(), comment  # the list that the comment before describes
            comment = None
        elif text.startswith("<!-- <Parameter") or text.startswith("<Parameter"):
            yield re.search(r'name="([^"]*)"', text).group(1), comment
            comment = None
        elif text.startswith("<!--"):
            comment = text.removeprefix("<!--").removesuffix("-->").strip()
        elif text.startswith("#"):
            comment = text.removeprefix("#").strip()
        elif text and not text.startswith("-->") and _START.match(text):
            yield owner, text
        elif text and not text.startswith("-->"):
            if comment:
                yield text, comment
            comment, owner = None, text


def breaches(printed):
    """What is wrong, one line each."""
    found = list(entries(printed))
    texts = [f"{name}: {problem}" for name, comment in found for problem in _problems(comment)]
    return texts if found else ["no parameter was found"]


def _problems(comment):
    if comment is None:
        yield "there is no text"
        return
    parts = _PARAMETER.fullmatch(comment) if _START.match(comment) else None
    text = (parts.group("text") or "") if parts else comment
    if parts and _NUMBER.match(comment) and not parts.group("unit") and not _is_direction(text):
        yield f"a number without a unit: '{comment}'"
    if text.startswith("For ") and " = " in text:  # "For Type = Wedge.", written by the program
        return
    words = re.findall(r"[A-Za-z'-]+", text)
    if len(words) < SHORTEST:
        yield f"less than {SHORTEST} words: '{text}'"
    elif not VERBS & {word.lower() for word in words}:
        yield f"no verb that this test knows: '{text}'"
    if not text.endswith("."):
        yield f"no full stop: '{text}'"
    if not text[:1].isupper():
        yield f"no capital at the beginning: '{text}'"


# Vectors of any length have no unit, and say so.
def _is_direction(text):
    return re.search("any length|length (of the vector )?has no effect", text)


def main(arguments):
    build = pathlib.Path(os.environ.get("ASPERITY_BUILD_DIR", "build"))
    program = arguments[0] if arguments else build / "drivers" / "asperity"
    printed = subprocess.run([program, "--print-parameters", "--format=xml"], check=True,
                             capture_output=True, text=True).stdout
    found = breaches(printed)
    print(*found, sep="\n")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
