"""Meshes that the decks in xml/ read from files."""

import pathlib
import subprocess
import xml.etree.ElementTree as ElementTree

import asperity_run
import time_limits

MESH_TOOL = asperity_run.PROGRAM.with_name("asperity-mesh")  # there only where Gmsh is
DECKS = sorted((asperity_run.SOURCE / "xml").glob("*.xml"))


def meshes_of(deck):
    """The mesh files X.h5 that a deck reads; each is made from the geometry meshes/X.geo."""
    entries = ElementTree.parse(deck).getroot().iter("Parameter")
    return [entry.get("value") for entry in entries if entry.get("name") == "File Name"]


def make_meshes(deck, *arguments):
    for mesh in meshes_of(deck):
        geometry = deck.parent / "meshes" / mesh.replace(".h5", ".geo")
        pathlib.Path(mesh).unlink(missing_ok=True)  # of an earlier run of the test
        subprocess.run([MESH_TOOL, "convert", geometry, mesh, *arguments], check=True,
                       capture_output=True, timeout=time_limits.seconds(60))
