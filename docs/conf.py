"""Sphinx's settings for the manual: `cmake --build build --target manual`.

Equations become MathML, which needs neither a network nor a script. The API comes from Doxygen by
Breathe, where CMake says that it has both.
"""

import inspect
import os
import re

from docutils import nodes
from docutils.utils.math import latex2mathml

project = "Asperity"
copyright = author = "the authors of Asperity"  # pylint: disable=redefined-builtin
version = release = os.environ.get("ASPERITY_VERSION", "")

extensions = ["myst_parser", "breathe"]
breathe_projects = {"asperity": os.environ.get("ASPERITY_DOXYGEN_XML", "")}
breathe_default_project = "asperity"
myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 4
suppress_warnings = ["myst.strikethrough"]
exclude_patterns = ["figures"]
nitpicky = False
smartquotes = False  # --option stays what a user can copy
highlight_language = "none"

html_theme = "furo"
html_title = f"Asperity {version}".strip()
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_show_sphinx = html_show_copyright = False
html_copy_source = False
html_math_renderer = "mathml"


def mathml(tex, is_inline):
    """The element <math> of a formula; other versions of docutils call the argument otherwise."""
    if "inline" in inspect.signature(latex2mathml.tex2mathml).parameters:
        return with_bold_letters(latex2mathml.tex2mathml(tex, inline=is_inline))
    return with_bold_letters(latex2mathml.tex2mathml(tex, as_block=not is_inline))


def with_bold_letters(formula):
    """Bold letters of Unicode where MathML has an attribute, which browsers follow no more."""
    def bold(letter):
        for first, last, place in (("A", "Z", 0x1D400), ("a", "z", 0x1D41A), ("0", "9", 0x1D7CE)):
            if first <= letter <= last:
                return chr(place + ord(letter) - ord(first))
        return letter
    formula = re.sub(r'<mstyle mathvariant="bold">\s*<(m[ino])>([^<]*)</m[ino]>\s*</mstyle>',
                     r'<\1 mathvariant="bold">\2</\1>', formula)
    return re.sub(r'<(m[ino]) mathvariant="bold">([^<]*)<',
                  lambda found: f"<{found[1]}>{''.join(map(bold, found[2]))}<", formula)


def visit_math(translator, node):
    translator.body.append(f'<span class="math">{mathml(node.astext(), True)}</span>')
    raise nodes.SkipNode


def visit_math_block(translator, node):
    number = f'<span class="eqno">({node["number"]})</span>' if node.get("number") else ""
    translator.body.append(f'<div class="math">{mathml(node.astext(), False)}{number}</div>')
    raise nodes.SkipNode


def setup(app):
    app.add_html_math_renderer("mathml", inline_renderers=(visit_math, None),
                               block_renderers=(visit_math_block, None))
