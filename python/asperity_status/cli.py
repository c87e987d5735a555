"""The command line of asperity-status."""

import argparse
import dataclasses
import json
import time
from pathlib import Path
from typing import List, Optional

from asperity.program import not_negative, program, time as seconds

STATUS = {"finished": 0, "failed": 3, "stopped": 4, "killed": 6, "silent": 6, "running": 10}
ENDS = """exit status:
  0   finished: the run has reached its final time
  2   DIR holds no run, or its files cannot be read
  3   failed: the program has ended it with an error, and a restart may end there again
  4   stopped by a signal, with its last complete state in checkpoint.h5
  6   killed; or silent: nothing was written for the time --silent-after
  10  running"""


@program("asperity-status")
def main(arguments: Optional[List[str]] = None) -> int:
    options = _parse(arguments)
    from .facts import facts  # here, since numpy and h5py may be missing
    try:
        while True:
            now = facts(options.directory, options.silent_after)
            _show(now, options)
            if not options.follow or now.state != "running":
                return STATUS[now.state]
            time.sleep(options.every)
    except KeyboardInterrupt:
        return STATUS["running"]


def _show(now, options) -> None:
    from .text import describe, line
    if options.json:
        print(json.dumps(dataclasses.asdict(now)), flush=True)
    elif options.follow and now.state == "running":
        print(line(now), flush=True)
    else:
        print(describe(now), flush=True)


def _parse(arguments: Optional[List[str]]) -> argparse.Namespace:
    parser = argparse.ArgumentParser(
        prog="asperity-status", formatter_class=argparse.RawDescriptionHelpFormatter, epilog=ENDS,
        description="Says where a run of asperity is, how fast, and when it ends.")
    parser.add_argument("directory", metavar="DIR", type=Path, help="the run's output directory")
    parser.add_argument("--follow", action="store_true",
                        help="print a line every so often until the run ends (see --every)")
    duration = not_negative(seconds)
    parser.add_argument("--every", metavar="TIME", type=duration, default=30.0,
                        help="time between two lines of --follow (default: 30s)")
    parser.add_argument("--silent-after", metavar="TIME", type=duration, default=1800.0,
                        help="a run that writes nothing for so long counts as silent; a running "
                             "one logs a line after the first step past each 30 s (default: "
                             "30min)")
    parser.add_argument("--json", action="store_true", help="one JSON object instead of text")
    return parser.parse_args(arguments)
