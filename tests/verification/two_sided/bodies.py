"""Runs bodies.xml with other settings, and compares what faults did."""

import pathlib

import asperity_run
import numpy

DECK = pathlib.Path(__file__).with_name("bodies.xml")


def condition(name, boundary, entries):
    """Settings of one condition: its Type and what else it takes."""
    return {f"Boundary Conditions/{name}/{entry}": value
            for entry, value in {"Boundary": boundary, **entries}.items()}


def conditions(**of_boundaries):
    """One on each boundary, named like it."""
    return {entry: value for boundary, entries in of_boundaries.items()
            for entry, value in condition(boundary, boundary, entries).items()}


def prescribed(velocity, *direction):
    entries = {"Type": "Prescribed Velocity", "Velocity": velocity}
    return {**entries, "Direction": array(direction)} if direction else entries


def array(numbers):
    return "{" + ", ".join(map(repr, map(float, numbers))) + "}"


def run(folder, mesh, settings, ranks=1, removed=()):
    """`removed`: paths of entries that the deck then lacks."""
    mesh.write(f"{folder}.h5")
    removals = [word for path in removed for word in ("--remove", path)]
    changes = asperity_run.settings(f"Mesh/File/File Name={folder}.h5", settings)
    return asperity_run.run_to_end(folder, DECK, *removals, *changes, ranks=ranks, timeout=240)


def fields_by_place(folder, names, place=lambda x: x):
    """{name: (num_times, num_nodes, ...)} and the nodes' places, ordered by place(coordinates)."""
    history = asperity_run.series(folder / "fault.h5")
    places = place(history["geometry/coordinates"])
    order = numpy.lexsort(numpy.round(places, 9).T)
    return {name: history[f"fields/{name}"][:, order] for name in names}, places[order]


def energy_increases(folder):
    """How often J rose, over all steps."""
    return sum(row["energy_increases"] for row in asperity_run.table(folder / "steps.csv"))
