"""Writes a page of the manual for each package: its README, its classes and its free functions.

    python3 docs/api_pages.py PACKAGES DOXYGEN_XML OUTPUT
"""

import pathlib
import re
import sys
import xml.etree.ElementTree

LINK = re.compile(r"\[([^]]+)\]\(([^)\s]+)\)")
CLASS = """```{{doxygen{kind}}} {name}
:members:
```
"""
FUNCTION = """```cpp
{declaration};
```

{text}
"""


def without_foreign_links(text):
    """Links to pages of the manual and to other packages stay; of others the text stays."""
    def replaced(found):
        label, target = found[1], found[2]
        page = re.fullmatch(r"\.\./\.\./docs/(.+)", target)
        package = re.fullmatch(r"\.\./(\w+)/README\.md(#.*)?", target)
        if page:
            return f"[{label}](../../{page[1]})"
        if package:
            return f"[{label}]({package[1]}.md{package[2] or ''})"
        return found[0] if target.startswith(("http", "#")) else label
    return LINK.sub(replaced, text)


def classes(doxygen):
    """{header relative to packages/: [(kind, name)]}, without specialisations and inner classes."""
    found = {}
    index = xml.etree.ElementTree.parse(doxygen / "index.xml").getroot()
    for entry in index.iter("compound"):
        name = entry.findtext("name")
        if entry.get("kind") not in ("class", "struct") or "<" in name or "detail::" in name:
            continue
        compound = xml.etree.ElementTree.parse(doxygen / f"{entry.get('refid')}.xml").getroot()
        outer = name.rpartition("::")[0]
        if outer.rpartition("::")[2][:1].isupper():
            continue
        path = compound.find("compounddef/location").get("file")
        found.setdefault(path, []).append((entry.get("kind"), name))
    return found


def functions(doxygen):
    """{header relative to packages/: [Markdown]} of functions in namespaces that are not private."""
    found = {}
    for path in sorted(doxygen.glob("namespace*.xml")):
        namespace = xml.etree.ElementTree.parse(path).getroot().find("compounddef")
        if "detail" in namespace.findtext("compoundname"):
            continue
        for entry in namespace.iter("memberdef"):
            header = entry.find("location").get("file")
            if entry.get("kind") == "function" and header.endswith(".hpp"):
                found.setdefault(header, []).append(FUNCTION.format(
                    declaration=declaration(entry), text=described(entry)))
    return found


def declaration(entry):
    result = " ".join("".join(entry.find("type").itertext()).split())
    template = [" ".join("".join(each.itertext()).split())
                for each in entry.iterfind("templateparamlist/param")]
    return (f"template <{', '.join(template)}>\n" if template else "") + \
        f"{result} {entry.findtext('name')}{entry.findtext('argsstring')}".strip()


def described(entry):
    """The comment as a text in which Markdown sees no markup."""
    text = " ".join(" ".join(part.itertext()) for kind in ("brief", "detailed")
                    for part in entry.iterfind(f"{kind}description/para"))
    return re.sub(r"([\\`*_{}\[\]<>#|$])", r"\\\1", " ".join(text.split()))


def page(package, of_headers, functions_of_headers):
    text = without_foreign_links((package / "README.md").read_text(encoding="utf-8")).rstrip()
    text += "\n\n## Classes and functions\n"
    for path in sorted(package.rglob("*.hpp")):
        header = str(path.relative_to(package.parent))
        parts = [CLASS.format(kind=kind, name=name)
                 for kind, name in sorted(of_headers.get(header, []))]
        parts += functions_of_headers.get(header, [])
        if parts:
            text += f"\n### `{header}`\n\n" + "\n".join(parts)
    return text


def main(packages, doxygen, output):
    folder = pathlib.Path(output)
    folder.mkdir(parents=True, exist_ok=True)
    of_headers = classes(pathlib.Path(doxygen))
    functions_of_headers = functions(pathlib.Path(doxygen))
    for package in sorted(pathlib.Path(packages).iterdir()):
        if (package / "README.md").exists():
            (folder / f"{package.name}.md").write_text(
                page(package, of_headers, functions_of_headers), encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
