"""A package's README says on top, in sentences, what the package is for, what it is not for and
which packages it includes, as its asperity_add_package line does. The files that it names exist."""

import re

from . import includes

# Only the part before the first table or heading of the second level is looked at.
_TOP = re.compile(r"\A# (?P<name>\S+)\n(?P<text>.*?)(?=^#|^\||\Z)", re.DOTALL | re.MULTILINE)
_SENTENCES = [r"\bis for [^.]{15,}", r"\bis not for [^.]{15,}"]

_INCLUDES = re.compile(r"\b[Ii]ncludes\b(?P<packages>[^.;:]*)")
_FILE = re.compile(r"`([\w/]+\.[hc]pp)`")


def check(root):
    packages = sorted(path for path in (root / "packages").iterdir() if path.is_dir())
    declared = includes.declared_packages(root)
    return [f"packages/{package.name}/README.md:1: {text}" for package in packages
            for text in [*_breaches(package, declared), *_missing(root, package)]]


def _breaches(package, declared):
    readme = package / "README.md"
    if not readme.is_file():
        yield "there is no such file"
        return
    top = _TOP.match(readme.read_text())
    if not top or top.group("name") != package.name:
        yield f"the first line is not '# {package.name}'"
        return
    text = " ".join(top.group("text").split())
    for sentence in _SENTENCES:
        if not re.search(sentence, text):
            yield f"no sentence at the top that matches '{sentence}'"
    sentence = _INCLUDES.search(text)
    told = set(re.findall(r"`(\w+)`", sentence.group("packages")) if sentence else [])
    allowed = declared.get(package.name, set())
    if told != allowed:
        yield f"includes {_list(told)} by its top, {_list(allowed)} by CMakeLists.txt"


def _list(packages):
    return ", ".join(sorted(packages)) or "no other package"


# A name may leave out the first folders of a file of the package.
def _missing(root, package):
    readme = package / "README.md"
    for name in _FILE.findall(readme.read_text() if readme.is_file() else ""):
        if not (any(package.rglob(name)) or (package.parent / name).exists()
                or (root / name).exists()):
            yield f"there is no file {name}"
