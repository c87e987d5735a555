"""Meshes that the decks in xml/ read from files."""

import pathlib
import xml.etree.ElementTree as ElementTree

import asperity_run
from mesh_files import mesh_tool

DECKS = sorted((asperity_run.SOURCE / "xml").glob("*.xml"))


def meshes_of(deck):
    """The mesh files X.h5 that a deck reads; each is made from the geometry meshes/X.geo."""
    entries = ElementTree.parse(deck).getroot().iter("Parameter")
    return [entry.get("value") for entry in entries if entry.get("name") == "File Name"]


def make_meshes(deck, *arguments):
    for mesh in meshes_of(deck):
        geometry = deck.parent / "meshes" / mesh.replace(".h5", ".geo")
        pathlib.Path(mesh).unlink(missing_ok=True)  # of an earlier run of the test
        mesh_tool("convert", geometry, mesh, *arguments)
