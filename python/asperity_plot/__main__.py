"""Makes `python3 -m asperity_plot` the same as `asperity-plot`."""

import sys

from asperity_plot.cli import main

if __name__ == "__main__":
    sys.exit(main())
