"""How a disturbance of steady sliding grows in strip.xml, against the characteristic equation."""

import dataclasses
import math
import pathlib
import sys

import asperity_run
import linear_body
import modes
import numpy
import steady_sliding

HERE = pathlib.Path(__file__).parent
Q, HEIGHT, POISSON = 2 * math.pi, 0.5, 0.25
FAULT = steady_sliding.Fault(a=0.010, b=0.015, L=1e-5, sigma=1e4, V=1e-4)
V_STAR, MU_STAR = 1e-6, 0.6
STEADY_ALPHA = math.log(V_STAR / FAULT.V)
STEADY_FRICTION = FAULT.sigma * FAULT.a * math.asinh(
    FAULT.V / (2 * V_STAR) * math.exp((MU_STAR + FAULT.b * STEADY_ALPHA) / FAULT.a))
TOLERANCE = 1e-2  # of the growth rate and of the frequency; 40 cells a wavelength

# The traction per slip of a half space at rest is this times G q.
PER_SLIP = {
    "Antiplane": 1 / 2,
    "Plane Strain": 1 / (2 * (1 - POISSON)),
    "Bilateral": 4 * (1 - POISSON) / (3 - 4 * POISSON),
}

# law of bulk: entries of the deck in units of the shear modulus, and the modulus at the rate s
LAWS = {
    "Kelvin-Voigt": (("Shear Viscosity",), lambda s, time: 1 + time * s),
    "Maxwell": (("Viscosity",), lambda s, time: 1 / (1 + 1 / (time * s))),
    "Burgers": (("Viscosity", "Transient Viscosity", "Transient Shear Modulus"),
                lambda s, time, transient, modulus:
                1 / (1 + 1 / (time * s) + 1 / (modulus + transient * s))),
}


@dataclasses.dataclass(frozen=True)
class Case:
    model: str               # a key of PER_SLIP
    dynamics: str            # Static, Quasi-dynamic or Inertial
    stiffness: float         # of a half space at rest, over the critical one without damping
    state_law: str = "Ageing"
    final_time: float = 3
    wave_speed: float = 1    # of shear waves, m/s
    damping: float = None    # eta in Pa s/m; None: left to the deck's default
    law: str = "Kelvin-Voigt"  # a key of LAWS
    of_law: tuple = (0,)     # its entries over the shear modulus, s and -
    scheme: str = "Generalised Alpha"

    def __str__(self):
        details = [f"{self.model}, {self.dynamics}, {self.stiffness:g} k_c, {self.state_law}"]
        if self.dynamics != "Static":
            details.append(f"c = {self.wave_speed:g} m/s")
        if self.damping is not None:
            details.append(f"eta = {self.damping:g} Pa s/m")
        if any(self.of_law):
            details.append(f"{self.law} {self.of_law}")
        return ", ".join(details)

    @property
    def slip_factor(self):
        return 1 if self.model == "Bilateral" else 2

    @property
    def shear_modulus(self):
        return self.stiffness * FAULT.critical_stiffness() / (PER_SLIP[self.model] * Q)

    @property
    def radiation_damping(self):
        """G / c per velocity of the body, and half of it per slip rate of a two-sided fault."""
        if self.damping is not None:
            return self.damping
        default = self.shear_modulus / self.wave_speed / self.slip_factor
        return default if self.dynamics == "Quasi-dynamic" else 0

    def stiffness_at(self, s):
        """K(s) + eta s per slip."""
        density = self.shear_modulus / self.wave_speed**2 if self.dynamics == "Inertial" else 0
        G = self.shear_modulus * LAWS[self.law][1](s, *self.of_law)
        if self.model == "Antiplane":
            body = linear_body.Antiplane(Q, HEIGHT, G, density)
        else:
            bulk = 2 * self.shear_modulus * (1 + POISSON) / (3 * (1 - 2 * POISSON))  # elastic
            poisson = (3 * bulk - 2 * G) / (2 * (3 * bulk + G))
            free_normal = self.model == "Plane Strain"
            body = linear_body.PlaneStrain(Q, HEIGHT, G, density, poisson, free_normal)
        return body.stiffness(s) / self.slip_factor + self.radiation_damping * s

    def options(self):
        """What the program has to be told about strip.xml."""
        v = FAULT.V / self.slip_factor
        settings = {
            "Bulk/Shear Modulus": self.shear_modulus,
            "Bulk/Density": self.shear_modulus / self.wave_speed**2,
            "Bulk/Law": self.law,
            **{f"Bulk/{name}": value * self.shear_modulus
               for name, value in zip(LAWS[self.law][0], self.of_law)},
            "Bulk/Dynamics": "Inertial" if self.dynamics == "Inertial" else "Quasi-dynamic",
            "Friction/State Evolution": self.state_law,
            "Friction/Shear Traction": STEADY_FRICTION + self.radiation_damping * FAULT.V,
            "Boundary Conditions/Drive/Velocity": v,
            "Time Stepping/Scheme": self.scheme,
            "Time Stepping/Final Time": self.final_time,
        }
        damping = 0 if self.dynamics == "Static" else self.damping
        if damping is not None:
            settings["Bulk/Quasi-dynamic/Radiation Damping"] = damping
        if self.model == "Bilateral":
            settings["Boundary Conditions/Fault/Type"] = "Bilateral Contact"
        component = "Z" if self.model == "Antiplane" else "X"
        settings[f"Initial State/Velocity {component}"] = v
        overlay = [] if self.model == "Antiplane" else ["--overlay", HERE / "plane_strain.xml"]
        return [*overlay, *asperity_run.settings(settings)]


# Antiplane, without mass and damping, the rates are 1.75 + 3.5 i for 0.3 k_c, 1.25 + 4.9 i for 0.5,
# -1.3 + 8.6 i for 1.5 and -2.5 + 9.7 i for 2; in the plane they differ little.
CASES = [
    Case("Antiplane", "Static", 0.5),
    Case("Antiplane", "Static", 2, "Slip", 2),
    Case("Plane Strain", "Static", 0.5, "Slip"),
    Case("Plane Strain", "Static", 2.5, "Ageing", 1.5),
    Case("Bilateral", "Static", 0.5),
    Case("Bilateral", "Static", 2, "Slip", 2),
    Case("Antiplane", "Quasi-dynamic", 0.3, wave_speed=2),
    Case("Antiplane", "Quasi-dynamic", 1.5, "Slip", 2, damping=1.5e5, wave_speed=20),
    Case("Plane Strain", "Quasi-dynamic", 0.4, "Slip", wave_speed=2),
    Case("Bilateral", "Quasi-dynamic", 1.5, "Ageing", 2, wave_speed=2),
    Case("Antiplane", "Inertial", 0.5),
    Case("Antiplane", "Inertial", 2, "Slip", wave_speed=2, scheme="Newmark"),
    # what slides stably without mass does not with it
    Case("Antiplane", "Inertial", 1.5, final_time=8),
    Case("Plane Strain", "Inertial", 0.5, "Slip"),
    Case("Bilateral", "Inertial", 0.5),
    Case("Antiplane", "Static", 0.5, of_law=(0.03,)),
    Case("Antiplane", "Static", 0.5, law="Maxwell", of_law=(0.5,)),
    Case("Antiplane", "Inertial", 0.5, law="Maxwell", of_law=(1,)),
    Case("Bilateral", "Static", 0.5, law="Maxwell", of_law=(0.5,)),
    Case("Plane Strain", "Quasi-dynamic", 0.4, "Slip", wave_speed=4, law="Burgers",
         of_law=(4, 0.5, 1)),
    Case("Bilateral", "Inertial", 0.6, law="Burgers", of_law=(2, 0.2, 0.5)),
]


def amplitude(history):
    """Of cos(qx) in alpha, at all times."""
    wave = numpy.cos(Q * history["geometry/coordinates"][:, 0])
    weights = history["geometry/weights"] * wave
    return (history["fields/alpha"] - STEADY_ALPHA) @ weights / (weights @ wave)


def check(number, case):
    expected = steady_sliding.rates(FAULT, case.stiffness_at)[0]
    folder = asperity_run.run_to_end(f"case_{number}", HERE / "strip.xml", *case.options())
    history = asperity_run.series(folder / "fault.h5")
    t, y = history["time"], amplitude(history)
    settled = t > case.final_time / 4
    found = modes.lasting(t[settled], y[settled])
    errors = found.real / expected.real - 1, found.imag / expected.imag - 1
    print(f"{case}:\n  s = {found:.4f} / s, expected {expected:.4f}: "
          f"{errors[0]:+.2%} of the growth rate, {errors[1]:+.2%} of the frequency", flush=True)
    return max(map(abs, errors)) <= TOLERANCE


def main():
    passed = [check(number, case) for number, case in enumerate(CASES)]
    return passed.count(False)


if __name__ == "__main__":
    sys.exit(main())
