"""One look for all figures: fonts, colours, and what several figures draw alike."""

import re
from typing import Callable, List, Sequence

import matplotlib

matplotlib.use("Agg")

import matplotlib.pyplot as plt  # noqa: E402  (the backend comes first)
import numpy as np  # noqa: E402
from matplotlib.axes import Axes  # noqa: E402
from matplotlib.colors import Normalize  # noqa: E402
from matplotlib.figure import Figure  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

from asperity import wedge  # noqa: E402
from asperity.errors import InputError  # noqa: E402
from asperity.run import Run  # noqa: E402

from .along import Axis  # noqa: E402

BLUE, ORANGE, GREY, DARK = "#2b5c8a", "#c8602a", "#8c8c8c", "#333333"
RATE_COLOURS = "magma"
SURFACE_COLOURS = "RdBu_r"
SEQUENCE_COLOURS = "viridis"
FEW_EVENTS = 10  # that a legend lists one by one
FEW_FAULTS = 4   # with panels of full size
COLUMNS = 4      # of the smaller panels of more faults

SETTINGS = {
    "font.family": "DejaVu Sans",
    "font.size": 9.5,
    "axes.titlesize": 10,
    "axes.labelsize": 9.5,
    "figure.titlesize": 12,
    "axes.titlepad": 7,
    "axes.edgecolor": DARK,
    "axes.linewidth": 0.8,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.grid": False,
    "grid.color": "#dddddd",
    "grid.linewidth": 0.6,
    "xtick.color": DARK,
    "ytick.color": DARK,
    "lines.linewidth": 1.2,
    "legend.frameon": False,
    "axes.formatter.useoffset": False,
    "axes.formatter.limits": (-3, 5),
    "axes.formatter.use_mathtext": True,
    "figure.constrained_layout.use": True,
    "figure.constrained_layout.w_pad": 0.06,
    "figure.constrained_layout.h_pad": 0.06,
}


def use() -> None:
    """Makes SETTINGS those of every figure made from now on."""
    plt.rcdefaults()
    plt.rcParams.update(SETTINGS)


def panels(rows: int, columns: int, size, **options):
    """A figure of `size` [inches] and its axes as an array (rows, columns)."""
    return plt.subplots(rows, columns, figsize=size, squeeze=False, **options)


def fault_panels(faults: Sequence[Axis], size):
    """A figure and a panel of `size` [inches] for each fault: side by side where positions grow
    downwards, else one below the other; more than FEW_FAULTS in lines of COLUMNS smaller ones. The
    panels of several faults have their names."""
    count = len(faults)
    downwards = all(where.is_downwards for where in faults)
    lines, columns = (1, count) if downwards else (count, 1)
    first, further = 1.0, 1.0 if count == 1 else 0.75
    if count > FEW_FAULTS:
        lines, columns, first, further = -(-count // COLUMNS), COLUMNS, 0.6, 0.45
    figure, axes = panels(lines, columns, (size[0] * (first + further * (columns - 1)),
                                           size[1] * (first + further * (lines - 1))))
    for panel, where in zip(axes.flat, faults):
        panel.set_title(where.title, loc="right", fontweight="bold", color=DARK)
    for panel in axes.flat[count:]:
        panel.remove()
    return figure, list(axes.flat[:count])


def upper_right(axes: Sequence[Axes]) -> Axes:
    """The panel in the corner of `fault_panels`, above which there is place for a legend."""
    return [panel for panel in axes if panel.get_subplotspec().is_first_row()][-1]


def share_labels(axes: Sequence[Axes]) -> None:
    """Leaves the labels of small panels to those of the first column and to the lowest ones, if all
    have the same."""
    if len(axes) <= FEW_FAULTS:
        return
    if len({(panel.get_xlabel(), panel.get_ylabel()) for panel in axes}) == 1:
        for number, panel in enumerate(axes):
            if number % COLUMNS:
                panel.set_ylabel("")
            if number + COLUMNS < len(axes):
                panel.set_xlabel("")
    for panel in axes:
        panel.set(xlabel=wrapped(panel.get_xlabel()), ylabel=wrapped(panel.get_ylabel()))


def share_limits(axes: Sequence[Axes], name: str) -> None:
    """The same limits of the axis 'x' or 'y' in all panels, so that values can be compared."""
    limits = np.array([getattr(panel, f"get_{name}lim")() for panel in axes])
    for panel in axes:
        panel.set(**{f"{name}lim": (limits.min(), limits.max())})


def title(figure: Figure, text: str) -> None:
    figure.suptitle(text, fontweight="bold", color=DARK)


def note(figure: Figure, text: str) -> None:
    """Below all panels."""
    figure.supxlabel(text, fontsize=8.5, color=DARK)


def save(figure: Figure, path, dpi: int, file_format: str = "png"):
    """Writes a PNG, PDF or SVG to a path or a buffer, and returns that. In PDF and SVG lines and
    texts can be scaled; pictures of many cells have `dpi` there, too."""
    try:
        figure.savefig(path, format=file_format, dpi=dpi, facecolor="white")
    except OSError as error:
        raise InputError(f"{path} cannot be written ({error}). Choose another place with "
                         "--output.") from error
    plt.close(figure)
    return path


def bar_beside(axes: Axes, picture):
    """A colour bar as high as its panel, also where equal scales make that smaller."""
    place = axes.inset_axes([1.02, 0.0, 0.03, 1.0])
    return axes.figure.colorbar(picture, cax=place)


def mark_zone(axes: Axes, run: Run, along: Axis, colour: str, label: bool) -> None:
    """The limits of seismogenic zones as dashed lines, their name beside the right edge."""
    across = axes.get_yaxis_transform()
    for zone in wedge.seismogenic_zones(run.parameters):
        low, high = along(zone)
        for position in (low, high):
            axes.axhline(position, color=colour, linewidth=0.9, linestyle=(0, (5, 4)))
        if label:
            axes.plot([1.02, 1.02], [low, high], transform=across, clip_on=False, color=DARK,
                      linewidth=2.0, solid_capstyle="butt")
            axes.text(1.035, 0.5 * (low + high), _name(run, zone), transform=across,
                      rotation=270, ha="left", va="center", color=DARK, fontsize=8.5)


def _name(run: Run, zone) -> str:
    """What stands beside one of several zones: the long name beside the widest alone."""
    widest = max(wedge.seismogenic_zones(run.parameters), key=lambda each: each[1] - each[0])
    return "seismogenic zone" if zone == widest else ""


def shade_zone(axes: Axes, run: Run, along: Axis) -> None:
    """Seismogenic zones as grey bands over the horizontal axis, with their name above."""
    for zone in wedge.seismogenic_zones(run.parameters):
        low, high = along(zone)
        axes.axvspan(low, high, color="#eeeeee", zorder=0)
        axes.text(0.5 * (low + high), 1.01, _name(run, zone), ha="center", va="bottom",
                  color=DARK, fontsize=8.5, transform=axes.get_xaxis_transform())


def frame(axes: Axes, run: Run, along: Axis, label: str) -> None:
    """Labels of panels of Axis.line, with `label` that of the values, and the zones."""
    if along.is_downwards:
        axes.set(xlabel=label, ylabel=along.label)
    else:
        axes.set(xlabel=along.label, ylabel=label)
        shade_zone(axes, run, along)
    axes.grid(True)


def counted(count: int, noun: str) -> str:
    """'no event', '1 event', '12 events'."""
    return f"{count or 'no'} {noun}{'' if count < 2 else 's'}"


def wrapped(label: str, width: int = 24) -> str:
    """`label` in lines of at most about `width` characters; names of files break at _."""
    words = re.findall(r"[^_ \n]+[_ \n]?", label)
    lines = [""]
    for word in words:
        if len(lines[-1]) + len(word.rstrip()) > width or lines[-1].endswith("\n"):
            lines.append("")
        lines[-1] += word
    return "\n".join(line.rstrip() for line in lines)


def spread(count: int) -> List:
    """`count` colours that can be told apart, from dark to light."""
    if count == 1:
        return [BLUE]
    return list(matplotlib.colormaps[SEQUENCE_COLOURS](np.linspace(0.0, 0.92, count)))


def event_colours(axes: Axes, numbers: np.ndarray) -> Callable[[int], object]:
    """The colour of an event by its number; explained beside `axes`."""
    if len(numbers) <= FEW_EVENTS:
        colours = dict(zip(numbers, spread(len(numbers))))
        handles = [Line2D([], [], color=colours[number], label=f"event {number}")
                   for number in numbers]
        axes.legend(handles=handles, loc="upper left", bbox_to_anchor=(1.01, 1.0), fontsize=8.5)
        return colours.__getitem__
    colours = colour_map(SEQUENCE_COLOURS, Normalize(min(numbers), max(numbers)))
    axes.figure.colorbar(colours, ax=axes, pad=0.02, aspect=32).set_label("Event")
    return colours.to_rgba


def colour_map(name: str, norm) -> matplotlib.cm.ScalarMappable:
    """Colours for lines by a number, ready for a colour bar."""
    return matplotlib.cm.ScalarMappable(norm=norm, cmap=name)
