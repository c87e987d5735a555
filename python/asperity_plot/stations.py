"""Series at receivers in the body, as GNSS and seismometers on the ground have them: displacement
over the whole time, velocity in one rupture; one row of panels for each component."""

from dataclasses import replace
from typing import List, Tuple

import numpy as np

from asperity.errors import NothingToShow
from asperity.receivers import IN_BODY
from asperity.run import Run
from asperity.series import Series

from . import maps, receivers, style, units, windows
from .windows import View, Window

LABELS = {"displacement": "Displacement", "velocity": "Velocity"}

Column = Tuple[str, Window, float]  # the field, the times shown, and that which counts as 0 [s]


def draw(run: Run, view: View):
    """The figure; NothingToShow without receivers in the body, fields in LABELS there or a second
    row."""
    names = receivers.thinned(run.receivers.shown(IN_BODY, view.options.receivers))
    if run.receivers.time.size < 2:
        raise NothingToShow("receivers.h5 has a single row")
    columns = _columns(run, view)
    series = {field: run.receivers.motion(names, field) for field, *_ in columns}
    directions = list(series[columns[0][0]][0].values)
    widths = [1.25, 1.0] if len(columns) > 1 else [2.25]
    figure, axes, beside = receivers.panels(len(directions), widths, sharey="none")
    for panels, (field, window, origin) in zip(axes.T, columns):
        _column(panels, field, series[field], window, origin)
        for panel, direction in zip(panels, directions):
            panel.set_ylabel(f"{LABELS[field]} {_name(run, direction, len(directions))} "
                             f"[{panel.get_ylabel()}]")
    whole = windows.over_sequence(run, view)
    maps.label_cycles(axes[0, 0], whole, axes[-1, 0])
    if len(columns) > 1 and view.zoom is not None:
        maps.label_zoom(axes[0, 1], view, axes[-1, 1])
    elif len(columns) > 1:
        maps.label_cycles(axes[0, 1], whole, axes[-1, 1])
    beside.legend(*axes[0, 0].get_legend_handles_labels(), loc="upper left", fontsize=8.5,
                  borderaxespad=0.0)
    figure.align_ylabels()
    shown = " and ".join(LABELS[field].lower() for field in dict.fromkeys(
        field for field, *_ in columns))
    style.title(figure, f"Receivers in the body: {shown}")
    if "displacement" in series:
        style.note(figure, "Displacements count from the first time shown.")
    return figure


def _columns(run: Run, view: View) -> List[Column]:
    """Displacement, or else velocity, over the whole time; beside it the last of the two fields
    that there is, in one rupture if the view has one."""
    fields = [field for field in LABELS if run.receivers.has_motion(field)]
    if not fields:
        raise NothingToShow(f"receivers.h5 has none of the fields {', '.join(LABELS)} in the body")
    whole = windows.over_sequence(run, view).cycles
    columns = [(fields[0], whole, 0.0)]
    if view.zoom is not None:
        columns.append((fields[-1], view.zoom, view.onset))
    elif len(fields) > 1:
        columns.append((fields[1], whole, 0.0))
    return columns


def _column(axes, field: str, series: List[Series], window: Window, origin: float) -> None:
    """One panel below the other for the components; the label of each is the unit for now."""
    clock = units.duration(max(abs(window[0] - origin), window[1] - origin))
    shown = [each.within(window) for each in series]
    if field == "displacement":
        shown = [_since_first(each) for each in shown]
    sizes = [units.largest(values) for each in shown for values in each.values.values()]
    unit = units.length(sizes) if field == "displacement" else units.prefixed(sizes, "m/s")
    for panel, direction in zip(axes, series[0].values):
        for each, colour in zip(shown, style.spread(len(shown))):
            panel.plot(clock(each.time - origin), unit(each.values[direction]), color=colour,
                       linewidth=1.1, label=style.wrapped(each.label))
        panel.grid(True)
        panel.set_ylabel(unit.name)


def _since_first(series: Series) -> Series:
    return replace(series, values={name: values - values[0]
                                   for name, values in series.values.items()})


def _name(run: Run, direction: str, count: int) -> str:
    """'x', or 'z (up)' of the vertical axis in space; an antiplane body moves along strike."""
    if count == 1:
        return "along strike"
    up = np.array(run.parameters.numbers("Output/Up"))
    is_up = count == 3 == up.size and up["xyz".index(direction)] > (1.0 - 1e-9) * np.linalg.norm(up)
    return f"{direction} (up)" if is_up else direction
