"""What a referee asks of the events of a run: times, slips and rates, and arrivals at receivers."""

from typing import Dict, List, NamedTuple, Sequence

import numpy as np

from asperity.run import Run

COLUMNS = ("duration", "peak_slip", "peak_slip_rate", "width", "length", "area",
           "moment_per_length", "moment")
SIZES = (("moment_per_length", "width"), ("moment", "area"))  # moment: G times slip times size


class Quantity(NamedTuple):
    name: str
    unit: str


def measured(run: Run, receivers: Sequence[str] = ()) -> Dict[Quantity, np.ndarray]:
    """Values (events) of each quantity of the events that count; nan where there is none. Arrivals
    at `receivers` on the fault are times after the onset."""
    events = run.events
    found = {Quantity("onset", "s"): events["onset"],
             Quantity("interval", "s"): np.diff(events["onset"], prepend=np.nan)}
    found.update({Quantity(name, events.units[name]): events[name]
                  for name in COLUMNS if name in events})
    modulus = run.parameters.number("Bulk/Shear Modulus")
    for moment, size in SIZES:
        if modulus and moment in events and size in events:
            area = np.where(events[size] > 0.0, events[size], np.nan)
            found[Quantity("mean_slip", "m")] = events[moment] / (modulus * area)
    if receivers:
        found.update(_at_receivers(run, receivers))
    return found


def _at_receivers(run: Run, names: Sequence[str]) -> Dict[Quantity, np.ndarray]:
    """When the slip rate rises through the threshold, and slip from onset to end."""
    onset = run.events["onset"]
    end = onset + run.events["duration"]
    found = {}
    for each in run.receivers.series(run.receivers.on_fault(names)):
        found[Quantity(f"arrival at {each.label}", "s")] = np.array(
            [_arrival(each.within(window), run.threshold, window[0])
             for window in zip(onset, end)])
        if "slip" in each.values:
            first, last = (np.interp(times, each.time, each.values["slip"])
                           for times in (onset, end))
            found[Quantity(f"slip at {each.label}", "m")] = last - first
    return found


def _arrival(series, threshold: float, onset: float) -> float:
    rise = series.rise(threshold, onset)
    return np.nan if rise is None else rise - onset


def number_in_common(runs: List[Run]) -> int:
    """The number of events, from the first on, that correspond in all runs: their onsets differ by
    less than half the time to the event before or after, and all or none of them are complete."""
    number = min(len(run.events) for run in runs)
    onsets = np.array([run.events["onset"][:number] for run in runs])
    apart = np.min([_to_neighbours(run.events["onset"])[:number] for run in runs], axis=0)
    same = np.ptp(onsets, axis=0) < 0.5 * apart
    complete = np.array([run.events["complete"][:number] != 0 for run in runs
                         if "complete" in run.events])
    if len(complete):
        same &= complete.all(axis=0) | ~complete.any(axis=0)
    return number if same.all() else int(np.argmin(same))


def _to_neighbours(onsets: np.ndarray) -> np.ndarray:
    """Of each event the time to the nearest other; infinite of a single one."""
    between = np.concatenate(([np.inf], np.diff(onsets), [np.inf]))
    return np.minimum(between[:-1], between[1:])
