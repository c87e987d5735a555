"""The figures by name. The module of that name draws each."""

from importlib import import_module
from typing import TYPE_CHECKING

from asperity.errors import NothingToShow

if TYPE_CHECKING:  # the list of figures is printed without matplotlib, too
    from matplotlib.figure import Figure

    from asperity.run import Run

    from .windows import View

FIGURES = {  # what it shows, and the file that it needs
    "slip_rate": ("slip rate over position and time, with a zoom into a rupture", "fault.h5"),
    "surface": ("uplift of the free surface over position and time, against the boundary that "
                "drives the run, less each place's average over the time shown, or its trend "
                "if that has three events or more; antiplane displacement", "surface.h5"),
    "deformation": ("how the free surface moves in the years before an event, and in the event; "
                    "in 3D maps of uplift with arrows", "surface.h5"),
    "events": ("box plots of recurrence time, rupture width, peak slip and more", "events.csv"),
    "iterations": ("fixed point iterations and step size", "steps.csv"),
    "slip": ("profiles of cumulative slip", "fault.h5"),
    "energy": ("balance of energy over the run", "steps.csv"),
    "slip_profiles": ("cumulative slip, lines years apart and seconds apart in ruptures",
                      "fault.h5"),
    "opening": ("in the plane: opening over position and time, of faults that open", "fault.h5"),
    "receivers": ("slip rate, shear traction, state and slip at the receivers on the fault",
                  "receivers.h5"),
    "stations": ("displacement and velocity, component by component, at the receivers in the body "
                 "and on the ground", "receivers.h5"),
    "rupture_times": ("first arrival of each rupture over the distance along the fault",
                      "rupture.h5"),
    "moment_rate": ("moment rate and moment of each event", "global.csv"),
    "traces": ("in the plane, of several faults: a map of their traces with slip and with the peak "
               "slip rate of an event", "fault.h5"),
    "fault_maps": ("in 3D: slip of an event and its rupture front on the fault", "fault.h5"),
    "rupture_patterns": ("in 3D: rupture fronts of the last events side by side", "rupture.h5"),
    "fault_history": ("in 3D: peak slip rate, and slip rate along strike over time", "fault.h5"),
}


def draw(name: str, run: "Run", view: "View", is_wanted: bool = False) -> "Figure":
    """A figure of matplotlib; NothingToShow if the run has no data for it. InputError if one that
    `is_wanted` lacks its file."""
    lack = run.reason_missing(FIGURES[name][1])
    if not is_wanted and lack:
        raise NothingToShow(lack)
    module = import_module("." + name, __package__)
    return module.draw(run, view)
