"""What a run has that decides which files and columns a platform gets, and how its fault lies."""

from dataclasses import dataclass, field
from typing import Any, Mapping, Tuple

from asperity.errors import InputError
from asperity.journal import Journal
from asperity.run import Run

Vector = Tuple[float, ...]
NO_FACTS = ("run.jsonl does not say how the fault lies: the run has no fault, or has just begun")


@dataclass(frozen=True)
class Model:
    """`fault` is what run.jsonl says of it (packages/catalogue/FaultFacts.hpp);
    empty, as in a table of problems, where only the columns count."""

    in_space: bool = False
    antiplane: bool = False
    state: str = "theta"  # or "psi"; "" has no column
    has_water: bool = False
    has_heat: bool = False
    fault: Mapping[str, Any] = field(default_factory=dict)

    @property
    def is_level(self) -> bool:
        """In plane strain: the plane is a map, and the fault runs along strike."""
        return bool(self.fault["level"])

    @property
    def thrust_sign(self) -> float:
        """Of slip along the tangent in a thrust, where the hanging wall moves up dip."""
        return 1.0 if self.antiplane or self.in_space else float(self.fault["thrust_sign"])

    def along(self, direction: str) -> Vector:
        """The unit vector strike, dip, down or inward, in three dimensions."""
        return tuple(self.fault[direction])


def of_run(run: Run) -> Model:
    """InputError if the run does not say how its fault lies."""
    facts = Journal.read(run.directory).fault
    if not facts:
        raise InputError(f"{run.directory}: {NO_FACTS}.")
    in_space = "level" not in facts
    if in_space and "strike" not in facts:
        raise InputError(f"{run.directory}: the fault has no mean plane, and so no strike and dip, "
                         "along which a platform takes slip.")
    return Model(in_space, run.parameters.text("Bulk/Model") == "Antiplane", _state(run),
                 _is_enabled(run, "Pore Pressure"), _is_enabled(run, "Thermal Pressurisation"),
                 facts)


def _state(run: Run) -> str:
    if not run.has("receivers.h5"):
        return ""
    fields = run.receivers.entries("on_fault/fields")
    return next((name for name in ("theta", "psi") if name in fields), "")


def _is_enabled(run: Run, process: str) -> bool:
    return run.parameters.text(f"Friction/{process}/Enabled") == "true"
