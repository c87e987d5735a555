"""How the programs in Python end."""

import os
import sys
from typing import Callable


def what_to_install(error: ImportError) -> str:
    """The message where a module is missing: which Python, and the packages that it needs."""
    return (f"{sys.executable}: {error}. On Debian: apt-get install python3-numpy python3-h5py "
            "python3-matplotlib, for /usr/bin/python3; another Python first on PATH does not see "
            "them.")


def run_program(main: Callable[[], int]) -> None:
    """Exits with the status that `main` returns."""
    try:
        status = main()
        sys.stdout.flush()
    except BrokenPipeError:  # whoever reads the text has seen enough, as `head` has
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 0
    sys.exit(status)
