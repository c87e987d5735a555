"""Runs the program `asperity` and reads its results, for the tests written in Python."""

import csv
import hashlib
import os
import pathlib
import shlex
import shutil
import subprocess

import deck_entries
import h5py
import time_limits

SOURCE = pathlib.Path(os.environ["ASPERITY_SOURCE_DIR"])
PROGRAM = pathlib.Path(os.environ["ASPERITY_BUILD_DIR"]) / "drivers" / "asperity"
MPIEXEC = shlex.split(os.environ["ASPERITY_MPIEXEC"])


def command(*arguments, ranks=1):
    """The program with its arguments, under mpirun for more than one rank."""
    words = [str(PROGRAM), *map(str, arguments)]
    return words if ranks == 1 else [*MPIEXEC, str(ranks), *words]


def settings(*changes, of_plugin=()):
    """Arguments that change entries of a deck, each a text or {name: value} of several:
    settings("Mesh/Refinements=1", {"Bulk/Density": 2700}, ...).

    ValueError if the program has no such entry, so that a test which expects a failure cannot pass
    because of a misspelt or former name; `of_plugin` has the paths of those that a plugin adds. A
    test of such a mistake itself gives `--set`."""
    texts = []
    for change in changes:
        texts += [change] if isinstance(change, str) else [
            f"{name}={value}" for name, value in change.items()]
    for text in texts:
        path, equals, _ = text.partition("=")
        if not equals:
            raise ValueError(f"'{text}' has no value.")
        deck_entries.require_known(path, of_plugin)
    return [word for text in texts for word in ("--set", text)]


def run(*arguments, ranks=1, timeout=60):
    """A finished run; exit status, stdout and stderr as text."""
    result = subprocess.run(command(*arguments, ranks=ranks), capture_output=True, text=True,
                            timeout=time_limits.seconds(timeout), check=False)
    require_no_rise(result.stdout)
    return result


def refuses(deck, changes, message):
    """True if the program refuses the deck with these changes and says so; one line on stdout."""
    result = run(deck, *settings(changes), "--validate")
    fine = result.returncode == 2 and message in result.stderr
    print(f"refused: {message}{'' if fine else ' NO ' + result.stderr}", flush=True)
    return fine


def require_no_rise(printed):
    """Whatever ends a run, TNNMG lowers J; `printed` is what the run had to say."""
    for line in printed.splitlines():
        if line.startswith("WARNING: J grew"):
            raise AssertionError(line)


def run_to_end(folder, *arguments, ranks=1, timeout=60):
    """The folder of a run that must succeed; what it held before is lost."""
    shutil.rmtree(folder, ignore_errors=True)
    result = run(*arguments, "--output", folder, ranks=ranks, timeout=timeout)
    if result.returncode != 0:
        raise AssertionError(f"exit status {result.returncode}\n{result.stdout}{result.stderr}")
    return pathlib.Path(folder)


def go_on(folder, *arguments, checkpoint=None, ranks=1, timeout=60):
    """Continues the run in a folder from its checkpoint, or another one, to the end; it must
    succeed without a word on stderr."""
    result = run(*arguments, "--restart", checkpoint or folder / "checkpoint.h5", "--output",
                 folder, ranks=ranks, timeout=timeout)
    if (result.returncode, result.stderr) != (0, ""):
        raise AssertionError(f"exit status {result.returncode}\n{result.stdout}{result.stderr}")


def series(file_name):
    """{name: array} of all datasets of a history, e.g. DIR/fault.h5, links to files followed."""
    with h5py.File(file_name) as file:
        return dict(datasets(file))


def datasets(group, prefix=""):
    for name, item in group.items():
        if isinstance(item, h5py.Dataset):
            yield prefix + name, item[()]
        else:
            yield from datasets(item, f"{prefix}{name}/")


def table(file_name):
    """Rows of a .csv file as {column without its unit: number}."""
    with open(file_name, newline="") as file:
        return [{name.split(" [")[0]: float(value) for name, value in row.items()}
                for row in csv.DictReader(file)]


def content(file_name):
    """The bytes of a file of results, of steps.csv without the wall time: no run repeats that."""
    data = pathlib.Path(file_name).read_bytes()
    if pathlib.Path(file_name).name != "steps.csv":
        return data
    rows = [line.split(b",") for line in data.split(b"\n")]
    column = rows[0].index(b"wall_time [s]")
    return b"\n".join(b",".join(row[:column] + row[column + 1:]) for row in rows)


def checksums(folder):
    """{path: digest} of every file and {path: None} of every folder below."""
    paths = sorted(pathlib.Path(folder).rglob("*"))
    return {str(path): hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else None
            for path in paths}
