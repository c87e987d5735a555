"""The velocities behind a shear wave that makes rock yield, plastic_wave.xml: of the velocity V(t)
at the surface the part below k / (rho c) travels at c = sqrt(G / rho), and the rest at the speed
sqrt(Gt / rho) of the tangent modulus 1 / Gt = 1 / G + 1 / H, at a distance d from it
    v = min(V(t - d / c), k / (rho c)) + max(V(t - d / ct) - k / (rho c), 0)
The wave has kinks; its mean error falls faster than the size of cells.
"""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("plastic_wave.xml")
V, RISE, ELASTIC = 0.1, 0.1, 0.03  # m/s, s, m/s
C, CT = 1000.0, 500.0              # m/s
DISTANCES = 250.0, 500.0, 700.0    # m, of the receivers from the top
LARGEST, ORDER = 0.01, 1.0         # of V with the smaller cells; in the size of cells


def exact(t, distance):
    at_surface = lambda since: V * numpy.clip(since / RISE, 0, 1)
    return (numpy.minimum(at_surface(t - distance / C), ELASTIC)
            + numpy.maximum(at_surface(t - distance / CT) - ELASTIC, 0))


def mean_error(cells):
    folder = asperity_run.run_to_end("out", DECK, *asperity_run.settings(
        {"Mesh/Rectangle/Cells Y": cells, "Names/step": 0.4 / cells}), timeout=300)
    history = asperity_run.series(folder / "receivers.h5")
    t, velocity = history["time"], history["off_fault/fields/velocity"]
    assert history["off_fault/fields/inelastic_shear"].max() > 0
    errors = [numpy.abs(velocity[:, i] - exact(t, distance)).mean() / V
              for i, distance in enumerate(DISTANCES)]
    print(f"{cells} cells: {' '.join(f'{error:.3%}' for error in errors)} of V", flush=True)
    return max(errors)


def main():
    coarse, fine = mean_error(100), mean_error(200)
    order = numpy.log2(coarse / fine)
    print(f"order {order:.2f}")
    return 0 if fine < LARGEST and order > ORDER else 1


if __name__ == "__main__":
    sys.exit(main())
