"""What happened in each event and what its cycle cost, as tables in Markdown."""

from typing import List

import numpy as np

from asperity import network
from asperity.catalogue import magnitude
from asperity.errors import InputError, NothingToShow
from asperity.receivers import ON_FAULT
from asperity.run import Run
from asperity.tables import Table

from . import along, profiles, raster, style, units, windows
from .markdown import Column, table
from .windows import View

COUNTS = (("coupled_steps", "coupled steps"), ("rate_problems", "rate problems"),
          ("tnnmg_iterations", "TNNMG iterations"), ("v_cycles", "V-cycles"),
          ("failed_steps", "failed steps"))  # of each step, in steps.csv
ENERGIES = ("friction_work", "viscous_work", "numerical_dissipation", "kinetic_energy",
            "elastic_energy", "energy_defect")  # of each event, in events.csv
MOMENT_NOTE = ("Moments and largest slips count a node only while it is at least that fast; the "
               "figure moment_rate counts all slip of the fault from onset to end, which is more.")
YEAR_NOTE = "A year has 365.25 days."


def text(run: Run, view: View) -> str:
    """All tables for which the run left data; InputError without events.csv."""
    if not len(run.events):
        return f"No event. {run.selection}".strip()
    parts = ["### Events", table(events(run, view)), _event_note(run)]
    for heading, columns, note in (("Cycles", cycles, CYCLE_NOTE),
                                   ("Energy of the events", energy, ENERGY_NOTE)):
        try:
            parts.append(f"### {heading}\n\n{table(columns(run))}\n\n{note}")
        except NothingToShow as reason:
            parts.append(f"No table '{heading}': {reason}.")
    return "\n\n".join(parts)


def events(run: Run, view: View) -> List[Column]:
    """One row for every event, also for one that the end of the run cut off."""
    catalogue = run.events
    onset, duration = catalogue["onset"], catalogue["duration"]
    clock, recurrence = units.duration(units.largest(onset)), np.diff(onset, prepend=np.nan)
    between = units.duration(units.largest(recurrence)) if onset.size > 1 else clock
    columns = [Column("event", windows.numbers(catalogue), digits=0),
               Column("onset", onset, clock, 6),
               Column("recurrence", recurrence, between),
               Column("duration", duration, units.duration(units.largest(duration)))]
    if "peak_slip_rate" in catalogue:
        rates = catalogue["peak_slip_rate"]
        columns.append(Column("peak slip rate", rates, units.prefixed(rates, "m/s")))
    slips = slip_at_places(run, view)
    if "peak_slip" in catalogue:
        slips.insert(0, Column("largest slip", catalogue["peak_slip"]))
    unit = units.length([units.largest(column.values) for column in slips])
    columns += [Column(column.name, column.values, unit) for column in slips]
    return columns + _moment(catalogue) + _faults(run)


def _faults(run: Run) -> List[Column]:
    """Those that each event breaks, where they have tables of their own."""
    if not run.events_of_faults:
        return []
    names, is_broken = network.broken(run)
    return [Column("breaks", [", ".join(np.array(names)[row]) for row in is_broken])]


def _moment(catalogue: Table) -> List[Column]:
    """Also as the magnitude of a rupture 1 km long, if that is a magnitude at all."""
    if "magnitude" in catalogue:
        return [Column("area", catalogue["area"], units.Unit("m^2", 1.0)),
                Column("moment", catalogue["moment"], units.Unit("N m", 1.0)),
                Column("Mw", catalogue["magnitude"], digits=3)]
    if "moment_per_length" not in catalogue:
        return []
    moment = catalogue["moment_per_length"]
    if not np.isfinite(moment).any():
        return []
    columns = [Column("moment per length", moment, units.Unit("N", 1.0))]
    if units.largest(moment) > 1e9:
        columns.append(Column("Mw of 1 km", magnitude(1000.0 * moment), digits=3))
    return columns


def slip_at_places(run: Run, view: View) -> List[Column]:
    """Slip from onset to end of each event: at the depths of `--at`, or at the receivers."""
    times = np.stack((run.events["onset"], run.events["onset"] + run.events["duration"]))
    if view.options.depths:
        return _slip_at_depths(run, times, np.array(view.options.depths))
    if not run.has("receivers.h5"):
        return []
    try:
        series = run.receivers.series(run.receivers.shown(ON_FAULT, view.options.receivers))
    except NothingToShow:
        return []
    slips = {each.label: np.interp(times, each.time, each.values["slip"])
             for each in series if "slip" in each.values}
    return [Column(f"slip at {name}", end - onset) for name, (onset, end) in slips.items()]


def _slip_at_depths(run: Run, times: np.ndarray, depths: np.ndarray) -> List[Column]:
    """From fault.h5, linear in time between written rows and in space between nodes."""
    axis, position = along.axis(run, run.fault, "fault"), run.fault.position
    places = axis.positions(depths)
    for depth in depths[(places < position[0]) | (places > position[-1])]:
        low, high = sorted(axis.metres(position[[0, -1]]))
        raise InputError(f"--at {depth:g} m lies outside the fault, on which the "
                         f"{axis.name.lower()} goes from {low:g} m to {high:g} m.")
    sign = profiles.sign(run.fault)
    onset, end = (raster.along(position, sign * raster.interpolated(run.fault, profiles.FIELD, at),
                               places) for at in times)
    return [Column(f"slip at {axis.unit(depth):g} {axis.unit.name}", slip)
            for depth, slip in zip(depths, (end - onset).T)]


def cycles(run: Run) -> List[Column]:
    """What the steps from the end of one event to that of the next cost, and all of the run."""
    if not run.has("steps.csv"):
        raise NothingToShow("the run has no steps.csv")
    steps, catalogue = run.steps, run.complete_events
    ends = catalogue["onset"] + catalogue["duration"]
    limits = np.searchsorted(steps["time"], ends) + 1  # the step in which an event ends is its own
    first = np.searchsorted(steps["time"], run.selection.start)

    def sums(values: np.ndarray) -> np.ndarray:
        total = np.concatenate(([0.0], np.cumsum(values)))
        parts = np.diff(total[np.minimum(limits, values.size)], prepend=total[first])
        return np.append(parts, total[-1])

    accepted = sums(np.ones(len(steps)))
    labels = [f"{number}" for number in windows.numbers(catalogue)] + ["whole run"]
    columns = [Column("event", labels), Column("accepted steps", accepted, digits=0)]
    for name, label in COUNTS:
        if name in steps and steps[name].any():
            columns.append(Column(label, sums(steps[name]), digits=0))
    if "coupled_steps" in steps:
        per_accepted = sums(steps["coupled_steps"]) / np.maximum(accepted, 1.0)
        columns.insert(3, Column("coupled per accepted", per_accepted, digits=3))
    return columns


def energy(run: Run) -> List[Column]:
    """Changes from the last step below the threshold before an event to the first after it."""
    catalogue = run.events
    names = [name for name in ENERGIES if name in catalogue]
    if "friction_work" not in names or "energy_defect" not in names:
        raise NothingToShow("events.csv has no friction_work and energy_defect")
    columns = [Column("event", windows.numbers(catalogue), digits=0)]
    for name in names:
        unit = units.Unit(catalogue.units[name] or "J/m", 1.0)
        columns.append(Column(name.replace("_", " "), catalogue[name], unit))
    work = catalogue["friction_work"]
    relative = np.divide(catalogue["energy_defect"], work, out=np.full(work.shape, np.nan),
                         where=work != 0.0)
    return columns + [Column("defect / friction work", relative, digits=2)]


def _event_note(run: Run) -> str:
    threshold = units.plain(run.threshold, "m/s")
    cut = " The end of the run cut off the last event." \
        if len(run.complete_events) < len(run.events) else ""
    return (f"Events are times with a slip rate of at least {threshold} anywhere; slip at a place "
            f"is all of it from onset to end. {MOMENT_NOTE} {YEAR_NOTE}{cut} {_several(run)}"
            f"{run.selection}").rstrip()


def _several(run: Run) -> str:
    """How many events break more than one fault."""
    if not run.events_of_faults:
        return ""
    count = round(network.share_of_several(run) * len(run.events))
    return (f"{count} of {style.counted(len(run.events), 'event')} break more than one fault, each "
            f"with {100 * network.SMALLEST_SHARE:g} % of the moment or more. ")


CYCLE_NOTE = ("A cycle is all steps from the end of the event before to the end of this one; the "
              "first begins with the run, or at the time of --from.")
ENERGY_NOTE = ("Changes from the last step below the threshold to the first one below it again; "
               "the defect is what the balance misses.")
