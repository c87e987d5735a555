"""The problems of SCEC, spontaneous ruptures."""

from typing import Tuple

from .columns import (TIME, Column, displacement, is_positive, log_state, place, pressure,
                      rate, slip, starts_above, stress, velocity)
from .problem import PLACES, FileKind, Problem

RUN = ("problem", "author", "date", "code", "element_size")
STATION = (*RUN, "time_step", "num_time_steps", "location")
LOADED = (is_positive, starts_above(5.0))
SLIPS = (slip("h-slip", is_positive), rate("h-slip-rate", is_positive),
         stress("h-shear-stress", *LOADED), slip("v-slip"), rate("v-slip-rate"),
         stress("v-shear-stress"), stress("n-stress", *LOADED))
MOTION = tuple(column(f"{direction}-{what}") for direction in "hvn"
               for what, column in (("disp", displacement), ("vel", velocity)))
PSI = Column("psi", ("dimensionless",), -5.0, 5.0)
HOT = (Column("temperature", ("K", "Kelvin", "degrees Kelvin"), 200.0, 5000.0),
       pressure("pressure"))

ARRIVAL = Column("t", ("s",), 0.0, 1e9)  # 1e9: a rupture that never arrives
CONTOURS = FileKind("rupture times", "cplot", (place("j"), place("k"), ARRIVAL), RUN, PLACES)
STRIKE, DEPTH = r"st-?\d{3}", r"dp\d{3}"


def _kinds(place_on_fault: str, *state: Column) -> Tuple[FileKind, ...]:
    return (FileKind("station on the fault", f"fault{place_on_fault}", (TIME, *SLIPS, *state),
                     STATION, is_station=True),
            FileKind("station in the body", r"body-?\d{3}" + place_on_fault, (TIME, *MOTION),
                     STATION, is_needed=False, is_station=True), CONTOURS)


def _problem(names: Tuple[str, ...], *state: Column,
             stations: Tuple[Tuple[str, ...], ...] = ()) -> Problem:
    return Problem(names, "SCEC", _kinds(STRIKE + DEPTH, *state), stations, has_equal_steps=True,
                   mark="fault" + STRIKE + DEPTH)


def _plane(name: str, *state: Column) -> Problem:
    return Problem((name,), "SCEC", _kinds(STRIKE, *state), has_equal_steps=True)


def _faults(*places: str) -> Tuple[Tuple[str, ...], ...]:
    return tuple((f"faultst{place}",) for place in places)


# The whole space is symmetric about the hypocentre, 7.5 km deep.
TPV101 = (("faultst000dp075",), ("faultst090dp075", "faultst-090dp075"),
          ("faultst000dp120", "faultst000dp030"),
          ("faultst120dp120", "faultst-120dp120", "faultst120dp030", "faultst-120dp030"))
TPV205 = _faults(*(f"{along}dp{depth}" for depth in ("000", "075") for along in (
    "-120", "-075", "-045", "000", "045", "075", "120")), "000dp030", "000dp120")
# Both sides of the fault move alike, the other way.
BODY = tuple((f"body{off}st{along}dp000", f"body-{off}st{along}dp000")
             for off, along in (("060", "-120"), ("090", "000"), ("060", "120")))
# The half space is symmetric about the hypocentre, along strike.
TPV104 = (*_faults("000dp030", "000dp075", "000dp120"),
          ("faultst120dp030", "faultst-120dp030"), ("faultst090dp075", "faultst-090dp075"),
          ("faultst120dp120", "faultst-120dp120"), BODY[1], BODY[0] + BODY[2])
TPV105 = _faults("-120dp030", "000dp030", "120dp030", "-180dp075", "-150dp075", "-090dp075",
                 "000dp075", "090dp075", "150dp075", "180dp075", "-120dp120", "000dp120",
                 "120dp120") + BODY

PROBLEMS = (
    _problem(("TPV5", "TPV205"), stations=TPV205),
    _plane("TPV5"),
    _problem(("TPV101",), log_state("log-theta"), stations=TPV101),
    _plane("TPV101", log_state("log-theta")),
    _problem(("TPV103",), PSI),
    _plane("TPV103", PSI),
    _problem(("TPV104",), PSI, stations=TPV104),
    _problem(("TPV105", "TPV105-3D"), PSI, *HOT, stations=TPV105),
)
