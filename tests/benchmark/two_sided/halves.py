"""A body with a fault through its middle against its half, halves.py HALF WHOLE, both decks of xml:
events equal to 0.1 percent, with at most 2.2 times the unknowns. Prints what it costs in time."""

import re
import sys
import time

import asperity_run
from sequence import catalogue, check

SAME = ("onset", "end", "peak_slip", "peak_slip_rate", "moment_per_length")
TOLERANCE = 1e-3


def measured(deck):
    """The folder of a run, the vertices of its mesh, and the seconds that it took."""
    start = time.monotonic()
    folder = asperity_run.run_to_end(deck, asperity_run.SOURCE / "xml" / f"{deck}.xml",
                                     timeout=7000)
    seconds = time.monotonic() - start
    vertices = int(re.search(r"(\d+) vertices", (folder / "run.log").read_text())[1])
    return folder, vertices, seconds


def main(half_deck, whole_deck):
    half, half_vertices, half_seconds = measured(half_deck)
    whole, whole_vertices, whole_seconds = measured(whole_deck)
    events = list(zip(catalogue(half), catalogue(whole)))
    fine = bool(events) and len(catalogue(half)) == len(catalogue(whole))
    for number, (expected, found) in enumerate(events, 1):
        for name in SAME:
            fine = check(f"event {number}, {name}", found[name] or 1, expected[name] or 1,
                         TOLERANCE) and fine
    print(f"{whole_vertices / half_vertices:.3f} times the vertices, "
          f"{whole_seconds / half_seconds:.2f} times the seconds")
    return 0 if fine and whole_vertices <= 2.2 * half_vertices else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
