"""Orders in time of runs whose steps are halved again and again, from the fault at common times."""

import asperity_run
import numpy

LARGEST_STEP = 0.01                             # s, of the decks
TIMES = 3 * LARGEST_STEP * numpy.arange(1, 17)  # where all runs can be compared


def at_times(folder, fields):
    """{field: values (times, nodes) on the fault at TIMES}."""
    history = asperity_run.series(folder / "fault.h5")
    steps = numpy.searchsorted(history["time"], TIMES - 1e-9)
    assert numpy.allclose(history["time"][steps], TIMES, rtol=1e-12)
    return {name: history[f"fields/{name}"][steps] for name in fields}


def check(what, solutions, reference, size, least, most):
    """True if halving the steps, from one solution to the next, divides each error by 2^least to
    2^most. An error is a root mean square over the fault and TIMES, over the field's size(values).
    """
    errors = numpy.array([[numpy.sqrt(numpy.mean((solution[name] - values)**2)) / size(values)
                           for name, values in reference.items()] for solution in solutions])
    orders = numpy.log2(errors[:-1] / errors[1:])
    fine = least <= orders.min() and orders.max() <= most
    columns = (f"{name} {error:.1e} {' '.join(f'{x:.2f}' for x in of_field)}"
               for name, error, of_field in zip(reference, errors[-1], orders.T))
    print(f"{what:48s} {'; '.join(columns)}{'' if fine else f' NOT {least} to {most}'}", flush=True)
    return fine
