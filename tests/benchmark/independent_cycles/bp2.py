"""SEAS BP2-QD: events by the deck, against what boundary elements converge to."""

import sys

import asperity_run
from sequence import YEAR, check, sequence, slip_in_events

DECK = asperity_run.SOURCE / "xml" / "bp2_qd.xml"
END = 240 * YEAR  # three events
ONSETS = (151.2, 208.9, 233.1)  # yr


def main():
    folder = asperity_run.run_to_end("bp2", DECK, "--set", f"Time Stepping/Final Time={END}",
                                     timeout=14000)
    found = sequence(folder)
    fine = len(found) == len(ONSETS)
    for event, onset in zip(found, ONSETS):
        fine = check("onset [yr]", event[0]["onset"] / YEAR, onset, 0.005) and fine
    first, second, third = slip_in_events(folder, "dp000")[:3]
    fine = check("slip of event 2 at the surface [m]", second, 3.31, 0.02) and fine
    print(f"slip of the buried events 1 and 3 at the surface: {first:.3g} and {third:.3g} m")
    return not (fine and max(first, third) < 0.01)


if __name__ == "__main__":
    sys.exit(main())
