"""Makes `python3 -m asperity_plot DIR` the same as `asperity-plot DIR`."""

import sys

from asperity_plot.cli import main

sys.exit(main())
