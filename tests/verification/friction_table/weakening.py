"""A steady friction from a table that has been sampled from Strong Rate Weakening: the rupture of
that law, restarts, and tables that are refused."""

import sys

import asperity_run
import h5py
import numpy

DECK = asperity_run.SOURCE / "xml" / "tpv103_2d.xml"
A, B, REFERENCE_RATE, REFERENCE, WEAKENED, WEAKENING_RATE = 0.01, 0.014, 1e-6, 0.6, 0.2, 0.1
FIELDS = {"Output/Receivers/Every n Steps": 1, "Friction/a": A,
          "Mesh/Rectangle/Cell Size Factor": 4, "Time Stepping/Final Time": 2,
          "Time Stepping/Instants": "{1}"}
RATES, FRICTION = "Friction/Table Slip Rate", "Friction/Table Friction"
TABLE = {"Friction/State Evolution": "Tabulated", RATES: "table.h5:/slip_rate",
         FRICTION: "table.h5:/friction"}
OF_THE_LAW = ("Friction/Weakening Slip Rate", "Friction/Weakened Friction Coefficient")
SLIP = 1e-3  # of the largest slip: friction of the table is wrong by less than 1e-4


def steady_friction(rate):
    slow = REFERENCE - (B - A) * numpy.log(rate / REFERENCE_RATE)
    return WEAKENED + (slow - WEAKENED) * (1 + (rate / WEAKENING_RATE)**8)**(-1 / 8)


def write(name, rates, steady, **units):
    with h5py.File(name, "w") as file:
        file["slip_rate"], file["friction"] = rates, steady
        for dataset, unit in units.items():
            file[dataset].attrs["unit"] = unit


def tabulated(*changes):
    """Arguments for the deck with the table."""
    return [*asperity_run.settings(FIELDS, TABLE, *changes),
            *(word for name in OF_THE_LAW for word in ("--remove", name))]


def slip(folder):
    return asperity_run.series(folder / "receivers.h5")["on_fault/fields/slip"]


def verdict(what, error, limit):
    fine = error <= limit
    print(f"{what}: {error:.1e}{'' if fine else f' NOT within {limit:g}'}", flush=True)
    return fine


def rupture():
    law = slip(asperity_run.run_to_end("law", DECK, *asperity_run.settings(
        FIELDS, {OF_THE_LAW[0]: WEAKENING_RATE})))
    table = slip(asperity_run.run_to_end("table", DECK, *tabulated()))
    largest = numpy.abs(law[-1]).max()
    print(f"slip of {largest:.3f} m")
    return table, [verdict("table", numpy.abs(table[-1] - law[-1]).max() / largest, SLIP),
                   largest > 1]


def restart(whole):
    folder = asperity_run.run_to_end("half", DECK, *tabulated({"Time Stepping/Final Time": 1}))
    write("table.h5", RATE, 1.01 * STEADY)
    other = asperity_run.run(DECK, *tabulated(), "--restart", folder / "checkpoint.h5",
                             "--output", folder)
    refused = other.returncode == 2 and "the content of dataset" in other.stderr
    print(f"another table {'refused' if refused else 'NOT refused ' + other.stderr}")
    write("table.h5", RATE, STEADY, slip_rate="m/s", friction="-")
    asperity_run.go_on(folder, DECK, *tabulated())
    found = slip(folder)
    return [refused, verdict("restart", numpy.abs(found[-1] - whole[-1]).max(), 0)]


def refuses(message, *arguments):
    result = asperity_run.run(DECK, *arguments, "--validate")
    fine = result.returncode == 2 and message in result.stderr
    print(f"refused: {message}{'' if fine else ' NO ' + result.stderr}", flush=True)
    return fine


def refused():
    bad = {"decreasing": (RATE[::-1], STEADY, {}, "does not increase from row 0 to row 1"),
           "negative_rate": (-RATE, STEADY, {}, "numbers above zero are wanted"),
           "no_friction": (RATE, 0 * STEADY, {}, "has 0 in row 0; numbers above zero"),
           "nan": (RATE, STEADY + numpy.nan, {}, "has nan in row 0"),
           "short": (RATE, STEADY[:-1], {}, "Two or more are wanted, and as many"),
           "one": (RATE[:1], STEADY[:1], {}, "Two or more are wanted, and as many"),
           "unit": (RATE, STEADY, {"slip_rate": "mm/s"}, "is in mm/s, not in m/s"),
           "square": (RATE, numpy.outer(STEADY, STEADY), {}, "not a one-dimensional dataset")}
    passed = []
    for name, (rate, friction, units, message) in bad.items():
        write(f"{name}.h5", rate, friction, **units)
        passed.append(refuses(message, *tabulated(
            {RATES: f"{name}.h5:/slip_rate", FRICTION: f"{name}.h5:/friction"})))
    return passed + [
        refuses("there is no file 'none.h5'", *tabulated({FRICTION: "none.h5:/friction"})),
        refuses("has no dataset '/other'", *tabulated({FRICTION: "table.h5:/other"})),
        refuses("is not the name of a dataset", *tabulated({FRICTION: "0.6"})),
        refuses("Table Friction", *tabulated(), "--remove", FRICTION),
        refuses("Table Friction", *asperity_run.settings({FRICTION: "table.h5:/friction"}))]


RATE = 10.0**numpy.arange(-17, 1.5, 0.01)
STEADY = steady_friction(RATE)


def main():
    write("table.h5", RATE, STEADY, slip_rate="m/s", friction="-")
    whole, passed = rupture()
    return (passed + restart(whole) + refused()).count(False)


if __name__ == "__main__":
    sys.exit(main())
