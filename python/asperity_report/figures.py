"""All figures that asperity-plot draws of a run, as PNG."""

import io
from typing import List, Tuple

from asperity.errors import InputError, NothingToShow
from asperity.run import Run
from asperity_plot import style
from asperity_plot.cli import FIGURES as CAPTIONS
from asperity_plot.report import FIGURES
from asperity_plot.windows import View

DPI = 110


def draw_all(run: Run, view: View) -> Tuple[List[Tuple[str, str, bytes]], List[str], List[str]]:
    """(name, caption, PNG) of each figure; why others are missing; what is wrong with the run."""
    style.use()
    drawn, missing, wrong = [], [], []
    for name, (module, file) in FIGURES.items():
        if not run.has(file):
            missing.append(f"{name}: the run has no {file}")
            continue
        try:
            drawn.append((name, CAPTIONS[name], _png(module.draw(run, view))))
        except NothingToShow as reason:
            missing.append(f"{name}: {reason}")
        except InputError as error:
            wrong.append(str(error))
    return drawn, missing, list(dict.fromkeys(wrong))


def _png(figure) -> bytes:
    buffer = io.BytesIO()
    figure.savefig(buffer, format="png", dpi=DPI, facecolor="white")
    style.plt.close(figure)
    return buffer.getvalue()
