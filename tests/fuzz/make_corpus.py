"""Writes the binary part of the corpus anew: make_corpus.py SEEDS, the program asperity_fuzz_seeds.

Each file that our programs write is there as it is, and as a recipe (FileRecipe.hpp).
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

import h5py

CORPUS = pathlib.Path(__file__).parent / "corpus"


def texts(values):
    return [value.decode() if isinstance(value, bytes) else str(value) for value in values]


def attribute(name, value):
    if isinstance(value, (bytes, str)):
        return f"attribute {name} text {texts([value])[0]}"
    if getattr(value, "shape", ()) == ():
        return f"attribute {name} int {value}"
    return f"attribute {name} reals {' '.join(map(repr, value.tolist()))}"


def member(path, item):
    if isinstance(item, h5py.Group):
        return f"group {path}"
    if item.dtype.kind in "SO":
        return f"texts {path} {'|'.join(texts(item[:]))}"
    shape = "x".join(map(str, item.shape))
    return f"dataset {path} {item.dtype} {shape} {' '.join(map(repr, item[...].ravel().tolist()))}"


def recipe(path, layout):
    """Without the checksum of a whole mesh, which a file may lack and a fuzzer does not compute."""
    with h5py.File(path) as file:
        lines = [f"#recipe{layout}"]
        lines += [attribute(name, value) for name, value in file.attrs.items()
                  if name != "checksum"]
        file.visititems(lambda name, item: lines.append(member(name, item)))
    return "\n".join(lines) + "\n"


def main(seeds):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([seeds, folder], check=True)
        for path in sorted(pathlib.Path(folder).glob("*.h5")):
            target = CORPUS / ("checkpoint" if path.stem == "checkpoint" else "mesh")
            target.mkdir(parents=True, exist_ok=True)
            shutil.copy(path, target / path.name)
            layout = " sealed" if path.stem == "checkpoint" else ""
            (target / f"{path.stem}.input").write_text(recipe(path, layout))


if __name__ == "__main__":
    main(*sys.argv[1:])
