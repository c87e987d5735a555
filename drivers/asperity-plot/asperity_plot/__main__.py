"""Makes `python3 -m asperity_plot DIR` the same as `asperity-plot DIR`."""

import os
import sys

from asperity_plot.cli import main

try:
    status = main()
    sys.stdout.flush()
except BrokenPipeError:  # whoever reads the tables has seen enough, as `head` has
    os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
    status = 0
sys.exit(status)
