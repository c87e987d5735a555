"""A circular fault, as one boundary and in two halves, slips as its closed solution says.

Airy functions of a smooth circle r = R in an endless body under sigma_xy = S, with the mode
sin(2 theta), inside a r^2 + b r^4, outside -S r^2 / 2 + c + d / r^2: no shear traction on either
side, equal sigma_rr and u_r at R give b R^2 = c / R^2 = S / 4 and d / R^4 = -S / 4 and the slip
u_theta(outside) - u_theta(inside) = (1 - nu) S R / G cos(2 theta).

The body is a square 15 times as large as the circle, with 156 cells on this: 2 % are for both.
"""

import pathlib
import shutil
import sys

import asperity_run
import h5py
import mesh_files
import numpy

HERE = pathlib.Path(__file__).parent
R, S, G, NU = 3e3, 1e6, 30e9, 0.25


def worst(folder):
    """Of slip against the solution, over its amplitude; and the amplitude of what is found."""
    with h5py.File(f"{folder}/fault.h5") as file:
        x = file["geometry/coordinates"][:]
        slip = file["fields/slip"][-1].reshape(len(x), -1)[:, 0]
    shape = numpy.cos(2 * numpy.arctan2(x[:, 1], x[:, 0]))
    exact = (1 - NU) * S * R / G
    return abs(slip - exact * shape).max() / exact, 2 * (slip * shape).mean() / exact, len(x)


def main():
    shutil.copy(HERE / "ring.geo", "ring.geo")
    fine = True
    one_name = ["--remove", "Boundary Conditions/Down"]
    text = (HERE / "ring.geo").read_text()
    pathlib.Path("whole.geo").write_text(text.replace(
        'Physical Curve("up") = {1, 2}; Physical Curve("down") = {3, 4};',
        'Physical Curve("up") = {1:4};'))
    for case, more in (("ring", []), ("whole", one_name)):
        mesh_files.mesh_tool("convert", f"{case}.geo", f"{case}.h5", "--overwrite")
        asperity_run.run_to_end(case, HERE / "ring.xml", *asperity_run.settings(
            f"Mesh/File/File Name={pathlib.Path(f'{case}.h5').absolute()}"), *more)
        error, amplitude, nodes = worst(case)
        print(f"{case}: {nodes} nodes, amplitude {amplitude:.4f} of the solution, "
              f"error {error:.4f}")
        fine = fine and error < 0.02 and nodes > 150
    return 0 if fine else 1


if __name__ == "__main__":
    sys.exit(main())
