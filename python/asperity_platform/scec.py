"""SCEC, spontaneous ruptures: its files and its problems."""

from typing import Tuple

from .columns import (TIME, Column, Directions, displacement, is_positive, log_state,
                      normal_stress, places_and_arrival, pressure, rate, shear_stress, slip,
                      starts_above, velocity)
from .model import Model
from .problem import OFF_FAULT, ON_FAULT, RUPTURE, FileKind, Platform, Problem

RUN = ("problem", "author", "date", "code", "element_size")
STATION = (*RUN, "time_step", "num_time_steps", "location")
LOADED = (is_positive, starts_above(5.0))
STATES = {"theta": (log_state("log-theta", "log10 of state variable", "log-seconds", "log10 s"),),
          "psi": (Column("psi", "state variable psi", "psi", ("dimensionless",), -5.0, 5.0),),
          "": ()}
HEAT = (Column("temperature", "temperature", "temperature", ("K", "Kelvin", "degrees Kelvin"),
               200.0, 5000.0), pressure("pressure", "pore pressure", "fluid_pressure"))
AXES = {"h": "horizontal", "v": "vertical", "n": "normal"}
ANY = r"\S+"


def _on_fault(model: Model) -> Tuple[Column, ...]:
    """The normal stress is the effective one where pressure follows from heat."""
    velocities = "slip_velocity" if model.in_space else "slip_rate"
    normal = ("effective normal stress", "effective_normal_stress") if model.has_heat \
        else ("normal stress", "normal_stress")
    return (TIME, slip("h-slip", "horizontal slip", "h", is_positive),
            rate("h-slip-rate", "horizontal slip rate", velocities, "h", is_positive),
            shear_stress("h-shear-stress", "horizontal shear stress", "h", *LOADED),
            slip("v-slip", "vertical slip", "v"),
            rate("v-slip-rate", "vertical slip rate", velocities, "v"),
            shear_stress("v-shear-stress", "vertical shear stress", "v"),
            normal_stress("n-stress", *normal, *LOADED), *STATES[model.state],
            *(HEAT if model.has_heat else ()))


MOTION = (TIME, *(make(f"{axis}-{name}", f"{words} {what}", axis) for axis, words in AXES.items()
                  for make, name, what in ((displacement, "disp", "displacement"),
                                           (velocity, "vel", "velocity"))))


def _files(model: Model, place: str = ANY, off_fault: str = ANY) -> Tuple[FileKind, ...]:
    """`place`: a regular expression; that of a station in the body follows `off_fault`."""
    return (FileKind("station on the fault", ON_FAULT, "fault", _on_fault(model), STATION, place),
            FileKind("station in the body", OFF_FAULT, "body", MOTION, STATION, off_fault, False),
            FileKind("rupture times", RUPTURE, "cplot", places_and_arrival("j", "k", 1e9), RUN))


def _directions(model: Model, source: str) -> Directions:
    """h is along strike, v down dip, in the body straight down, n from the fault into the body.
    A plane has two of them."""
    if model.in_space:
        return {"h": model.along("strike"), "n": model.along("inward"),
                "v": model.along("dip" if source == ON_FAULT else "down")}
    if source == ON_FAULT or model.antiplane:
        return {"h" if model.antiplane or model.is_level else "v": (1.0,)}
    return {"h": (1.0, 0.0), "n": (0.0, 1.0)} if model.is_level \
        else {"v": (0.0, 1.0), "n": (1.0, 0.0)}


STRIKE, DEPTH = r"st-?\d{3}", r"dp\d{3}"


def _problem(names: Tuple[str, ...], model: Model,
             stations: Tuple[Tuple[str, ...], ...] = ()) -> Problem:
    place = STRIKE + DEPTH
    return Problem(names, _files(model, place, r"-?\d{3}" + place), stations, "fault" + place)


def _plane(name: str, state: str) -> Problem:
    return Problem((name,), _files(Model(state=state), STRIKE, r"-?\d{3}" + STRIKE))


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
    _problem(("TPV5", "TPV205"), Model(in_space=True, state=""), TPV205),
    _plane("TPV5", ""),
    _problem(("TPV101",), Model(in_space=True), TPV101),
    _plane("TPV101", "theta"),
    _problem(("TPV103",), Model(in_space=True, state="psi")),
    _plane("TPV103", "psi"),
    _problem(("TPV104",), Model(in_space=True, state="psi"), TPV104),
    _problem(("TPV105", "TPV105-3D"), Model(in_space=True, state="psi", has_heat=True), TPV105),
)
PLATFORM = Platform("SCEC", "TPV", PROBLEMS, _files, _directions, has_equal_steps=True)
