"""Whether the process that writes to a run's directory is still there (io/files/DirectoryLock)."""

import fcntl
import re
import socket
from pathlib import Path

_OWNER = re.compile(r"process (\d+) on (.*)\n")


def owner_is_gone(directory: Path) -> bool:
    """Whether a killed process of this machine left its lock behind. False where that is unknown,
    as on another machine."""
    try:
        with open(directory / ".lock", encoding="utf-8", errors="replace") as lock:
            owner = _OWNER.fullmatch(lock.read())
            if not owner or owner[2] != socket.gethostname():
                return False
            if Path(f"/proc/{owner[1]}").exists():
                return False  # some file systems know no locks
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
            return True
    except OSError:
        return False
