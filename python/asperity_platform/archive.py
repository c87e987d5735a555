"""The ZIP file with what a platform takes of a folder."""

import os
import zipfile
from pathlib import Path
from typing import List

from asperity.errors import InputError

DAY = (1980, 1, 1, 0, 0, 0)  # of all entries: the same files make the same archive


def write(archive: Path, files: List[Path]) -> None:
    """All files without folders. InputError if the archive exists or cannot be written."""
    if archive.exists():
        raise InputError(f"{archive} exists. Remove it, or choose another name.")
    unfinished = archive.with_name(archive.name + ".unfinished")
    try:
        with zipfile.ZipFile(unfinished, "w", zipfile.ZIP_DEFLATED) as file:
            for path in files:
                file.writestr(zipfile.ZipInfo(path.name, DAY), path.read_bytes(),
                              zipfile.ZIP_DEFLATED)
        os.replace(unfinished, archive)
    except OSError as error:
        unfinished.unlink(missing_ok=True)
        raise InputError(f"{archive} cannot be written ({error.strerror}).") from error
