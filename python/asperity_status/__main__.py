"""Makes `python3 -m asperity_status` the same as `asperity-status`."""

import sys

from asperity_status.cli import main

if __name__ == "__main__":
    sys.exit(main())
