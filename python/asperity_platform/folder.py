"""What a platform's checker asks of the files of a folder."""

from collections import Counter
from dataclasses import dataclass
from pathlib import Path
from typing import List

from asperity.errors import InputError

from .checks import Refusal, check_file
from .platforms import PLATFORMS
from .problem import Platform, Problem, find, plain
from .textfile import problem_in


@dataclass
class Verdict:
    """On a folder: `taken` are the files that the platform has places for, `spare` those of
    stations that it has no place for."""

    directory: Path
    problem: str
    platform: Platform
    taken: List[Path]
    spare: List[Path]
    refusals: List[Refusal]

    @property
    def is_outdated(self) -> bool:
        """Whether the run in whose folder the files are has gone on, or begun anew, since."""
        journal = self.directory.parent / "run.jsonl"
        return journal.exists() and any(path.stat().st_mtime < journal.stat().st_mtime
                                        for path in self.taken)


def check(directory: Path, wanted: str = "") -> Verdict:
    """InputError if there are no files, or none say of which problem they are; `wanted` is the
    name of the problem, if it is not the one that most files name."""
    directory = _of_platform(directory)
    paths = sorted(directory.iterdir())
    if not paths:
        raise InputError(f"{directory} is empty.")
    names = [path.name for path in paths]
    name = wanted or _most_named(directory, paths)
    platform, problem = next(((each, found) for each in PLATFORMS
                              for found in (find(each.problems, name, names),) if found),
                             (None, None))
    if platform is None or problem is None:
        raise InputError(f"'{name}' is none of the problems that this program knows: "
                         f"{', '.join(_known())}.")
    refusals = _missing(problem, names)
    try:
        for path in paths:
            refusals += _of_file(path, problem, name, platform.has_equal_steps)
    except OSError as error:
        raise InputError(f"{error.filename} cannot be read ({error.strerror}).") from error
    taken = [path for path in paths if problem.takes(path.name)]
    spare = [path for path in paths if problem.kind_of(path.name) and path not in taken]
    return Verdict(directory, plain(name), platform, taken, spare, refusals)


def _of_platform(directory: Path) -> Path:
    """The folder itself, or the one of a platform in the folder of a run."""
    if not directory.is_dir():
        raise InputError(f"{directory} is no folder.")
    inside = [directory / platform.folder for platform in PLATFORMS
              if (directory / platform.folder).is_dir()]
    return inside[0] if len(inside) == 1 else directory


def _most_named(directory: Path, paths: List[Path]) -> str:
    named = Counter(problem_in(path) for path in paths if path.is_file())
    named.pop("", None)
    if not named:
        raise InputError(f"No file of {directory} has a header with `# problem=`. Name the problem "
                         "with --problem.")
    return named.most_common(1)[0][0]


def _known() -> List[str]:
    return list(dict.fromkeys(name for platform in PLATFORMS
                              for problem in platform.problems for name in problem.names))


def _missing(problem: Problem, names: List[str]) -> List[Refusal]:
    found = [Refusal(equal[0], 0, "is missing" + (
        f"; by symmetry {' or '.join(equal[1:])} would do" if equal[1:] else ""))
        for equal in problem.stations if not any(name in names for name in equal)]
    for kind in problem.kinds:
        has_list = kind.is_station and problem.stations
        if kind.is_needed and not has_list and not any(kind.matches(name) for name in names):
            name = kind.what if kind.is_station else kind.prefix
            found.append(Refusal(name, 0, "is missing; one is needed at least"
                                 if kind.is_station else f"is missing ({kind.what})"))
    return found


def _of_file(path: Path, problem: Problem, name: str, has_equal_steps: bool) -> List[Refusal]:
    kind = problem.kind_of(path.name)
    if not path.is_file():
        return [Refusal(path.name, 0, "is no file; the platform takes files alone")]
    if kind is None:
        return [Refusal(path.name, 0, f"no file of {plain(name)} has this name")]
    return check_file(path, kind, name, has_equal_steps)
