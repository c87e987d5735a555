"""How the programs in Python end."""

import os
import sys
from typing import Callable


def run_program(main: Callable[[], int]) -> None:
    """Exits with the status that `main` returns."""
    try:
        status = main()
        sys.stdout.flush()
    except BrokenPipeError:  # whoever reads the text has seen enough, as `head` has
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        status = 0
    sys.exit(status)
