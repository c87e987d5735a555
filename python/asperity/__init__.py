"""Reads what a run of Asperity leaves on disk, also while the run goes on.

    import asperity
    run = asperity.Run("results/wedge_2d")
    time, rate, onset = run.fault.time, run.fault["slip_rate"], run.events["onset"]

All numbers are in SI units. docs/reference/python.md says what there is.
"""

__version__ = "0.2.0"
__all__ = ["Run", "InputError", "NothingToShow"]

_PLACES = {"Run": "run", "InputError": "errors", "NothingToShow": "errors"}


def __getattr__(name):
    # On first use, so that the programs can say that numpy or h5py is missing.
    if name not in _PLACES:
        raise AttributeError(f"module 'asperity' has no attribute '{name}'")
    from importlib import import_module
    try:
        return getattr(import_module(f".{_PLACES[name]}", __name__), name)
    except ModuleNotFoundError as error:
        from .program import what_to_install
        raise ImportError(what_to_install(error)) from None
