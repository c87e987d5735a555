"""The problems of SEAS, sequences of earthquakes and aseismic slip."""

from dataclasses import replace
from typing import Tuple

from .columns import (PEAK_RATE, TIME, Column, displacement, is_positive, log_rate, log_state,
                      moment_rate, place, pressure, slip, starts_above, stress, velocity)
from .problem import PLACES, PROFILE, FileKind, Problem

RUN = ("problem", "author|modeler", "date", "code", "element_size")
STATION = (*RUN, "location")
SHEAR = (is_positive, starts_above(5.0))


def _stations(what: str, name: str, *columns: Column, is_needed: bool = True) -> FileKind:
    return FileKind(what, name, (TIME, *columns), STATION, is_needed=is_needed, is_station=True)


def _global(*units: str, is_needed: bool = True) -> FileKind:
    return FileKind("global quantities", r"global\.dat", (TIME, PEAK_RATE, moment_rate(*units)),
                    RUN, is_needed=is_needed)


def _on_fault(name: str, *between: Column) -> FileKind:
    return _stations("station on the fault", name, slip("slip", is_positive),
                     log_rate("slip_rate"), stress("shear_stress", *SHEAR), *between,
                     log_state("state"))


def _depths(*tenths_of_km: int) -> Tuple[Tuple[str, ...], ...]:
    return tuple((f"fltst_dp{depth:03d}",) for depth in tenths_of_km)


SLIP = FileKind("slip along the fault", r"slip\.dat",
                (TIME, PEAK_RATE, Column("slip", ("m",), -1e3, 1e3)), RUN, PROFILE)
RUPTURE = FileKind("rupture times", r"rupture\.dat", (place("x2"), place("x3"), TIME), RUN,
                   PLACES)
RUPTURE_IN_PLANE = replace(RUPTURE, is_needed=False)
DOWN_DIP = r"fltst_dp\d{3}"
BODY = _stations("station in the body", r"blkst_\S+", displacement("disp"), velocity("vel"),
                 is_needed=False)
SURFACE = _stations("station at the surface", r"srfst_fn[+-]\d{2}", displacement("disp_1"),
                    displacement("disp_2"), velocity("vel_1"), velocity("vel_2"))
NORMAL = stress("normal_stress", *SHEAR)
FIRST_GLOBAL = _global("N/s", is_needed=False)  # the first problems do without
ANTIPLANE = (_on_fault(DOWN_DIP), BODY, FIRST_GLOBAL, SLIP, RUPTURE_IN_PLANE)
BP1 = _depths(0, 25, 50, 75, 100, 125, 150, 175, 200, 250, 300, 350)
BP3 = BP1 + tuple((f"srfst_fn{x}",) for x in ("-32", "-16", "-08", "-00", "+00", "+08", "+16",
                                               "+32"))


def _in_space(digits: int, *between: Column) -> FileKind:
    return _stations(
        "station on the fault", rf"fltst_strk[+-]\d{{{digits}}}dp[+-]\d{{{digits}}}",
        slip("slip_2", is_positive), slip("slip_3"), log_rate("slip_rate_2"),
        log_rate("slip_rate_3"), stress("shear_stress_2", *SHEAR), stress("shear_stress_3"),
        *between, log_state("state"))


BODY_IN_SPACE = _stations(
    "station in the body", r"blkst_strk[+-]\d{2}fn[+-]\d{2}dp[+-]\d{2}",
    *(displacement(f"disp_{i}") for i in (1, 2, 3)), *(velocity(f"vel_{i}") for i in (1, 2, 3)),
    is_needed=False)
SPACE = (BODY_IN_SPACE, _global("N m/s", "N-m/s"), RUPTURE)
BP5 = tuple((f"fltst_strk{strike}dp{dip}",) for strike, dip in (
    ("-36", "+00"), ("-16", "+00"), ("+00", "+00"), ("+16", "+00"), ("+36", "+00"),
    ("-24", "+10"), ("-16", "+10"), ("+00", "+10"), ("+16", "+10"), ("+00", "+22")))


def _around_the_middle(*metres: int) -> Tuple[Tuple[str, ...], ...]:
    return tuple((f"fltst_strk{strike:+04d}dp{dip:+04d}",) for strike in metres for dip in metres)


BP7 = _around_the_middle(0, 100, -100) + tuple((f"fltst_{name}",) for name in (
    "strk+300dp+000", "strk-300dp+000", "strk+000dp+300", "strk+000dp-300"))
BP8 = _around_the_middle(0, 200, -200)

# The well lies in a plane of symmetry.
BP6 = tuple((f"fltst_strk{z}",) for z in ("+00", "+05", "+10", "+25", "+35", "+50", "+75")) + (
    ("fltst_strk+15", "fltst_strk-15"),)


def _darcy(name: str) -> Column:
    return Column(name, ("m/s",), -1.0, 1.0)


WATER = pressure("pore_pressure")
WITH_WATER = _on_fault(r"fltst_strk[+-]\d{2}", WATER, _darcy("darcy_vel"))

PROBLEMS = (
    Problem(("BP1-QD", "BP1-FD"), "SEAS", ANTIPLANE, BP1),
    Problem(("BP2-QD",), "SEAS", ANTIPLANE),
    Problem(("BP3-QD",), "SEAS",
            (_on_fault(DOWN_DIP, NORMAL), SURFACE, FIRST_GLOBAL, SLIP, RUPTURE_IN_PLANE), BP3),
    Problem(("BP5-QD", "BP5-FD"), "SEAS", (_in_space(2), *SPACE), BP5),
    Problem(("BP6-QD-A", "BP6-QD-S", "BP6-A", "BP6-S"), "SEAS",
            (WITH_WATER, _global("N/s"), SLIP, RUPTURE_IN_PLANE), BP6),
    Problem(("BP7-QD-A", "BP7-QD-S", "BP7-FD-A"), "SEAS", (_in_space(3), *SPACE), BP7),
    Problem(("BP8-QD-GS",), "SEAS",
            (_in_space(3, WATER, _darcy("darcy_vel_2"), _darcy("darcy_vel_3")), *SPACE), BP8),
)
