"""The results of a run in its directory; each file is opened when a figure needs it."""

from functools import cached_property
from pathlib import Path
from typing import Any, Callable, Dict, Optional, Tuple, Union

import numpy as np

from . import catalogue, wedge
from .errors import InputError, NoStepYet
from .h5file import H5File
from .history import History
from .parameters import Parameters
from .receivers import Receivers
from .selection import Selection
from .tables import Table, has_header, read_table

FILES = ("fault.h5", "surface.h5", "events.csv", "steps.csv", "run.log")
READ_AS = {"fault.h5": "fault", "surface.h5": "surface", "volume.h5": "volume",
           "receivers.h5": "receivers", "rupture.h5": "ruptures", "global.csv": "totals",
           "steps.csv": "steps", "events.csv": "_all_events"}  # the property that reads a file


def _opened(name: str, open_as: Callable, *more: str) -> Any:
    """A file of the run, opened on first use."""
    return cached_property(lambda run: open_as(run._path(name), *more))


class Run:
    """A result directory; InputError unless it holds one of FILES.

    What has been read is kept: `reloaded()` shows what a run that goes on has written since.
    `selection` says which events count, in all that is read or drawn of them.
    """

    def __init__(self, directory: Union[str, Path], selection: Selection = Selection()):
        directory = Path(directory)
        try:
            str(directory.absolute()).encode("utf-8")
        except UnicodeEncodeError:
            raise InputError(f"{ascii(str(directory))}: a name in this path is not UTF-8, and "
                             "cannot be written to files and figures. Rename the folder.") from None
        if not directory.is_dir():
            raise InputError(f"{directory} is not a directory. Give the folder in which a run of "
                             "asperity left its results.")
        if not any((directory / name).exists() for name in FILES):
            raise InputError(f"{directory} holds no result of a run: none of {', '.join(FILES)} "
                             "is in it.")
        self.directory = directory
        self.selection = selection
        self._unread: Dict[str, InputError] = {}  # by file, see `readable`

    def reloaded(self) -> "Run":
        """The same directory as it is now."""
        return Run(self.directory, self.selection)

    def select(self, smallest_width: float = 0.0, smallest_magnitude: Optional[float] = None,
               merging_time: float = 0.0, start: float = 0.0) -> "Run":
        """The same run with fewer events: without those of a smaller width [m] or magnitude or
        before `start` [s], and with those as one that follow one another within `merging_time`
        [s]."""
        return Run(self.directory, Selection(smallest_width, smallest_magnitude, merging_time,
                                             start))

    def readable(self, *names: str) -> "Run":
        """The same run without those of the files (all of READ_AS) that cannot be read, to
        show what there is: a full disk or a crash leaves empty and cut files. `damage` tells what
        is wrong with them."""
        run = self.reloaded()
        for name in names or READ_AS:
            try:
                if run.has(name):
                    getattr(run, READ_AS[name])
            except InputError as error:
                run._unread[name] = error
        try:
            run.parameters
        except InputError as error:
            run._unread["parameters.xml"] = error
            run.parameters = Parameters({})
        return run

    @property
    def damage(self) -> Dict[str, str]:
        """What is wrong with the files that `readable` has left out, by file."""
        return {name: str(error) for name, error in self._unread.items()
                if not isinstance(error, NoStepYet)}

    def has(self, name: str) -> bool:
        """Whether there is something in a file."""
        return name not in self._unread and not self._nothing_in(name)

    def reason_missing(self, name: str) -> str:
        """Why `has` is false, or ''; InputError if the file is damaged."""
        error = self._unread.get(name)
        if error and not isinstance(error, NoStepYet):
            raise error
        return str(error or self._nothing_in(name)).rstrip(".")

    def _nothing_in(self, name: str) -> str:
        path = self.directory / name
        if not path.exists():
            return f"the run has no {name}"
        if not path.stat().st_size:
            return f"{name} is empty"
        if path.suffix == ".csv" and not has_header(path):
            return f"{name} has no complete line"
        return ""

    def _path(self, name: str) -> Path:
        if name in self._unread:
            raise self._unread[name]
        if not (self.directory / name).exists():
            raise InputError(f"{self.directory / name} does not exist. Is this output enabled in "
                             "the deck's list 'Output', and has the run come to its first "
                             "checkpoint?")
        return self.directory / name

    @cached_property
    def parameters(self) -> Parameters:
        return Parameters.read(self.directory / "parameters.xml")

    fault = _opened("fault.h5", History)
    surface = _opened("surface.h5", History)
    volume = _opened("volume.h5", History)
    receivers = _opened("receivers.h5", Receivers)  # on and off the fault
    ruptures = _opened("rupture.h5", H5File)        # first arrivals of each event
    totals = _opened("global.csv", read_table, "time")  # sums over the fault for each step
    steps = _opened("steps.csv", read_table, "time", "step_size")

    _all_events = _opened("events.csv", read_table, "onset", "duration")

    @cached_property
    def events(self) -> Table:
        """The events that count, in the order of time; `nucleation` is from the upper end."""
        return catalogue.select(catalogue.with_nucleation(self._all_events), self.selection)

    @cached_property
    def events_of_faults(self) -> Dict[str, Table]:
        """The tables events_<fault>.csv by the name of the fault, with all events; none unless the
        deck has several faults and `Each Fault`."""
        names = sorted(path.name for path in self.directory.glob("events_*.csv"))
        return {name[len("events_"):-len(".csv")]: read_table(self._path(name), "number", "onset")
                for name in names if self.has(name)}

    @cached_property
    def complete_events(self) -> Table:
        """The events that ended; the end of the run may have cut one off."""
        table = self.events
        return table.select(table["complete"] != 0) if "complete" in table else table

    @cached_property
    def span(self) -> Tuple[float, float]:
        """First and last time [s] of the run, from the first file that knows it."""
        for name in ("fault", "surface"):
            if self.has(name + ".h5"):
                time = getattr(self, name).time
                return float(time[0]), float(time[-1])
        if self.has("steps.csv") and len(self.steps):
            time, size = self.steps["time"], self.steps["step_size"]
            return float(time[0] - size[0]), float(time[-1])
        raise NoStepYet(f"{self.directory} holds no time step yet: its tables are empty and it "
                        "has no history. Look into run.log.")

    @property
    def threshold(self) -> float:
        """Slip rate [m/s] from which on the catalogue calls the fault seismic."""
        return float(self.parameters["Output/Event Catalogue/Threshold"])

    def upwards(self, dimension: int) -> np.ndarray:
        """Unit vector against gravity in mesh coordinates: from the deck, or off the surface of a
        wedge in the plane, or +y."""
        gravity = _gravity(self.parameters)
        if gravity is not None and gravity.size >= dimension:
            return -gravity[:dimension] / np.linalg.norm(gravity[:dimension])
        off_surface = wedge.upwards(self.parameters)
        if off_surface is not None and dimension == 2:
            return off_surface
        up = np.zeros(dimension)
        up[1 if dimension > 1 else 0] = 1.0
        return up


def _gravity(parameters: Parameters) -> Optional[np.ndarray]:
    """The deck's direction of gravity; None without gravity or direction."""
    direction = np.array(parameters.numbers("Bulk/Gravity Direction"))
    weightless = parameters.number("Bulk/Gravitational Acceleration") == 0.0
    return direction if direction.any() and not weightless else None
