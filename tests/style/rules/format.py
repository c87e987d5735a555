"""C++ is laid out as clang-format 14 does with .clang-format. Repair: clang-format-14 -i FILE..."""

import os
import re
import shutil
import subprocess

from . import source

FOLDERS = ["packages", "drivers", "tests", "examples"]
VERSION = "14"
_DRIFT = re.compile(r"^(.*?):(\d+):\d+: error: .*clang-format", re.MULTILINE)


def program():
    """clang-format of the right version, or None: other versions format differently."""
    given = os.environ.get("ASPERITY_CLANG_FORMAT")
    for name in [given] if given else [f"clang-format-{VERSION}", "clang-format"]:
        path = shutil.which(name)
        if path:
            told = subprocess.run([path, "--version"], capture_output=True, text=True).stdout
            if f"version {VERSION}." in told:
                return path
    return None


def check(root):
    clang_format = program()
    if not clang_format:
        return [f"clang-format {VERSION} was not found. On Debian: "
                f"apt-get install clang-format-{VERSION}"]
    files = [path.relative_to(root) for path in source.files(root, FOLDERS, source.CXX)]
    run = subprocess.run([clang_format, "--dry-run", "--Werror", *files], cwd=root,
                         capture_output=True, text=True)
    drifting = dict(reversed(_DRIFT.findall(run.stderr)))  # the first place in each file
    breaches = [f"{name}:{line}: drifts; repair with: clang-format-{VERSION} -i {name}"
                for name, line in sorted(drifting.items())]
    return breaches or ([run.stderr] if run.returncode else [])
