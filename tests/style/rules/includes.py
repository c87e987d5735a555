"""A package includes itself and the packages its asperity_add_package line names, nothing else; it
includes each of these, or the other registers laws or outputs, which are found by name."""

import re

from . import source

_LINE = re.compile(r"^\s*asperity_add_package\(\s*(\w+)([^)]*)\)", re.MULTILINE)
QUOTED = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
_REGISTERS = re.compile(r"^ASPERITY_REGISTER\w*\(", re.MULTILINE)
_ANGLED = re.compile(r"^\s*#\s*include\s+<([^>]+)>", re.MULTILINE)

FILES = ("cmake/AsperityKernelPackages.cmake", "CMakeLists.txt")

# What the design promises whatever the lines say: package -> packages it never includes.
FORBIDDEN = {
    "portability": {"registry", "friction", "multigrid", "base", "hdf5", "parameters", "mesh",
                    "fem", "tnnmg", "dynamics", "io", "catalogue", "scenario"},
    "registry": {"friction", "multigrid", "base", "hdf5", "parameters", "mesh", "fem", "tnnmg",
                 "dynamics", "io", "catalogue", "scenario"},
    "multigrid": {"friction", "base", "hdf5", "parameters", "mesh", "fem", "tnnmg", "dynamics",
                  "io", "catalogue", "scenario"},
    "friction": {"base", "hdf5", "parameters", "mesh", "fem", "tnnmg", "dynamics", "io",
                 "catalogue", "scenario"},
    "base": {"hdf5", "parameters"},
    "hdf5": {"parameters"},
    "tnnmg": {"mesh", "fem", "friction", "dynamics", "io", "catalogue", "scenario"},
    "dynamics": {"io", "catalogue", "scenario"},
    "io": {"friction", "tnnmg", "dynamics", "catalogue", "scenario"},
    "catalogue": {"friction", "tnnmg", "dynamics", "scenario"},
}


def declared_packages(root):
    """{package: the packages it may include}, in the order in which CMake reads the lines."""
    packages = {}
    lines = "".join((root / name).read_text() for name in FILES if (root / name).is_file())
    for name, arguments in _LINE.findall(lines):
        listed = re.search(r"\bPACKAGES\b(.*?)(\b(?:PRIVATE_)?LIBRARIES\b|$)", arguments, re.DOTALL)
        packages[name] = set(listed.group(1).split()) if listed else set()
    return packages


def check(root):
    packages = declared_packages(root)
    if not packages:
        return ["CMakeLists.txt:1: no asperity_add_package line was found"]
    return [*_lines(packages), *_sources(root, packages), *_unused(root, packages)]


def _lines(packages):
    known = set()
    for name, allowed in packages.items():
        for other in sorted(allowed - known):
            yield f"CMakeLists.txt:1: {name} names {other}, which does not stand before it"
        for other in sorted(allowed & FORBIDDEN.get(name, set())):
            yield f"CMakeLists.txt:1: {name} may not know {other}"
        known.add(name)


def _sources(root, packages):
    for path in source.files(root, ["packages"], source.CXX):
        name = path.relative_to(root).parts[1]
        if name not in packages:
            yield source.breach(root, path, 1, f"no asperity_add_package line names {name}")
            continue
        text = source.without_comments(path.read_text())
        for match in QUOTED.finditer(text):
            other = match.group(1).split("/")[0]
            if other != name and other not in packages[name]:
                allowed = ", ".join(sorted(packages[name])) or "no other package"
                message = f'includes "{match.group(1)}"; {name} may include {allowed}'
                yield source.breach(root, path, source.line_of(text, match.start(1)), message)
        if name in ON_KOKKOS_ALONE:
            yield from _beyond_kokkos(root, path, text)


def _unused(root, packages):
    included, registering = {name: set() for name in packages}, set()
    for path in source.files(root, ["packages"], source.CXX):
        name = path.relative_to(root).parts[1]
        text = source.without_comments(path.read_text())
        included.setdefault(name, set()).update(
            header.split("/")[0] for header in QUOTED.findall(text))
        if _REGISTERS.search(text):
            registering.add(name)
    for name, declared in packages.items():
        for other in sorted(declared - included[name] - registering):
            yield f"CMakeLists.txt:1: {name} names {other}, but includes nothing of it"


ON_KOKKOS_ALONE = {"portability", "registry", "friction", "multigrid"}


# Headers of the C++ standard library and of Eigen have no suffix; that of SSE is the compiler's.
def _beyond_kokkos(root, path, text):
    for match in _ANGLED.finditer(text):
        header = match.group(1)
        if "." in header and not header.startswith("Kokkos_") and header != "xmmintrin.h":
            message = f"includes <{header}>; {' and '.join(sorted(ON_KOKKOS_ALONE))} stand on " \
                      "Kokkos and the standard library"
            yield source.breach(root, path, source.line_of(text, match.start(1)), message)
