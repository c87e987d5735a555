"""Makes `python3 -m asperity_platform` the same as `asperity-platform`."""

import sys

from asperity_platform.cli import main

if __name__ == "__main__":
    sys.exit(main())
