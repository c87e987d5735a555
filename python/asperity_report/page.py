"""Pieces of a page of HTML that needs nothing but itself."""

import base64
from html import escape
from typing import List, Sequence

STYLE = """
body{font:15px/1.5 "DejaVu Sans",Verdana,sans-serif;color:#333;max-width:60em;margin:2em auto;
padding:0 1em}
h1{font-size:1.6em}h2{font-size:1.25em;border-bottom:1px solid #bbb;margin-top:2em}
table{border-collapse:collapse;font-size:.85em;margin:1em 0;display:block;overflow-x:auto}
th,td{padding:.2em .45em;text-align:right;border-bottom:1px solid #ddd;vertical-align:top}
td:first-child,th:first-child{text-align:left}th{background:#f2f2f2}
.words td,.words th{text-align:left}.words td:last-child{overflow-wrap:anywhere}
.words td:first-child{overflow-wrap:normal;min-width:14em}
img{max-width:100%;border:1px solid #ddd}nav a{margin-right:1em}
p.note{color:#666;font-size:.85em}p.wrong{color:#a03018}
@media print{nav{display:none}h2{break-after:avoid}img{break-inside:avoid}}
"""


def paragraph(text: str, kind: str = "") -> str:
    mark = f' class="{kind}"' if kind else ""
    return f"<p{mark}>{escape(text)}</p>"


def table(header: Sequence[str], rows: Sequence[Sequence[str]], words: bool = False) -> str:
    """Numbers stand on the right; with `words` all stands on the left."""
    def line(cells: Sequence[str], tag: str) -> str:
        texts = (escape(str(cell)) for cell in cells)
        if words:  # paths break between their parts
            texts = (text.replace("/", "/<wbr>") for text in texts)
        return "<tr>" + "".join(f"<{tag}>{text}</{tag}>" for text in texts) + "</tr>"
    mark = ' class="words"' if words else ""
    body = "\n".join(line(row, "td") for row in rows)
    return f"<table{mark}>\n{line(header, 'th')}\n{body}\n</table>"


def picture(name: str, caption: str, png: bytes) -> str:
    """A PNG within the page."""
    data = base64.b64encode(png).decode("ascii")
    return (f'<p><img id="{escape(name)}" alt="{escape(caption)}" '
            f'src="data:image/png;base64,{data}"></p>\n' + paragraph(f"{name}: {caption}.", "note"))


def page(title: str, sections: List[tuple]) -> str:
    """The whole of it; a section is (id, heading, HTML)."""
    links = " ".join(f'<a href="#{key}">{escape(heading)}</a>' for key, heading, _ in sections)
    body = "\n".join(f'<h2 id="{key}">{escape(heading)}</h2>\n{content}'
                     for key, heading, content in sections)
    return (f'<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
            f"<title>{escape(title)}</title>\n<style>{STYLE}</style>\n</head>\n<body>\n"
            f"<h1>{escape(title)}</h1>\n<nav>{links}</nav>\n{body}\n</body>\n</html>\n")
