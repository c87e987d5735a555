"""A fault that slides at a constant rate while the fluid in it is heated: the traction of the whole
program against

* the integral equation in time with the exact response to a pulse of heat, for a zone of slip with
  the shape of a normal distribution,
* Rice (2006) for slip on a plane: traction / traction at the start = exp(x) erfc(sqrt(x)) with
  x = slip / L*,
* the exponential fall without diffusion;

the heat of the zone against the work of friction; one rank against two; and what is refused. An
antisymmetric fault, steps that adapt, and slip in space whose direction turns fall alike.
"""

import math
import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("sliding.xml")
FRICTION, SIGMA, PRESSURE, START = 0.6, 1e8, 4e7, 480.0
THERMAL, HYDRAULIC, CAPACITY, PER_KELVIN, WIDTH = 1e-6, 4e-4, 2.7e6, 1e5, 0.02
TRACTION = FRICTION * (SIGMA - PRESSURE)
PROCESS = "Friction/Thermal Pressurisation"
TOLERANCE = 1e-3       # of the traction at the start, and of the rise of temperature
HEAT_TOLERANCE = 1e-9  # of the work of friction; Coupling / Tolerance is 1e-12
RANK_TOLERANCE = 1e-9
DIGITS = 1e-7          # of steps.csv


def history(folder, *changes, ranks=1):
    path = asperity_run.run_to_end(folder, DECK, *asperity_run.settings(*changes), ranks=ranks)
    series = asperity_run.series(path / "receivers.h5")
    fields = {name.split("/")[-1]: numpy.linalg.norm(values[:, 0].reshape(len(values), -1), axis=1)
              for name, values in series.items() if name.startswith("on_fault/fields/")}
    return {"time": series["time"], **fields}, path


def verdict(what, error, tolerance=TOLERANCE):
    fine = bool(error < tolerance)
    print(f"{what}: {error:.1e}, at most {tolerance:.0e}{'' if fine else ' NO'}", flush=True)
    return fine


def pulse(t, hydraulic=HYDRAULIC, thermal=THERMAL):
    """T and p at y = 0 after heat of 1 J/m^2 at t = 0."""
    width = {a: numpy.sqrt(WIDTH**2 + 2 * a * t) for a in (hydraulic, thermal)}
    size = 1 / (math.sqrt(2 * math.pi) * CAPACITY)
    if hydraulic == thermal:
        p = (WIDTH**2 + thermal * t) / width[thermal]**3
    else:
        p = (hydraulic / width[hydraulic] - thermal / width[thermal]) / (hydraulic - thermal)
    return size / width[thermal], size * PER_KELVIN * p


def integral_equation(end, num_steps, **diffusivities):
    """Times, tractions and rise of temperature at V = 1 m/s, by the trapezoidal rule."""
    t = numpy.linspace(0, end, num_steps + 1)
    of_T, of_p = pulse(t, **diffusivities)
    h = end / num_steps
    q, T = numpy.zeros(num_steps + 1), numpy.zeros(num_steps + 1)
    q[0] = TRACTION
    weights = numpy.full(num_steps + 1, h)
    weights[0] = h / 2
    for n in range(1, num_steps + 1):
        past = (weights[:n] * q[:n] * of_p[n:0:-1]).sum()
        q[n] = (TRACTION - FRICTION * past) / (1 + FRICTION * h / 2 * of_p[0])
        T[n] = (weights[:n] * q[:n] * of_T[n:0:-1]).sum() + h / 2 * q[n] * of_T[0]
    return t, q, T


def heat_is_work(what, found, path, share):
    """rho c times the mode of wavenumber 0 is the work of friction on 1 m^2, of which a part
    `share` is that of the modelled side."""
    work = asperity_run.table(path / "steps.csv")[-1]["friction_work"]
    heat = CAPACITY * found["temperature_mode_59"][-1]
    return verdict(f"{what}, heat and work of friction", abs(share * heat / work - 1), DIGITS)


def falls(what, changes, share=1, **diffusivities):
    found, path = history("falls", changes)
    t, q, T = integral_equation(5, 2000, **diffusivities)
    traction, rise = (numpy.interp(found["time"], t, values) for values in (q, T))
    later = found["time"] > 0
    return [verdict(f"{what}, traction", numpy.abs(found["traction"] - traction).max() / TRACTION),
            verdict(f"{what}, temperature", numpy.abs(
                (found["temperature"] - START - rise)[later] / rise[later]).max()),
            verdict(f"{what}, effective normal stress", numpy.abs(
                found["effective_normal_stress"] + found["fluid_pressure"] - SIGMA).max() / SIGMA,
                1e-14),
            heat_is_work(what, found, path, share)]


def on_a_plane():
    """From steps that are short beside the first fall to x = 1.3."""
    length = 4 / FRICTION**2 * (CAPACITY / PER_KELVIN)**2 * (
        math.sqrt(HYDRAULIC) + math.sqrt(THERMAL))**2
    finest = 24
    levels = [finest] * 40 + [level for level in range(finest - 1, 5, -1) for _ in range(20)]
    step = length
    steps = [step * 2.0**-level for level in levels]
    found, _ = history("plane", {
        f"{PROCESS}/Shear Zone Half Width": 1e-7, "Time Stepping/Largest Step": step,
        "Time Stepping/Smallest Step": step * 2.0**-finest,
        "Time Stepping/Prescribed/Levels": "{" + ", ".join(map(str, levels)) + "}",
        "Time Stepping/Final Time": sum(steps)})
    x = found["slip"] / length
    expected = numpy.array([math.exp(v) * math.erfc(math.sqrt(v)) for v in x])
    after = x > 20 * steps[0] / length
    return verdict("slip on a plane", numpy.abs(
        found["traction"] / TRACTION - expected)[after].max())


def without_diffusion():
    found, _ = history("undrained", {f"{PROCESS}/Thermal Diffusivity": 1e-20,
                                     f"{PROCESS}/Hydraulic Diffusivity": 3e-20})
    height = math.sqrt(2 * math.pi) * WIDTH
    expected = numpy.exp(-found["slip"] * FRICTION * PER_KELVIN / (CAPACITY * height))
    return verdict("without diffusion", numpy.abs(found["traction"] / TRACTION - expected).max())


def heat():
    """In each step, rho c times the mode of wavenumber 0 grows by the mean traction times slip."""
    found, _ = history("heat")
    traction = found["traction"]
    work = (traction[1:] + traction[:-1]) / 2 * numpy.diff(found["slip"])
    stored = CAPACITY * numpy.diff(found["temperature_mode_59"])
    return verdict("heat and traction times slip", numpy.abs(stored / work - 1).max(),
                   HEAT_TOLERANCE)


def agree():
    """Two ranks, and one whose body is not condensed to its fault."""
    few = {f"Time Stepping/{size} Step": 0.1 for size in ("Largest", "Smallest")}
    one, _ = history("one_rank", few)
    others = {"two ranks": history("two_ranks", few, ranks=2),
              "not condensed": history("whole_body", few, {"TNNMG/Static Condensation": "Off"})}
    return [verdict(f"{what}, {name}", numpy.abs(other[name] - one[name]).max()
                    / numpy.abs(one[name]).max(), RANK_TOLERANCE)
            for what, (other, _) in others.items() for name in ("traction", "temperature")]


def refused():
    return [asperity_run.refuses(DECK, {f"{PROCESS}/{name}": value}, name)
            for name, value in (("Shear Zone Half Width", 0), ("Hydraulic Diffusivity", -1),
                                ("Volumetric Heat Capacity", 0), ("Wavenumbers", 5))]


def warns():
    """Where the pressure has all of the normal stress, friction is zero and the run says where."""
    result = asperity_run.run(DECK, *asperity_run.settings(
        {"Names/pressure": 1.2e8, "Friction/Shear Traction": 0, "Time Stepping/Final Time": 0.1}),
        "--output", "lost", "--overwrite")
    said = result.stdout + result.stderr
    fine = result.returncode == 0 and "has reached the normal stress, first at (0, 0" in said
    print(f"pressure above the normal stress{'' if fine else ' NO ' + said}")
    return fine


def in_space():
    """The drive turns by 57 degrees."""
    top = {"Boundary": "top", "Type": "Prescribed Velocity"}
    drives = {"Drive": {"Velocity": "cos(t / 5)", "Direction": "{1, 0, 0}"},
              "Across": {"Velocity": "sin(t / 5)", "Direction": "{0, 0, 1}", **top},
              "Up": {"Velocity": 0, "Direction": "{0, 1, 0}", **top}}
    return {"Mesh/Type": "Box", "Mesh/Box/Size": "{1, 1, 1}", "Mesh/Box/Cells X": 2,
            "Mesh/Box/Cells Y": 1, "Mesh/Box/Cells Z": 2, "Bulk/Model": "Solid",
            "Bulk/Poisson's Ratio": 0.25, "Initial State/Velocity X": 1,
            "Initial State/Velocity Z": 0, "Output/Receivers/On Fault/middle": "{0.5, 0, 0.5}",
            **{f"Boundary Conditions/{name}/{key}": value for name, drive in drives.items()
               for key, value in drive.items()}}


def main():
    alike = {f"{PROCESS}/Thermal Diffusivity": 1e-4, f"{PROCESS}/Hydraulic Diffusivity": 1e-4}
    halves = {"Boundary Conditions/Fault/Type": "Antisymmetric Fault",
              "Boundary Conditions/Drive/Velocity": 0.5, "Initial State/Velocity Z": 0.5}
    adaptive = {"Time Stepping/Control": "Richardson", "Time Stepping/Largest Step": 0.1,
                "Time Stepping/Smallest Step": 1e-4, "Time Stepping/Richardson/Tolerance": 1e-4}
    passed = [*refused(), warns(), *falls("normal distribution", {}),
              *falls("equal diffusivities", alike, thermal=1e-4, hydraulic=1e-4),
              *falls("antisymmetric", halves, share=0.5), *falls("adaptive steps", adaptive),
              *falls("in space", in_space()),
              on_a_plane(), without_diffusion(), heat(), *agree()]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
