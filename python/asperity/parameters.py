"""The completed deck a run leaves as parameters.xml, a Teuchos ParameterList."""

import difflib
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path
from typing import Dict, List, Optional, Set, Union

from .errors import InputError

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"


class Parameters:
    """Parameters by path below the root list: text('Mesh/Type'), number('Mesh/Wedge/Height')."""

    def __init__(self, values: Dict[str, str], defaults: Optional[Set[str]] = None):
        self._values = values
        self._defaults = defaults or set()

    @classmethod
    def read(cls, path: Path) -> "Parameters":
        """The parameters of `path`; empty if there is no such file, InputError if it is damaged."""
        if not path.exists():
            return cls({})
        try:
            text = path.read_bytes()
        except OSError as error:
            raise InputError(f"{path} cannot be read ({error.strerror}).") from error
        return cls.of_text(text, f"{path}")

    @classmethod
    def of_text(cls, text: Union[str, bytes], name: str) -> "Parameters":
        """InputError with the name if the text is damaged."""
        try:
            root = ElementTree.fromstring(text)
        except (ElementTree.ParseError, UnicodeDecodeError) as error:
            raise InputError(f"{name} cannot be read as XML ({error}). "
                             "Is it the parameters.xml that the run wrote?") from error
        values: Dict[str, str] = {}
        defaults: Set[str] = set()
        _collect(root, "", values, defaults)
        return cls(values, defaults)

    def changed(self) -> Dict[str, str]:
        """Those whose values differ from the defaults that the file has."""
        return {path: value for path, value in self._values.items() if path not in self._defaults}

    def __getitem__(self, path: str) -> str:
        """A parameter as it stands in the deck; InputError if there is none of this path."""
        if path not in self._values:
            near = difflib.get_close_matches(path, self._values, n=1)
            hint = f" Did you mean '{near[0]}'?" if near else ""
            raise InputError(f"The run has no parameter '{path}'.{hint}")
        return self._values[path]

    def text(self, path: str) -> Optional[str]:
        return self._values.get(path)

    def number(self, path: str) -> Optional[float]:
        """A parameter that is a number; None if it is absent or an expression."""
        value = self._values.get(path, "")
        return float(value) if re.fullmatch(rf"\s*{NUMBER}\s*", value) else None

    def numbers(self, path: str) -> List[float]:
        """The entries of an array '{0.1, -9.8}'; empty if it is absent or not of numbers."""
        value = self._values.get(path, "").strip().strip("{}")
        parts = [part.strip() for part in value.split(",")]
        if all(re.fullmatch(NUMBER, part) for part in parts):
            return [float(part) for part in parts]
        return []

    def paths(self) -> List[str]:
        return list(self._values)


def _collect(node: ElementTree.Element, prefix: str, values: Dict[str, str],
             defaults: Set[str]) -> None:
    for child in node:
        path = prefix + child.get("name", "")
        if child.tag == "ParameterList":
            _collect(child, path + "/", values, defaults)
        elif child.tag == "Parameter":
            values[path] = child.get("value", "")
            if child.get("isDefault") == "true":
                defaults.add(path)
