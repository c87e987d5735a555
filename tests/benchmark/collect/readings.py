"""Numbers that a run is compared by. Each function returns one that reads a finished run, an
`asperity.Run`; numbers of events count from 1. Events that follow one another within a day are one,
unless another time `within` [s] is given."""

import functools
import math

import numpy
import tree  # before asperity, for its place. pylint: disable=unused-import

from asperity.durations import DAY, YEAR

THRESHOLD = 1e-3  # m/s, where an event begins at a receiver of BP3
ARRIVED = 1e-2    # m/s, where a rupture has come to a receiver of BP5


@functools.lru_cache(maxsize=8)
def events(run, within=DAY):
    return run.select(merging_time=within).events


def of_event(column, number, per=1.0, within=DAY):
    """A column of events.csv for one event, in units of `per`."""
    return lambda run: events(run, within)[column][number - 1] / per


def onset(number, per=YEAR, within=DAY):
    return of_event("onset", number, per, within)


def interval(number, per=YEAR, within=DAY):
    """From the onset of this event to that of the next."""
    return lambda run: numpy.diff(events(run, within)["onset"])[number - 1] / per


def mean_interval(numbers, per=YEAR):
    return lambda run: numpy.mean([interval(number, per)(run) for number in numbers])


def number_of_events(within=DAY):
    return lambda run: len(events(run, within))


def median(column, per=1.0):
    """Over all events; of `recurrence`, the time from an onset to the next."""
    def read(run):
        table = events(run, 0.0)
        values = numpy.diff(table["onset"]) if column == "recurrence" else table[column]
        return numpy.median(values) / per
    return read


def magnitude_per_km(number):
    """Mw of one kilometre along strike of an event in the plane."""
    moment = of_event("moment_per_length", number, 1e-3)
    return lambda run: (math.log10(moment(run)) - 9.1) / 1.5


def energy_defect(run):
    """By which the energy balance of the run is off, of the work of friction."""
    return abs(run.steps["energy_defect"][-1]) / run.steps["friction_work"][-1]


def share_of_friction_work(column):
    """Of steps.csv, at the end."""
    return lambda run: run.steps[column][-1] / run.steps["friction_work"][-1]


def _ends(run, number):
    return [of_event(end, number)(run) for end in ("onset", "end")]


def slip_in_event(receiver, number):
    def read(run):
        slip = _scalar(run.receivers[receiver]["slip"])
        return abs(numpy.diff(numpy.interp(_ends(run, number), run.receivers.time, slip))[0])
    return read


def slip_at_depth(depth, number):
    """From fault.h5, at a distance down dip [m]."""
    def read(run):
        at_ends = [numpy.interp(depth, run.fault.position, _scalar(run.fault.at("slip", time)))
                   for time in _ends(run, number)]
        return abs(at_ends[1] - at_ends[0])
    return read


def final_slip(receiver):
    return lambda run: abs(_scalar(run.receivers[receiver]["slip"])[-1])


def arrival(place, depth=None):
    """When the first rupture comes to x = `place`; on a surface along the line at this depth."""
    def read(run):
        nodes = run.ruptures.array("geometry/coordinates")
        line = numpy.arange(len(nodes)) if depth is None else \
            numpy.flatnonzero(numpy.abs(nodes[:, 1] + depth) < 1)
        line = line[numpy.argsort(nodes[line, 0])]
        return numpy.interp(place, nodes[line, 0],
                            run.ruptures.array("first_rupture_time")[line])
    return read


def first_fast(receiver):
    """When the receiver first slips at more than 1 cm/s."""
    def read(run):
        fast = numpy.flatnonzero(run.receivers[receiver]["slip_rate"] > ARRIVED)
        return run.receivers.time[fast[0]]
    return read


def reached(receiver, rate):
    """When the receiver first slips at `rate` [m/s], between steps by interpolation."""
    def read(run):
        time, rates = run.receivers.time, _scalar(run.receivers[receiver]["slip_rate"])
        after = numpy.flatnonzero(rates > rate)[0]
        return numpy.interp(rate, rates[after - 1:after + 1], time[after - 1:after + 1])
    return read


def peak_rate(receiver):
    return lambda run: run.receivers[receiver]["slip_rate"].max()


def slip_after(receiver, time):
    """The length of the slip vector."""
    def read(run):
        slip = numpy.linalg.norm(run.receivers[receiver]["slip"], axis=1)
        return numpy.interp(time, run.receivers.time, slip)
    return read


def slip_per_event(receiver, first, last):
    """Of the length of the slip vector, from a year after one event to a year after another."""
    def read(run):
        slip = numpy.linalg.norm(run.receivers[receiver]["slip"], axis=1)
        before, after = (numpy.interp(of_event("end", number)(run) + YEAR, run.receivers.time, slip)
                         for number in (first, last))
        return (after - before) / (last - first)
    return read


def unlocked(rate):
    """When the slowest node of the fault first slips at `rate` [m/s]."""
    return lambda run: run.fault.time[numpy.flatnonzero(_slowest(run) > rate)[0]]


def final_slowest(per):
    return lambda run: _slowest(run)[-1] / per


def _slowest(run):
    return run.fault["slip_rate"].reshape(run.fault.time.size, -1).min(axis=1)


def surface_motion(place, first, last, field="displacement", number=1):
    """Along x, of the surface at x = `place`, between two times since the onset of an event [s]."""
    def read(run):
        node = numpy.abs(run.surface.coordinates[:, 0] - place).argmin()
        start = onset(number, 1)(run)
        before, after = (run.surface.at(field, start + time)[node, 0]
                         for time in (first, last))
        return after - before
    return read


def final_surface(place, field):
    """Antiplane, of the surface at x = `place`."""
    def read(run):
        node = numpy.abs(run.surface.coordinates[:, 0] - place).argmin()
        return _scalar(run.surface[field][-1])[node]
    return read


def mean_slip(chosen, number):
    """In an event, over the nodes where `chosen` of the coordinates holds, by their shares of the
    fault."""
    def read(run):
        weights = numpy.where(chosen(run.fault.coordinates),
                              run.fault.array("geometry/weights"), 0)
        before, after = (_scalar(run.fault.at("slip", time)) for time in _ends(run, number))
        return weights @ numpy.abs(after - before) / weights.sum()
    return read


def events_where(column, least, most):
    """How many events have a value between these two in the column."""
    def read(run):
        values = events(run, 0.0)[column]
        return int(numpy.count_nonzero((values > least) & (values < most)))
    return read


@functools.lru_cache(maxsize=8)
def passages(run, receiver):
    """The events of BP3 at a receiver: onset [yr], slip [m], the normal stress and the shear
    traction when it begins and the traction when it ends [MPa]."""
    time, fields = run.receivers.time, run.receivers[receiver]
    rate, slip, traction, pressure = (numpy.abs(_scalar(fields[name])) for name in
                                      ("slip_rate", "slip", "traction", "normal_stress"))
    fast, found = rate > THRESHOLD, []
    for start in numpy.flatnonzero(fast[1:] & ~fast[:-1]) + 1:
        rates = numpy.log(rate[start - 1:start + 1])
        begin, before = (numpy.interp(math.log(THRESHOLD), rates, values[start - 1:start + 1])
                         for values in (time, traction))
        if found and begin < found[-1]["onset"] * YEAR + DAY:
            continue
        later = numpy.searchsorted(time[:-1], begin + DAY)
        found.append({"onset": begin / YEAR, "slip": slip[later] - slip[start],
                      "normal stress": pressure[start] / 1e6, "before": before / 1e6,
                      "after": traction[start + numpy.argmin(fast[start:])] / 1e6})
    return found


def passage(quantity, number, receiver="dp075"):
    return lambda run: passages(run, receiver)[number - 1][quantity]


def passage_interval(numbers, receiver="dp075"):
    """The mean of the times that follow the events of these numbers."""
    def read(run):
        onsets = [each["onset"] for each in passages(run, receiver)]
        return numpy.mean([onsets[number] - onsets[number - 1] for number in numbers])
    return read


def _scalar(values):
    """Without the axis of the components, of which a fault in the plane has one."""
    return values.reshape(values.shape[0])
