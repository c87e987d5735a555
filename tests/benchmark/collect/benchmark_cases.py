"""Cases whose answers are known: from another code, a formula, or another run of our own."""

import dataclasses

import readings as of
from case import Case, Quantity, several

YEAR = of.YEAR
BALANCE = Quantity("energy defect / friction work", "", of.energy_defect, 0)


def wedge_events(number_of_events=None):
    """Of the laboratory wedge; medians over all events."""
    return (
        Quantity("number of events", "", of.number_of_events(0), number_of_events),
        Quantity("onset of event 1", "s", of.onset(1, 1, 0)),
        Quantity("recurrence time, median", "s", of.median("recurrence")),
        Quantity("rupture width, median", "m", of.median("width")),
        Quantity("peak slip, median", "mm", of.median("peak_slip", 1e-3)),
        Quantity("duration, median", "s", of.median("duration"), form=".4f"),
        Quantity("peak slip rate, median", "mm/s", of.median("peak_slip_rate", 1e-3), form=".3f"),
        BALANCE)


LAYERS = ("Time Stepping/Final Time=1100", "Output/Event Catalogue/Threshold=5e-4")
IN_LAYERS = (
    Quantity("onset of event 1", "s", of.onset(1, 1, 0)),
    *several("interval {}", "s", lambda n: of.interval(n, 1, 0), (None, None)),
    *several("peak slip of event {}", "mm", lambda n: of.of_event("peak_slip", n, 1e-3, 0),
             (None,) * 3),
    *several("peak slip rate of event {}", "mm/s",
             lambda n: of.of_event("peak_slip_rate", n, 1e-3, 0), (None,) * 3))


def sandbox(name, title, settings=(), quantities=wedge_events()):
    return Case(name, title, "wedge", 3, (
        *quantities, Quantity("work of yielding / friction work", "",
                              of.share_of_friction_work("inelastic_work"), form=".3f")),
                "balance of energy", deck="sandbox_2d", settings=settings,
                in_index=() if settings else (BALANCE.name,))


WEDGE = (
    Case("wedge_2d_thesis", "Laboratory wedge, ageing law", "wedge", 10, wedge_events(102),
         "Pipping (2014)", in_index=("number of events",)),
    Case("wedge_2d_thesis_slip", "Laboratory wedge, slip law", "wedge", 10, wedge_events(106),
         "Pipping (2014)", deck="wedge_2d_thesis", settings=("Friction/State Evolution=Slip",),
         in_index=("number of events",)),
    Case("wedge_2d", "Laboratory wedge, cells of 4 mm", "wedge", 1,
         tuple(quantity for quantity in wedge_events() if "number" not in quantity.name),
         "`wedge_2d_thesis`", against="wedge_2d_thesis", in_index=("peak slip, median",)),
    Case("wedge_2d_printed", "Laboratory wedge as printed", "wedge", 1, (
        Quantity("time at which the slowest node passes half the plate rate", "s",
                 of.unlocked(25e-6), 623, ".1f"),
        Quantity("number of events", "", of.number_of_events(0), 0),
        Quantity("smallest slip rate at the end", "mm/s", of.final_slowest(1e-3), 0.05, ".6f"),
        BALANCE), "independent integration", in_index=(
            "time at which the slowest node passes half the plate rate",)),
    sandbox("sandbox_2d", "Laboratory wedge that yields"),
    sandbox("sandbox_2d_elastic", "The same, elastic rock", ("Bulk/Cohesion=1e9",)),
    sandbox("sandbox_2d_weak", "The same, a third of the cohesion", ("Bulk/Cohesion=1e3",),
            (Quantity("number of events", "", of.number_of_events(0)), BALANCE)),
    Case("wedge_2d_layers", "", "wedge", 1, IN_LAYERS, deck="wedge_2d", has_table=False, settings=(
        *LAYERS, "Time Stepping/Scheme=Generalised Alpha", "Time Stepping/Control=Richardson",
        "Time Stepping/Richardson/Tolerance=1e-4", "Time Stepping/Richardson/First Step=1e-3",
        "Mesh/Wedge/Cell Size=0.004")),
    Case("wedge_3d_layers", "Wedge between glass walls", "wedge", 20, IN_LAYERS,
         "the wedge in the plane", deck="wedge_3d", against="wedge_2d_layers", settings=(
             *LAYERS, "Mesh/Deep Wedge/Cells=Layers", "Mesh/Deep Wedge/Cell Size=0.004",
             "Mesh/Deep Wedge/Layers=6"),
         in_index=("onset of event 1", "peak slip of event 3")),
    Case("wedge_3d_patches", "Two patches on the base of a wedge", "wedge", 15, (
        Quantity("number of events", "", of.number_of_events(0)),
        Quantity("number of events with the hypocentre at z < 0.3 m", "",
                 of.events_where("hypocentre_z", -1, 0.3)),
        Quantity("onset of event 1", "s", of.onset(1, 1, 0), form=".2f"),
        Quantity("peak slip of event 9", "mm", of.of_event("peak_slip", 9, 1e-3, 0), form=".3f"),
        dataclasses.replace(BALANCE, reference=None))),
)

BP1 = (
    Quantity("onset of event 1", "yr", of.onset(1), 196.4),
    *several("interval {}", "yr", of.interval, (75.6, 77.8, 78.3, 78.35)),
    *several("slip at 5 km depth in event {}", "m", lambda n: of.slip_in_event("dp050", n),
             (2.82, 2.505, 2.47, 2.47, 2.47)),
    Quantity("peak slip rate of event 5", "m/s", of.of_event("peak_slip_rate", 5)),
    Quantity("moment per length of event 5", "N", of.of_event("moment_per_length", 5),
             form=".4g"))

STRIKE_SLIP = (
    Case("bp1_qd", "SEAS BP1-QD", "bp1", 2, (*BP1, BALANCE), "several codes",
         in_index=("onset of event 1", "interval 4", "slip at 5 km depth in event 5")),
    Case("bp1_qd_two_sided", "SEAS BP1-QD with both bodies", "bp1", 3,
         (*(dataclasses.replace(quantity, reference=None) for quantity in BP1), BALANCE),
         "`bp1_qd`", against="bp1_qd",
         in_index=("interval 4", "slip at 5 km depth in event 5")),
    Case("bp1_fd", "SEAS BP1-FD", "bp1", 10, (
        Quantity("onset of event 1", "yr", of.onset(1), 196.4),
        *several("interval {}", "yr", of.interval, (None, 115, 115, 115)),
        *several("slip at 5 km depth in event {}", "m", lambda n: of.slip_in_event("dp050", n),
                 (None, None, 3.6, 3.6, 3.6)), BALANCE), "several codes",
         in_index=("onset of event 1", "interval 4", "slip at 5 km depth in event 5")),
    Case("bp2_qd", "SEAS BP2-QD", "bp2", 18, (
        *several("onset of event {}", "yr", of.onset, (151.2, 208.9, 233.1)),
        *several("interval {}", "yr", of.interval,
                 ((82, 84), (22, 24), (82, 84), (22, 24), (82, 84), (22, 24)), range(3, 9)),
        *several("slip at the surface in event {}", "m", lambda n: of.slip_in_event("dp000", n),
                 (0, 3.31, 0)),
        *(Quantity(f"slip at {depth / 1e3:g} km depth in event 1", "m",
                   of.slip_at_depth(depth, 1), reference)
          for depth, reference in ((9600, 0.83), (12000, 0.98), (14400, 0.83))), BALANCE),
         "boundary element codes",
         in_index=("onset of event 1", "onset of event 3", "slip at the surface in event 1",
                   "slip at the surface in event 2")),
)


def dipping(onset, intervals, slips):
    return (Quantity("onset of event 1", "yr", of.passage("onset", 1), onset),
            *several("interval {}", "yr", lambda n: of.passage_interval((n,)), intervals),
            *several("slip at 7.5 km in event {}", "m", lambda n: of.passage("slip", n), slips))


BP3_MESH = "asperity-mesh convert xml/meshes/bp3.geo "
THRUST = (
    Case("bp3_qd_60", "SEAS BP3-QD, thrust, 60 degrees", "bp3", 60, (
        *dipping(177.10, (100.24, 56.96, 86.95, 92.44, 97.41),
                 (1.059, 3.374, 2.366, 2.609, 2.817)),
        Quantity("mean of intervals 6 to 9", "yr", of.passage_interval((6, 7, 8, 9)), 84.7),
        Quantity("shear traction at the onset of event 1", "MPa", of.passage("before", 1), 43.96),
        Quantity("shear traction at the end of event 1", "MPa", of.passage("after", 1), 27.90),
        Quantity("normal stress at the onset of event 1", "MPa",
                 of.passage("normal stress", 1), 50.48), BALANCE),
         "FDRA, elements of 25 m", deck="bp3_qd", mesh=BP3_MESH + "bp3.h5 --set h=50",
         settings=("Time Stepping/Final Time=3.1e10",),
         in_index=("onset of event 1", "mean of intervals 6 to 9", "slip at 7.5 km in event 2")),
    Case("bp3_qd_30", "SEAS BP3-QD, thrust, 30 degrees", "bp3", 11, (
        *dipping(176.2, (87.0, 64.7, 86.6, 64.7, 86.6), (2.21, 2.55, 2.21, 2.55, 2.21, 2.55)),
        BALANCE), "published values", deck="bp3_qd",
         mesh=BP3_MESH + "bp3_30.h5 --set dip=30 --set h=100",
         settings=("Mesh/File/File Name=bp3_30.h5", "Time Stepping/Final Time=1.8e10"),
         in_index=("onset of event 1", "interval 4", "slip at 7.5 km in event 4")),
)

# Of square_core.py with elements of 500 m: arrival [s], peak rate [m/s], slip after 60 s [m].
PLACES = {"strk+00dp+10": ("(0, 10 km)", 26.28, 0.874, 6.96),
          "strk+16dp+10": ("(16 km, 10 km)", 33.77, 0.985, 6.19),
          "strk+00dp+00": ("(0, 0)", 40.17, 0.663, 4.58),
          "strk+16dp+00": ("(16 km, 0)", 45.72, 0.511, 3.52),
          "strk-24dp+00": ("(-24 km, 0)", 47.48, 0.256, 2.07)}
BP5 = (
    *(Quantity(f"1 cm/s reached at {place}", "s", of.first_fast(name), arrival, ".1f")
      for name, (place, arrival, _, _) in PLACES.items()),
    *(Quantity(f"peak slip rate at {place}", "m/s", of.peak_rate(name), rate, ".2f")
      for name, (place, _, rate, _) in PLACES.items()),
    *(Quantity(f"slip after 60 s at {place}", "m", of.slip_after(name, 60), slip, ".2f")
      for name, (place, _, _, slip) in PLACES.items()), BALANCE)
FIRST_EVENT = "Time Stepping/Final Time=128"
# Of what TriBIE (D. Li, boundary elements of 1 km) and tandem (C. Uphoff, elements of 4 km) have
# submitted to the platform: times at (16 km, 10 km) and (0, 10 km) from the state variable, which
# counts the time since an event, and slips. A pair: TriBIE, tandem (its interval: event 3 to 8).
BP5_SEQUENCE = (
    Quantity("number of events", "", of.number_of_events(), 8),
    Quantity("onset of event 2", "yr", of.onset(2), 238.86),
    Quantity("onset of event 8", "yr", of.onset(8), (1668.6, 1678.0)),
    Quantity("mean interval from event 2 to 8", "yr", of.mean_interval(range(2, 8)),
             (238.3, 239.6)),
    Quantity("slip a cycle at (16 km, 10 km), event 2 to 8", "m",
             of.slip_per_event("strk+16dp+10", 2, 8), 7.514, ".3f"),
    Quantity("slip a cycle at (0, 10 km), event 2 to 8", "m",
             of.slip_per_event("strk+00dp+10", 2, 8), 7.543, ".3f"),
    *several("magnitude of event {}", "", lambda n: of.of_event("magnitude", n), (None,) * 2,
             (2, 8), ".2f"),
    *several("peak slip of event {}", "m", lambda n: of.of_event("peak_slip", n), (None,) * 2,
             (2, 8)),
    *several("peak slip rate of event {}", "m/s", lambda n: of.of_event("peak_slip_rate", n),
             (None,) * 2, (2, 8)),
    BALANCE)
WHOLE = "Time Stepping/Final Time=5.68e10"

VERTICAL_IN_SPACE = (
    Case("bp5_qd", "SEAS BP5-QD, cells of 2 km", "bp5", 2, BP5, "boundary elements of 500 m",
         settings=(FIRST_EVENT,), in_index=("slip after 60 s at (0, 10 km)",)),
    Case("bp5_qd_1km", "SEAS BP5-QD, cells of 1 km", "bp5", 5, BP5, "boundary elements of 500 m",
         deck="bp5_qd", settings=(FIRST_EVENT, "Mesh/Box/Cell Size Factor=0.5"),
         in_index=("1 cm/s reached at (0, 0)", "peak slip rate at (0, 0)",
                   "slip after 60 s at (0, 10 km)", "slip after 60 s at (0, 0)")),
    Case("bp5_qd_sequence", "SEAS BP5-QD, 1,800 years, cells of 1 km", "bp5", 110, BP5_SEQUENCE,
         "TriBIE and tandem", deck="bp5_qd", settings=(WHOLE, "Mesh/Box/Cell Size Factor=0.5"),
         in_index=("mean interval from event 2 to 8",)),
    Case("bp5_qd_sequence_2km", "SEAS BP5-QD, 1,800 years, cells of 2 km", "bp5", 12,
         BP5_SEQUENCE, "TriBIE and tandem", deck="bp5_qd", settings=(WHOLE,)),
    Case("bp5_fd", "BP5 with inertia", "bp5", 35, (
        Quantity("number of events", "", of.number_of_events()),
        *several("interval {}", "yr", of.interval, (None,) * 4),
        *several("duration of event {}", "s", lambda n: of.of_event("duration", n), (None,) * 5),
        *several("magnitude of event {}", "", lambda n: of.of_event("magnitude", n), (None,) * 5,
                 form=".2f"),
        *several("peak slip of event {}", "m", lambda n: of.of_event("peak_slip", n), (None,) * 5),
        *several("peak slip rate of event {}", "m/s",
                 lambda n: of.of_event("peak_slip_rate", n), (None,) * 5),
        dataclasses.replace(BALANCE, reference=None))),
)


def of_rupture(arrivals, slips, seconds=6):
    """arrivals: {x [m]: s}, slips: {receiver, named by its distance: m}"""
    return (*(Quantity(f"arrival at {place / 1e3:g} km", "s", of.arrival(place), reference)
              for place, reference in arrivals.items()),
            *(Quantity(f"slip after {seconds} s at {int(name[2:]) / 10:g} km", "m",
                       of.final_slip(name), reference) for name, reference in slips.items()))


TPV103 = of_rupture({0: 0.571, 2500: 1.355, 5000: 1.941, 7500: 2.937, 9000: 3.500, 12000: 4.531},
                    {"st000": 17.36, "st050": 12.31, "st090": 9.75})
# Of tests/benchmark/time_scales/boundary_integral.py with nodes 50 m apart.
TPV5 = of_rupture({-12000: 2.802, -7500: 1.836, -4500: 1.533, 4500: 1.533, 7500: 2.654,
                   12000: 4.365},
                  {"st-120": 4.103, "st-075": 6.778, "st-045": 7.002, "st045": 6.110,
                   "st075": 4.797, "st120": 3.532}, seconds=8)
# Of tests/benchmark/time_scales/tpv103_antiplane.py with nodes 50 m apart.
TPV103_ANTIPLANE = of_rupture({0: 0.571, 2500: 1.559, 5000: 2.360, 7500: 3.139, 9000: 3.598,
                               12000: 4.504},
                              {"st000": 22.56, "st050": 15.84, "st090": 12.66})
ANTIPLANE = {"deck": "tpv103_2d",
             "removed": ("Boundary Conditions/Symmetry", "Initial State/Velocity X"),
             "settings": ("Bulk/Model=Antiplane", "Initial State/Velocity Z=0.5e-16")}


def in_space(rate, seconds, places):
    """places: {(along strike, depth) [km]: when `rate` [m/s] is reached [s], slip [m]}"""
    def name(x, depth):
        return f"st{'-' if x < 0 else ''}{round(abs(x) * 10):03d}dp{round(depth * 10):03d}"
    label = f"{rate:g} m/s" if rate >= 0.01 else f"{rate * 1e3:g} mm/s"
    return (*(Quantity(f"{label} reached at ({place[0]:g}, {place[1]:g}) km", "s",
                       of.reached(name(*place), rate), references[0], ".3f")
              for place, references in places.items()),
            *(Quantity(f"slip after {seconds} s at ({place[0]:g}, {place[1]:g}) km", "m",
                       of.slip_after(name(*place), seconds), references[1], ".3f")
              for place, references in places.items()))


# Of EqSim, finite elements, from time series with a row every 0.05 s.
TPV205 = in_space(0.5, 8, {
    (0, 0): (3.463, 5.206), (0, 3): (2.178, 5.087), (0, 12): (2.177, 3.180),
    (4.5, 7.5): (1.728, 4.221), (7.5, 7.5): (3.924, 3.227), (12, 7.5): (5.271, 2.661),
    (-7.5, 7.5): (2.655, 4.617), (-12, 7.5): (4.055, 2.860), (12, 0): (5.103, 2.976),
    (-12, 0): (5.103, 3.139)})
NONE = (None, None)
TPV104 = in_space(1e-3, 6, dict.fromkeys(
    ((0, 7.5), (4.5, 7.5), (9, 7.5), (0, 3), (0, 12)), NONE))
TPV105 = in_space(1e-3, 6, dict.fromkeys(
    ((-4, 7.5), (0, 7.5), (9, 7.5), (-9, 7.5), (0, 3), (0, 12)), NONE))

TPV101 = of_rupture({0: 0.569, 2500: 1.657, 5000: 2.615, 7500: 3.474, 9000: 3.978, 12000: 4.974},
                   {"st000": 10.16, "st050": 7.25, "st090": 5.62})
RUPTURES = (
    Case("tpv101_2d", "TPV101 in plane strain, cells of 100 m", "tpv101", 0.5, (*TPV101, BALANCE),
         "reference values", in_index=("arrival at 9 km", "slip after 6 s at 5 km")),
    Case("tpv101_2d_50m", "TPV101 in plane strain, cells of 50 m", "tpv101", 2,
         (*TPV101, BALANCE), "reference values", deck="tpv101_2d",
         settings=("Mesh/Rectangle/Cell Size Factor=0.5",),
         in_index=("arrival at 9 km", "slip after 6 s at 5 km")),
    Case("tpv101_two_sided", "TPV101 in plane strain with both bodies", "tpv101", 1,
         (*(dataclasses.replace(quantity, reference=None) for quantity in TPV101), BALANCE),
         "`tpv101_2d`", against="tpv101_2d",
         in_index=("arrival at 9 km", "slip after 6 s at 5 km")),
    Case("tpv103_2d", "TPV103 in plane strain, cells of 100 m", "weakening", 0.3,
         (*TPV103, BALANCE), "reference values"),
    Case("tpv103_2d_50m", "TPV103 in plane strain, cells of 50 m", "weakening", 2,
         (*TPV103, BALANCE), "reference values", deck="tpv103_2d",
         settings=("Mesh/Rectangle/Cell Size Factor=0.5",),
         in_index=("arrival at 9 km", "slip after 6 s at 5 km")),
    Case("tpv5_2d", "TPV5 in plane strain, cells of 100 m", "weakening", 0.5, (*TPV5, BALANCE),
         "boundary integrals"),
    Case("tpv5_2d_50m", "TPV5 in plane strain, cells of 50 m", "weakening", 7, (*TPV5, BALANCE),
         "boundary integrals", deck="tpv5_2d", settings=("Mesh/Rectangle/Cell Size Factor=0.5",),
         in_index=("arrival at 12 km", "slip after 8 s at 7.5 km")),
    Case("tpv103_antiplane", "TPV103 in antiplane shear, cells of 100 m", "weakening", 0.3,
         (*TPV103_ANTIPLANE, BALANCE), "boundary integrals", **ANTIPLANE,
         in_index=("arrival at 9 km", "slip after 6 s at 5 km")),
    Case("tpv205_3d", "TPV205 in space, cells of 400 m", "weakening", 4, (*TPV205, BALANCE),
         "EqSim"),
    Case("tpv205_3d_200m", "TPV205 in space, cells of 200 m", "weakening", 20,
         (*TPV205, BALANCE), "EqSim", deck="tpv205_3d", settings=("Names/cell=200",),
         in_index=("0.5 m/s reached at (12, 7.5) km", "slip after 8 s at (0, 0) km",
                   "slip after 8 s at (12, 7.5) km")),
    Case("tpv104_3d", "TPV104 in space, cells of 400 m", "weakening", 6, (*TPV104, BALANCE)),
    Case("tpv105_3d", "TPV105 in space, cells of 400 m", "weakening", 9, (*TPV105, BALANCE)),
    Case("tpv101_3d", "TPV101 in space, cells of 400 m", "tpv101", 7, (
        *(Quantity(f"arrival at {place / 1e3:g} km along strike", "s", of.arrival(place, 7500),
                   reference) for place, reference in ((4500, 2.77), (9000, 4.80))), BALANCE),
         "cells of 200 m", in_index=("arrival at 9 km along strike",)),
)

# Of tests/verification/spring_slider/exact_slider.py with largest_change = 0.005.
ODE = {"onset": (345.5, 2192.6, 4440.5, 6723.1, 9008.4),
       "slip": (1.4358, 2.1475, 2.2103, 2.2152, 2.2156),
       "rate": (0.5106, 0.7724, 0.7953, 0.7972, 0.7973)}
SLIDER = (
    Case("spring_slider", "Spring slider", "known_answers", 0.1, (
        Quantity("number of events", "", of.number_of_events(0), 5),
        *several("onset of event {}", "s", lambda n: of.onset(n, 1, 0), ODE["onset"]),
        *several("peak slip of event {}", "mm", lambda n: of.of_event("peak_slip", n, 1e-3, 0),
                 ODE["slip"]),
        *several("peak slip rate of event {}", "m/s",
                 lambda n: of.of_event("peak_slip_rate", n, 1, 0), ODE["rate"]), BALANCE),
         "ordinary differential equation",
         in_index=("onset of event 5", "peak slip rate of event 5")),
)

CASES = SLIDER + WEDGE + STRIKE_SLIP + THRUST + VERTICAL_IN_SPACE + RUPTURES
