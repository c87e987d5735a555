"""Runs of a wedge in space and how far their fields lie apart, for the tests of this folder."""

import pathlib
import subprocess

import numpy

import asperity_run
import time_limits
from asperity_run import settings

HERE = pathlib.Path(__file__).parent
DECK = HERE.parent / "parallel" / "coarse_wedge.xml"
RUPTURE = ["--overlay", HERE.parent / "parallel" / "rupture.xml"]
GLASS = ["--overlay", HERE / "glass_wedge.xml"]
PERIODIC = ["--overlay", HERE / "periodic_wedge.xml"]
TOOL = asperity_run.PROGRAM.with_name("asperity-mesh")

FIELDS = [("fault", "slip_rate"), ("fault", "alpha"), ("fault", "slip"), ("fault", "traction"),
          ("volume", "displacement"), ("volume", "velocity")]


def from_file(name):
    return settings("Mesh/Type=File", f"Mesh/File/File Name={name}")


def mesh_tool(*arguments):
    subprocess.run([TOOL, *map(str, arguments)], check=True, capture_output=True,
                   timeout=time_limits.seconds(60))


def run_deck(name, *changes, ranks=1):
    """The folder of a run that must succeed; on an overloaded machine it takes its time."""
    return asperity_run.run_to_end(name, DECK, *changes, ranks=ranks, timeout=300)


def largest_errors(expected, found):
    """{field: largest difference of two runs' outputs over the largest value}; their steps, and
    the order of the vertices, must be the same."""
    errors = {}
    for location, field in FIELDS:
        files = [asperity_run.series(folder / f"{location}.h5") for folder in (expected, found)]
        for name in ("time", "step", "geometry/coordinates", "geometry/vertex_ids"):
            numpy.testing.assert_array_equal(files[0][name], files[1][name], name)
        ours, theirs = (file["fields/" + field] for file in files)
        errors[field] = numpy.abs(theirs - ours).max() / numpy.abs(ours).max()
    return errors
