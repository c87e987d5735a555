"""The stress of an antiplane strip 0 < y < H whose lower side moves by u = d cos(kx).

    u = d cos(kx) sinh(k(H - y)) / sinh(kH),  sigma_xz = G du/dx,  sigma_yz = G du/dy

In cells of constant strain the error in L2 halves with the size of the cells.
"""

import pathlib
import sys

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("strip.xml")
MODULUS, HEIGHT, K, MOTION = 1e6, 0.5, 2 * numpy.pi, 1e-4  # Pa, m, 1/m, m
CELLS = (8, 16, 32)
LEAST_ORDER, LARGEST_ERROR = 0.95, 0.05  # of the finest, in L2, as a share of the stress


def exact(x):
    """(..., 2) sigma_xz and sigma_yz at places (..., 2)."""
    factor = MODULUS * MOTION * K / numpy.sinh(K * HEIGHT)
    phase, depth = K * x[..., 0], K * (HEIGHT - x[..., 1])
    return numpy.stack([-factor * numpy.sin(phase) * numpy.sinh(depth),
                        -factor * numpy.cos(phase) * numpy.cosh(depth)], axis=-1)


def relative_error(history):
    """In L2, by the midpoints of the edges, which is exact for squares of linear functions."""
    corners = history["geometry/coordinates"][history["geometry/connectivity"]]
    midpoints = (corners + numpy.roll(corners, 1, axis=1)) / 2
    sides = corners[:, 1:] - corners[:, :1]
    area = numpy.abs(numpy.linalg.det(sides)) / 2
    expected = exact(midpoints)
    error = history["fields/stress"][-1][:, None] - expected
    return numpy.sqrt(numpy.sum(area * (error**2).mean(axis=1).sum(axis=1)) /
                      numpy.sum(area * (expected**2).mean(axis=1).sum(axis=1)))


def main():
    errors = []
    for cells in CELLS:
        folder = asperity_run.run_to_end(f"strip_{cells}", DECK, *asperity_run.settings(
            f"Mesh/Rectangle/Cells X={cells}", f"Mesh/Rectangle/Cells Y={cells}"))
        history = asperity_run.series(folder / "volume.h5")
        errors.append(relative_error(history))
        # On an upright plane slip of the side +x along +z is driven by sigma_xz.
        numpy.testing.assert_allclose(history["fields/coulomb_stress_change_upright"],
                                      history["fields/stress"][..., 0], atol=1e-9)
    orders = numpy.log2(numpy.divide(errors[:-1], errors[1:]))
    print("relative errors in L2", errors, "orders", orders)
    return 0 if orders.min() >= LEAST_ORDER and errors[-1] <= LARGEST_ERROR else 1


if __name__ == "__main__":
    sys.exit(main())
