"""Fixed point iterations and step size over time, and the one over the other."""

import numpy as np
from matplotlib.axes import Axes
from matplotlib.ticker import MaxNLocator

from asperity.errors import NothingToShow
from asperity.run import Run
from asperity.tables import Table

from . import maps, style, units
from .windows import View

COLUMN = "fixed_point_iterations"


def draw(run: Run, view: View):
    """The figure; NothingToShow if no step was accepted."""
    steps = run.steps
    iterations = steps[COLUMN]
    if not len(steps):
        raise NothingToShow("the run has accepted no step")
    zoomed = view.zoom is not None
    widths = [1.35, 1.0, 0.9] if zoomed else [1.6, 0.9]
    figure, axes = style.panels(2, len(widths), (11.0, 5.2), sharex="col", sharey="row",
                                gridspec_kw={"width_ratios": widths, "height_ratios": [1.2, 1.0]})
    _over_time(axes[:, 0], steps, view.cycles, 0.0, maps.cycles_unit(view))
    maps.label_cycles(axes[0, 0], view, axes[1, 0])
    if zoomed:
        _zoom(axes[:, 1], steps, view)
    _step_sizes(axes[:, -1], steps)
    axes[0, 0].set_ylabel("Step size [s]")
    axes[1, 0].set_ylabel("Fixed point iterations\nper step")
    axes[1, 0].set_ylim(0.0, 1.08 * max(units.largest(iterations), 1.0))
    axes[1, 0].yaxis.set_major_locator(MaxNLocator(nbins=6, integer=True))
    style.title(figure, "Fixed point iterations and adaptive step size")
    return figure


def _over_time(axes, steps: Table, window, origin: float, unit: units.Unit) -> None:
    """Step size (above) and iterations (below) of the steps in `window`."""
    time = steps["time"]
    first = max(int(np.searchsorted(time, window[0])) - 1, 0)
    rows = slice(first, int(np.searchsorted(time, window[1], side="right")) + 1)
    shown = unit(time[rows] - origin)
    axes[0].set_yscale("log")
    axes[0].plot(shown, steps["step_size"][rows], drawstyle="steps-pre", color=style.BLUE)
    many = shown.size > 300
    axes[1].plot(shown, steps[COLUMN][rows], ".", color=style.ORANGE, rasterized=True,
                 markersize=3.5 if many else 5.0, alpha=0.5 if many else 0.9,
                 markeredgewidth=0.0)
    for panel in axes:
        panel.grid(axis="y")
        panel.set_axisbelow(True)


def _zoom(axes, steps: Table, view: View) -> None:
    unit = maps.zoom_unit(view)
    _over_time(axes, steps, view.zoom, view.onset, unit)
    maps.label_zoom(axes[0], view, axes[1])
    axes[0].set_title(f"Zoom into event {view.number} (▾, grey)")
    for panel in axes:
        panel.axvspan(0.0, float(unit(view.end - view.onset)), color="#eeeeee", zorder=0)


def _step_sizes(axes, steps: Table) -> None:
    """The whole run by step size: share of the steps above, spread of the iterations below."""
    exponents = np.round(np.log2(steps["step_size"])).astype(int)
    sizes = np.unique(exponents)
    position = 2.0 ** sizes
    share = np.array([np.mean(exponents == size) for size in sizes])
    above: Axes = axes[0].inset_axes([0.0, 0.0, 1.0, 1.0])
    axes[0].set_axis_off()
    above.set_xscale("log")
    axes[1].set_xscale("log")
    above.bar(position, 100.0 * share, width=0.6 * position, color="#a9bfd3")
    above.set_ylabel("Share of steps [%]")
    margin = 2.0 if sizes.size > 3 else 10.0
    axes[1].set_xlim(position[0] / margin, margin * position[-1])
    above.set_xlim(axes[1].get_xlim())
    above.tick_params(which="both", labelbottom=False)
    above.set_title("All steps by their size")
    spread = np.array([np.percentile(steps[COLUMN][exponents == size], [5, 50, 95])
                       for size in sizes])
    axes[1].vlines(position, spread[:, 0], spread[:, 2], color="#e3b298", linewidth=4.0)
    axes[1].plot(position, spread[:, 1], "o", color=style.ORANGE, markersize=5.0)
    axes[1].set_xlabel("Step size [s]: median, 5 to 95 %")
    axes[1].grid(axis="y")
    axes[1].set_axisbelow(True)
