"""Makes `python3 -m asperity_study` the same as `asperity-study`."""

import sys

from asperity_study.cli import main

if __name__ == "__main__":
    sys.exit(main())
