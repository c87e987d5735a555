"""What a run came from: program, machine, checksums of what it read and left."""

import hashlib
from datetime import datetime, timezone
from pathlib import Path
from typing import List

from asperity.errors import InputError
from asperity.h5file import H5File
from asperity.log import RunLog
from asperity.run import Run

from . import page

HASHED = ("parameters.xml", "run.log", "events.csv", "steps.csv", "global.csv", "checkpoint.h5")
WHOLE = ("what a restart compares: the deck without the entries that may differ, the mesh and the "
         "datasets")


def section(run: Run, log: RunLog, wrong: List[str]) -> str:
    parts = [page.table(["the run"], [[line] for line in log.environment] or [["unknown"]], True)]
    if log.processes > 1:
        parts.append(page.paragraph(f"The run was continued {log.processes - 1} times; the lines "
                                    "above are those of its last process."))
    inputs = _inputs(run, wrong)
    if inputs:
        parts.append(page.table(["input", "checksum"], inputs, True))
    parts.append(page.table(["file", "bytes", "last written (UTC)", "SHA-256"],
                            _files(run.directory), True))
    parts.append(page.paragraph(
        "parameters.xml is the deck with all changes by --set and --overlay and with every "
        "default; it can be run again as it is. The original deck is not kept. Histories "
        "lie in the folder segments; their index files name them. A run has no random numbers, and "
        "so no seed.", "note"))
    return "\n".join(parts)


def _inputs(run: Run, wrong: List[str]) -> List[List[str]]:
    """The deck, meshes and datasets by what the checkpoint says of their content."""
    if not run.has("checkpoint.h5"):
        return []
    try:
        file = H5File(run.directory / "checkpoint.h5")
        if not file.has("fingerprint/contents"):
            return []
        names = [file.strings(f"fingerprint/{name}") for name in ("contents", "values")]
        whole = file.attribute("/", "fingerprint")
    except InputError as error:
        wrong.append(str(error))
        return []
    return [[WHOLE, whole]] * bool(whole) + [
        [content, value] for content, value in zip(*names) if content]


def _files(directory: Path) -> List[List[str]]:
    rows = []
    for name in HASHED:
        path = directory / name
        if path.exists():
            with open(path, "rb") as file:
                digest = hashlib.sha256()
                for block in iter(lambda: file.read(2**20), b""):
                    digest.update(block)
            stamp = datetime.fromtimestamp(path.stat().st_mtime, timezone.utc)
            rows.append([name, f"{path.stat().st_size}", f"{stamp:%Y-%m-%d %H:%M:%S}",
                         digest.hexdigest()])
    return rows
