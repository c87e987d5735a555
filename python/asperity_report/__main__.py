"""Makes `python3 -m asperity_report` the same as `asperity-report`."""

import sys

from asperity_report.cli import main

if __name__ == "__main__":
    sys.exit(main())
