"""Reads a page of HTML as a browser would, and says what it would fetch."""

import re
from html.parser import HTMLParser

VOID = {"meta", "img", "br", "hr", "link", "input", "col", "wbr"}
REFERENCES = {"src", "href", "srcset", "data", "poster", "action", "background", "cite", "ping"}


class Page(HTMLParser):
    """Its text, its tables as rows of cells, its references; ValueError unless tags match."""

    def __init__(self, text: str):
        super().__init__()
        self.references, self.scripts, self.images, self.headings = [], 0, [], []
        self.rows, self._open, self._cell = [], [], None
        self.ids, self.text = set(), []
        self.feed(text)
        self.close()
        if self._open:
            raise ValueError(f"not closed: {self._open}")
        self.references += re.findall(r"url\(([^)]*)\)|@import\s+(\S+)", text)

    def handle_starttag(self, tag, attrs):
        attributes = dict(attrs)
        self.scripts += tag == "script" or any(name.startswith("on") for name in attributes)
        self.references += [value for name, value in attrs if name in REFERENCES]
        self.ids.update([attributes["id"]] if "id" in attributes else [])
        if tag == "img":
            self.images.append(attributes)
        if tag == "tr":
            self.rows.append([])
        if tag in ("td", "th"):
            self._cell = ""
        if tag not in VOID:
            self._open.append(tag)

    def handle_endtag(self, tag):
        if not self._open or self._open.pop() != tag:
            raise ValueError(f"</{tag}> closes nothing")
        if tag in ("td", "th"):
            self.rows[-1].append(self._cell.strip())
            self._cell = None

    def handle_data(self, data):
        if self._cell is not None:
            self._cell += data
        if self._open and self._open[-1] in ("h1", "h2"):
            self.headings.append(data)
        self.text.append(data)

    def external(self):
        """References that are neither in the page nor to a place in it."""
        return [reference for reference in self.references
                if not str(reference).startswith(("data:", "#"))]
