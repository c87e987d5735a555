"""Runs of a wedge in space, for the tests of this folder."""

import pathlib

import asperity_run
from asperity_run import settings

HERE = pathlib.Path(__file__).parent
DECK = HERE.parent / "parallel" / "coarse_wedge.xml"
RUPTURE = ["--overlay", HERE.parent / "parallel" / "rupture.xml"]
GLASS = ["--overlay", HERE / "glass_wedge.xml"]
PERIODIC = ["--overlay", HERE / "periodic_wedge.xml"]


def from_file(name):
    return settings("Mesh/Type=File", f"Mesh/File/File Name={name}")


def run_deck(name, *changes, ranks=1):
    """The folder of a run that must succeed; on an overloaded machine it takes its time."""
    return asperity_run.run_to_end(name, DECK, *changes, ranks=ranks, timeout=300)
