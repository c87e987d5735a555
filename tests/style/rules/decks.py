"""A deck in xml/ opens with a comment: what it shows, ranks, run time and the expected result."""

import re
import xml.etree.ElementTree as ElementTree

from . import source

_TOP = re.compile(r"\A(?:<\?xml[^>]*\?>)?\s*<!--(.*?)-->", re.DOTALL)
_NAME = re.compile(r"[a-z0-9_]+\.xml")
WORDS = ["expected", "rank", "run time"]


def check(root):
    decks = list(source.files(root, ["xml"], {".xml"}))
    if not decks:
        return ["xml:1: there is no deck"]
    return [source.breach(root, path, 1, text) for path in decks for text in _breaches(path)]


def _breaches(path):
    if not _NAME.fullmatch(path.name):
        yield "the name is not of the form spring_slider.xml"
    text = path.read_text()
    try:
        deck = ElementTree.fromstring(text)
        if deck.tag != "ParameterList" or deck.get("name") != "Asperity":
            yield "the root is not the list 'Asperity'"
    except ElementTree.ParseError as error:
        yield f"not well-formed: {error}"
    comment = _TOP.match(text)
    if not comment:
        yield "no comment at the top"
        return
    for word in WORDS:
        if word not in comment.group(1).lower():
            yield f"the comment at the top does not give '{word}'"
