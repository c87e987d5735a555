"""SEAS, sequences of earthquakes and aseismic slip: its files and its problems."""

from typing import Tuple

from .columns import (PEAK_RATE, TIME, Column, Directions, displacement, is_positive, log_rate,
                      log_state, moment_rate, normal_stress, places_and_arrival, pressure, slip,
                      slip_at_nodes, shear_stress, starts_above, velocity)
from .model import Model
from .problem import (OFF_FAULT, ON_FAULT, PROFILES, RUPTURE, TOTALS, FileKind, Platform, Problem)

RUN = ("problem", "author|modeler", "date", "code", "element_size")
STATION = (*RUN, "location")
SHEAR = (is_positive, starts_above(5.0))
STATE = log_state("state", "State", "log10 s", "log-seconds")
PORE_PRESSURE = pressure("pore_pressure", "Pore pressure", "pore_pressure")
ANY = r"\S+"


def _darcy(name: str, words: str, along: str) -> Column:
    return Column(name, words, "darcy_velocity", ("m/s",), -1.0, 1.0, along=along)


def _on_fault(model: Model) -> Tuple[Column, ...]:
    if not model.in_space:
        normal = () if model.antiplane else (
            normal_stress("normal_stress", "Normal stress", "normal_stress", *SHEAR),)
        water = (PORE_PRESSURE, _darcy("darcy_vel", "Darcy velocity down", "3")) \
            if model.has_water and model.antiplane else ()
        return (TIME, slip("slip", "Slip", "slip", is_positive), log_rate("slip_rate", "Slip rate"),
                shear_stress("shear_stress", "Shear stress", "slip", *SHEAR), *normal, *water,
                STATE)
    water = (PORE_PRESSURE, _darcy("darcy_vel_2", "Darcy velocity along strike", "2"),
             _darcy("darcy_vel_3", "Darcy velocity down dip", "3")) if model.has_water else ()
    return (TIME, slip("slip_2", "Slip along strike", "2", is_positive),
            slip("slip_3", "Slip down dip", "3"),
            log_rate("slip_rate_2", "Slip rate along strike", "2"),
            log_rate("slip_rate_3", "Slip rate down dip", "3"),
            shear_stress("shear_stress_2", "Shear stress along strike", "2", *SHEAR),
            shear_stress("shear_stress_3", "Shear stress down dip", "3"), *water, STATE)


def _off_fault(model: Model) -> Tuple[Column, ...]:
    if model.in_space:
        axes = {"1": " from the fault", "2": " along strike", "3": " down"}
    else:
        axes = {"": ""} if model.antiplane else {"1": " 1", "2": " 2"}
    return (TIME, *(make(name + (axis and f"_{axis}"), what + words, axis)
                    for make, name, what in ((displacement, "disp", "Displacement"),
                                             (velocity, "vel", "Velocity"))
                    for axis, words in axes.items()))


def _files(model: Model, on_fault: str = ANY, off_fault: str = ANY, needs_totals: bool = True,
           needs_body: bool = False) -> Tuple[FileKind, ...]:
    """`on_fault`, `off_fault`: regular expressions for places. Stations of the problem in plane
    strain are at the surface, hence srfst_."""
    surface = not model.in_space and not model.antiplane
    profile = () if model.in_space else (
        FileKind("slip along the fault", PROFILES, "slip.dat",
                 (TIME, PEAK_RATE, slip_at_nodes("slip")), RUN),)
    return (FileKind("station on the fault", ON_FAULT, "fltst_", _on_fault(model), STATION,
                     on_fault),
            FileKind("station at the surface" if surface else "station in the body", OFF_FAULT,
                     "srfst_" if surface else "blkst_", _off_fault(model), STATION, off_fault,
                     needs_body),
            FileKind("global quantities", TOTALS, "global.dat",
                     (TIME, PEAK_RATE, moment_rate(model.in_space)), RUN, is_needed=needs_totals),
            *profile,
            FileKind("rupture times", RUPTURE, "rupture.dat", places_and_arrival("x2", "x3", 1e15),
                     RUN, is_needed=model.in_space))


def _directions(model: Model, source: str) -> Directions:
    """1 is from the fault into the body, 2 along strike, 3 down dip, in the body straight down;
    positive slip of a fault in two dimensions is that of a thrust."""
    if model.in_space:
        return {"1": model.along("inward"), "2": model.along("strike"),
                "3": model.along("dip" if source == ON_FAULT else "down")}
    if source == ON_FAULT:
        return {"slip": (model.thrust_sign,), "3": (0.0, -1.0)}
    if model.antiplane:
        return {"": (1.0,)}
    return {"1": (1.0, 0.0), "2": (0.0, 1.0) if model.is_level else (0.0, -1.0)}


ANTIPLANE, SPACE = Model(antiplane=True), Model(in_space=True)
DOWN_DIP = r"dp\d{3}"
FIRST = _files(ANTIPLANE, DOWN_DIP, needs_totals=False)  # the first problems do without global.dat


def _depths(*tenths_of_km: int) -> Tuple[Tuple[str, ...], ...]:
    return tuple((f"fltst_dp{depth:03d}",) for depth in tenths_of_km)


BP1 = _depths(0, 25, 50, 75, 100, 125, 150, 175, 200, 250, 300, 350)
BP3 = BP1 + tuple((f"srfst_fn{x}",) for x in ("-32", "-16", "-08", "-00", "+00", "+08", "+16",
                                               "+32"))
BP5 = tuple((f"fltst_strk{strike}dp{dip}",) for strike, dip in (
    ("-36", "+00"), ("-16", "+00"), ("+00", "+00"), ("+16", "+00"), ("+36", "+00"),
    ("-24", "+10"), ("-16", "+10"), ("+00", "+10"), ("+16", "+10"), ("+00", "+22")))
# The well lies in a plane of symmetry.
BP6 = tuple((f"fltst_strk{z}",) for z in ("+00", "+05", "+10", "+25", "+35", "+50", "+75")) + (
    ("fltst_strk+15", "fltst_strk-15"),)


def _around_the_middle(*metres: int) -> Tuple[Tuple[str, ...], ...]:
    return tuple((f"fltst_strk{strike:+04d}dp{dip:+04d}",) for strike in metres for dip in metres)


BP7 = _around_the_middle(0, 100, -100) + tuple((f"fltst_{name}",) for name in (
    "strk+300dp+000", "strk-300dp+000", "strk+000dp+300", "strk+000dp-300"))
BP8 = _around_the_middle(0, 200, -200)


def _in_space(digits: int, model: Model = SPACE) -> Tuple[FileKind, ...]:
    return _files(model, rf"strk[+-]\d{{{digits}}}dp[+-]\d{{{digits}}}",
                  r"strk[+-]\d{2}fn[+-]\d{2}dp[+-]\d{2}")


PROBLEMS = (
    Problem(("BP1-QD", "BP1-FD"), FIRST, BP1),
    Problem(("BP2-QD",), FIRST),
    Problem(("BP3-QD",), _files(Model(), DOWN_DIP, r"fn[+-]\d{2}", needs_totals=False,
                                needs_body=True), BP3),
    Problem(("BP5-QD", "BP5-FD"), _in_space(2), BP5),
    Problem(("BP6-QD-A", "BP6-QD-S", "BP6-A", "BP6-S"),
            _files(Model(antiplane=True, has_water=True), r"strk[+-]\d{2}"), BP6),
    Problem(("BP7-QD-A", "BP7-QD-S", "BP7-FD-A"), _in_space(3), BP7),
    Problem(("BP8-QD-GS",), _in_space(3, Model(in_space=True, has_water=True)), BP8),
)
PLATFORM = Platform("SEAS", "BP", PROBLEMS, _files, _directions)
