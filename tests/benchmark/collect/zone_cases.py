"""Faults over centuries: there is no answer to compare with but the balance of energy."""

import readings as of
from case import Case, Quantity, several

BALANCE = Quantity("energy defect / friction work", "", of.energy_defect, 0)
IN_INDEX = (BALANCE.name,)
SOURCE = "balance of energy"
MOST = "Output/Event Catalogue/Most Events="


def number(name, unit, read, form=""):
    return Quantity(name, unit, read, form=form)


def of_last(event, interval_numbers):
    """In the plane: the cycle, and the event of this number."""
    return (number("number of events", "", of.number_of_events()),
            number("onset of event 1", "yr", of.onset(1)),
            *several("interval {}", "yr", of.interval, (None,) * len(interval_numbers),
                     interval_numbers),
            number(f"rupture width of event {event}", "km", of.of_event("width", event, 1e3)),
            number(f"peak slip of event {event}", "m", of.of_event("peak_slip", event), ".2f"),
            number(f"peak slip rate of event {event}", "m/s",
                   of.of_event("peak_slip_rate", event), ".2f"),
            number(f"magnitude of 1 km of event {event}", "", of.magnitude_per_km(event), ".2f"),
            BALANCE)


def in_space(events):
    """With what happens within a day as several events."""
    def column(name, unit, form, per=1.0):
        return tuple(number(f"{name.replace('_', ' ')} of event {n}", unit,
                            of.of_event(name, n, per, 0), form) for n in events)
    return (*column("onset", "yr", ".3f", of.YEAR), *column("magnitude", "", ".2f"),
            *column("peak_slip", "m", ".1f"), *column("peak_slip_rate", "m/s", ".2f"), BALANCE)


MEGATHRUST = (
    Case("megathrust_2d", "Megathrust in the plane", "megathrust", 5, of_last(5, range(1, 5)),
         SOURCE, in_index=IN_INDEX),
    Case("megathrust_3d", "Megathrust with two asperities", "megathrust", 5, in_space((1, 2)),
         SOURCE, settings=(MOST + "2",), in_index=IN_INDEX),
    Case("megathrust_3d_fine", "Megathrust with two asperities, cells of 4 km", "megathrust", 120,
         in_space(range(1, 7)), SOURCE, deck="megathrust_3d",
         settings=("Mesh/Deep Wedge/Cell Size=4e3", MOST + "6"), in_index=IN_INDEX),
)


def mesh(deck, cell):
    return f"asperity-mesh convert xml/meshes/{deck}.geo {deck}.h5 --set h={cell}"


def on_splay(place):
    """Of splay_2d.xml."""
    return place[:, 1] + 12e3 > 0.4 * abs(place[:, 0] - 65752)


def splay(name, title, b=None):
    """With another b on the splay, on the mesh of the first of these cases."""
    changed = (f"Friction/b=y + 12e3 > 0.4 * abs(x - 65752) ? {b} : 0.015",) if b else ()
    return Case(name, title, "subduction", 2, (
        number("onset of event 1", "yr", of.onset(1)),
        number("mean slip on the splay in event 1", "m", of.mean_slip(on_splay, 1), ".2f"),
        number("peak slip of event 1", "m", of.of_event("peak_slip", 1), ".2f"), BALANCE),
                SOURCE, deck="splay_2d", mesh="" if b else mesh("splay_2d", 500),
                settings=changed, in_index=() if b else IN_INDEX)


SETTLED, COAST, INLAND = 400, 150e3, 300e3  # s after an onset, m from the trench


def after_an_earthquake(name, title, settings=()):
    motions = tuple(
        number(f"motion {where} {when}", "m", of.surface_motion(place, first, last), ".2f")
        for where, place in (("of the coast", COAST), ("300 km from the trench", INLAND))
        for when, first, last in (("in the event", 0, SETTLED),
                                  ("in 20 years after it", SETTLED, 20 * of.YEAR),
                                  ("in the next 80 years", 20 * of.YEAR, 100 * of.YEAR)))
    by_flow = tuple(
        number(f"by flow alone, {where} in 20 years after it", "m",
               of.surface_motion(place, SETTLED, 20 * of.YEAR, "viscous_displacement"), ".2f")
        for where, place in (("of the coast", COAST), ("300 km from the trench", INLAND)))
    return Case(name, title, "subduction", 1, (
        number("onset of event 1", "yr", of.onset(1)),
        number("peak slip of event 1", "m", of.of_event("peak_slip", 1), ".2f"),
        *motions, *by_flow, BALANCE), SOURCE, deck="postseismic_2d", settings=settings,
                in_index=() if settings else IN_INDEX)


def cycles(name, title, settings=()):
    return Case(name, title, "subduction", 5, of_last(5, range(1, 5)), SOURCE,
                deck="subduction_cycle_2d", settings=settings,
                in_index=() if settings else IN_INDEX)


STIFF = "Bulk/Regions/mantle/Viscosity=1e30"
MANTLE = (
    after_an_earthquake("postseismic_2d", "A century after an earthquake"),
    after_an_earthquake("postseismic_2d_elastic", "The same, elastic mantle", (STIFF,)),
    cycles("subduction_cycle_2d", "Cycles over a mantle that flows"),
    cycles("subduction_cycle_2d_elastic", "The same, elastic mantle",
           (STIFF, "Bulk/Regions/mantle/Transient Viscosity=1e30")),
    Case("subduction_cycle_3d", "Cycles over a mantle that flows, with the coast", "subduction", 15,
         (number("number of events", "", of.number_of_events(0)), *in_space(range(1, 10))), SOURCE,
         mesh=mesh("subduction_3d", "6e3"), in_index=IN_INDEX),
)


def in_rock_that_yields(name, title, settings=(), minutes=2):
    return Case(name, title, "yielding", minutes, (
        number("number of events", "", of.number_of_events()),
        number("onset of event 1", "yr", of.onset(1)),
        *several("interval {}", "yr", of.interval, (None, None)),
        *(number(f"slip at {depth} km depth in event {event}", "m",
                 of.slip_at_depth(depth * 1e3, event), ".2f")
          for event in (1, 3) for depth in (0, 2, 8)),
        number("peak slip rate of event 1", "m/s", of.of_event("peak_slip_rate", 1), ".2f"),
        *(number(f"by inelastic strain, motion {place} m from the fault at the end", "m",
                 of.final_surface(place, "inelastic_displacement"), ".3f")
          for place in (500, 2000)),
        BALANCE), SOURCE, deck="off_fault_cycle_2d", settings=settings,
                in_index=() if settings else IN_INDEX)


YIELDING = (
    in_rock_that_yields("off_fault_cycle_2d", "Cycles in rock that yields"),
    in_rock_that_yields("off_fault_cycle_2d_weak", "The same, half the cohesion",
                        ("Bulk/Cohesion=10e6",), 3),
    in_rock_that_yields("off_fault_cycle_2d_elastic", "The same, elastic rock",
                        ("Bulk/Cohesion=1e9",)),
)

FIXED = "Friction/Normal Stress Change=Fixed"
SUBDUCTION = (
    Case("subduction_2d", "Subduction zone in the plane", "subduction", 9,
         of_last(7, range(1, 7)), SOURCE, mesh=mesh("subduction_2d", 500), in_index=IN_INDEX),
    Case("subduction_2d_fixed", "The same, fixed normal stress", "subduction", 6,
         of_last(3, range(1, 4)), SOURCE, deck="subduction_2d",
         settings=(FIXED, "Time Stepping/Final Time=2.2e10")),
    splay("splay_2d", "Megathrust and splay"),
    splay("splay_2d_neutral", "The same, neutral splay", "0.010"),
    splay("splay_2d_strengthening", "The same, strengthening splay", "0.005"),
    Case("subduction_3d", "Subduction zone with 200 km of coast", "subduction", 20,
         in_space((1,)), SOURCE, mesh=mesh("subduction_3d", "4e3"), settings=(MOST + "1",),
         in_index=IN_INDEX),
    Case("subduction_3d_fixed", "The same, fixed normal stress", "subduction", 20,
         in_space((1,)), SOURCE, deck="subduction_3d",
         settings=(FIXED, MOST + "1")),
)

CASES = MEGATHRUST + SUBDUCTION + MANTLE + YIELDING
