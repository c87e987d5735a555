"""xml/spring_slider.xml: the earthquakes of the soft spring one by one, and none of the stiff."""

import sys

import asperity_run
import exact_slider
from sequence import agree

DECK = asperity_run.SOURCE / "xml" / "spring_slider.xml"
FINAL_TIME, THRESHOLD = 10000, 1e-3
TOLERANCE = {"onset": 3e-2, "peak slip rate": 2e-2, "slip": 2e-2}


def recurrences(events):
    return [(second[0] - first[0],) for first, second in zip(events, events[1:])]


def soft():
    folder = asperity_run.run_to_end("soft", DECK)
    found = [(row["onset"], row["peak_slip_rate"], row["peak_slip"])
             for row in asperity_run.table(folder / "events.csv")]
    expected = exact_slider.events(exact_slider.solve(FINAL_TIME), THRESHOLD)
    print("soft:")
    one_by_one = agree(found, expected, TOLERANCE)
    in_time = agree(recurrences(found), recurrences(expected), {"recurrence": 1.5e-2})
    return len(expected) == 5 and one_by_one and in_time


def stiff():
    folder = asperity_run.run_to_end("stiff", DECK, "--set", "Bulk/Shear Modulus=5e9")
    num_events = len(asperity_run.table(folder / "events.csv"))
    last = asperity_run.table(folder / "steps.csv")[-1]["peak_slip_rate"]
    print(f"stiff: {num_events} events, slip rate {last:.7g} m/s at the end")
    return num_events == 0 and abs(last / exact_slider.V_DRIVE - 1) < 1e-4


def main():
    passed = [soft(), stiff()]
    return 0 if all(passed) else 1


if __name__ == "__main__":
    sys.exit(main())
