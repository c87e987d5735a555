"""What is collected: a case is a deck with settings, and the quantities that its run gives."""

from dataclasses import dataclass
from typing import Callable, Tuple, Union

Reference = Union[None, float, Tuple[float, float]]  # a pair: between these two


@dataclass(frozen=True)
class Quantity:
    """`read` takes an asperity.Run; `form` is a format of Python, '' for that of the unit."""

    name: str
    unit: str
    read: Callable
    reference: Reference = None
    form: str = ""


@dataclass(frozen=True)
class Case:
    """Its results lie in a folder of its name. Of `against`, another case, the values are the
    references where quantities have none of their own."""

    name: str
    title: str                     # in the table of docs/validation/index.md
    page: str                      # docs/validation/<page>.md
    minutes: float                 # of a run on one core, about
    quantities: Tuple[Quantity, ...]
    source: str = ""               # of the references, in few words
    deck: str = ""                 # xml/<deck>.xml, by default of its name
    settings: Tuple[str, ...] = ()
    removed: Tuple[str, ...] = ()  # paths of entries of the deck
    mesh: str = ""                 # the command that makes the mesh file
    against: str = ""
    has_table: bool = True         # False: its values stand in the table of another case alone
    in_index: Tuple[str, ...] = ()  # names of quantities

    @property
    def deck_name(self) -> str:
        return self.deck or self.name

    def commands(self, results: str = "results") -> str:
        """What makes the run, as in a shell at the top of the source tree."""
        words = [f'--remove "{path}"' for path in self.removed]
        words += [f'--set "{setting}"' for setting in self.settings]
        words.append(f"--output {results}/{self.name}")
        lines = [f"asperity xml/{self.deck_name}.xml"]
        for word in words:
            if len(lines[-1]) + len(word) > 100:
                lines.append(" ")
            lines[-1] += f" {word}"
        return "\n".join(([self.mesh] if self.mesh else []) + [" \\\n  ".join(
            line.strip() for line in lines)])


def several(name, unit, read, references, numbers=None, form=""):
    """The same quantity of several events; `name` has {} for the number, `read` is a function of
    it."""
    numbers = numbers or range(1, len(references) + 1)
    return tuple(Quantity(name.format(number), unit, read(number), reference, form)
                 for number, reference in zip(numbers, references))
