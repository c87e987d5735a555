#!/usr/bin/env python3
"""Runs nvcc's front end over every file that compiles a device lambda.

usage: device_front_end.py NVCC COMPILE_COMMANDS.json ROOT

The front end refuses what no other compiler looks at: device lambdas in private functions, or that
capture what devices cannot have. Kokkos need not be built for CUDA: its macros are set to CUDA's
own marks, and no code for a device is made, so that this says nothing about results. Errors fail
the test; warnings of Kokkos's and Trilinos's headers, which are then for the host alone, do not.
"""

import collections
import functools
import json
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

MARKS = {"KOKKOS_LAMBDA": "[=] __host__ __device__",
         "KOKKOS_IMPL_FUNCTION": "__host__ __device__",
         "KOKKOS_IMPL_INLINE_FUNCTION": "inline __host__ __device__",
         "KOKKOS_IMPL_FORCEINLINE_FUNCTION": "inline __host__ __device__"}
_LAMBDA = re.compile(r"\bKOKKOS_(?:CLASS_)?LAMBDA\b")
_QUOTED = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.MULTILINE)
_KEPT = ("-I", "-D", "-isystem")
# A device lambda in a private function.
SAMPLE = """#include <Kokkos_Core.hpp>
class A
{
  void f()
  {
    Kokkos::parallel_for("a", 1, KOKKOS_LAMBDA(int) {});
  }

public:
  void g() { f(); }
};
void h() { A().g(); }
"""


def files_with_lambdas(root):
    """Sources that have a device lambda, or in whose headers of ours one stands."""
    includes = (root / "packages", root / "drivers")

    @functools.lru_cache(maxsize=None)
    def compiles_one(path):
        text = path.read_text()
        headers = (folder / name for name in _QUOTED.findall(text) for folder in includes)
        return bool(_LAMBDA.search(text)) or any(
            compiles_one(header) for header in headers if header.exists() and header != path)

    return [path for folder in includes for path in sorted(folder.rglob("*.cpp"))
            if compiles_one(path)]


def options(command):
    """-I, -D and -isystem of a compiler's command, and the standard; no precompiled header."""
    words, kept = shlex.split(command), []
    for word, following in zip(words, words[1:] + [""]):
        if word.startswith("-isystem") or word in _KEPT:
            kept += [word, following] if word in _KEPT else [word]
        elif word.startswith(_KEPT) or word.startswith("-std="):
            kept.append(word)
    return [word for word in kept if "cmake_pch" not in word]


def commands_of_sources(entries):
    """{source: command}; the sources of a unit that CMake joined have that of the unit."""
    commands = {}
    for entry in entries:
        path = pathlib.Path(entry["file"]).resolve()
        joined = path.name.startswith("unity_") and path.exists()
        sources = _QUOTED.findall(path.read_text()) if joined else [path]
        commands.update({pathlib.Path(source).resolve(): entry["command"] for source in sources})
    return commands


def front_end(nvcc, words, path):
    """What nvcc says, or None if it finds no error."""
    with tempfile.TemporaryDirectory() as folder:
        marks = [f"-D{name}={text}" for name, text in MARKS.items()]
        run = subprocess.run(
            [nvcc, "-x", "cu", "--cuda", "-o", f"{folder}/out.ii", "-w", "--extended-lambda",
             "--expt-relaxed-constexpr", *marks, *words, str(path)], capture_output=True, text=True)
    return None if run.returncode == 0 else run.stdout + run.stderr


def grouped(files, commands, root):
    """[(options, files)], each of one package: their headers are read once."""
    groups = collections.defaultdict(list)
    for path in files:
        words = options(commands[path.resolve()])
        groups[path.relative_to(root).parts[:2], tuple(words)].append(path)
    return [(list(words), members) for (_, words), members in groups.items()]


def refused(nvcc, words, files, folder):
    """What nvcc says about those of the files that it refuses, {file: text}. All at once, or, if
    that is refused, one by one: two files may use a name that each has for itself."""
    joined = pathlib.Path(folder) / "joined.cpp"
    joined.write_text("".join(f'#include "{path}"\n' for path in files))
    if len(files) > 1 and front_end(nvcc, words, joined) is None:
        return {}
    told = {path: front_end(nvcc, words, path) for path in files}
    return {path: text for path, text in told.items() if text is not None}


def main(nvcc, commands_file, root):
    root = pathlib.Path(root).resolve()
    commands = commands_of_sources(json.loads(pathlib.Path(commands_file).read_text()))
    files = [path for path in files_with_lambdas(root) if path.resolve() in commands]
    if not files:
        return f"no file of {commands_file} has a device lambda"
    errors = []
    with tempfile.TemporaryDirectory() as folder:
        sample = pathlib.Path(folder) / "private.cpp"
        sample.write_text(SAMPLE)
        if not refused(nvcc, options(commands[files[0].resolve()]), [sample], folder):
            return "nvcc took a device lambda in a private function: this check sees nothing"
        for words, members in grouped(files, commands, root):
            bad = refused(nvcc, words, members, folder)
            for path in members:
                print(path.relative_to(root), "refused" if path in bad else "good", flush=True)
            errors += bad.values()
    return "\n".join(errors) or None


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
