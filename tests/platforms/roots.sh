#!/usr/bin/env bash
# The quick start of README.md in empty roots of Debian, as an ordinary user with sudo: `run`, then
# `test`. Writes a row for each suite; table.py puts rows into docs/cost/platforms.md.
#
#   roots.sh [--work DIR] [--ccache DIR] [--keep] SUITE...
#
# SUITE           bookworm, trixie, sid, or experimental: sid with Trilinos of experimental
# --work DIR      where roots, logs and rows go, as DIR/SUITE/row.json (default: build/platforms)
# --ccache DIR    keeps a compiler cache in DIR/SUITE; seconds then say nothing, and no row has them
# --keep          leaves the roots, 4 GB each
#
# Needs root, debootstrap and git; the archive is the one that apt uses on this machine. What is
# committed is tried, not what lies in the work tree. Status 0: all tests of all suites passed, 1:
# not all, 77: it cannot be tried here.
set -euo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)

skip() { echo "skipped: $1"; exit 77; }
usage() { sed -n '2,15s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }

work=$here/../../build/platforms
cache=''
keep=no
suites=()
while [ $# -gt 0 ]; do
  case "$1" in
    --work | --ccache)
      [ $# -ge 2 ] || { usage >&2; exit 2; }
      if [ "$1" = --work ]; then work=$2; else cache=$(realpath -m "$2"); fi
      shift ;;
    --keep) keep=yes ;;
    bookworm | trixie | sid | experimental) suites+=("$1") ;;
    *) usage >&2; exit 2 ;;
  esac
  shift
done
[ "${#suites[@]}" -gt 0 ] || { usage >&2; exit 2; }
[ "$(id -u)" = 0 ] || skip "not root"
command -v debootstrap > /dev/null || skip "no debootstrap"
# shellcheck disable=SC2016 # apt's own names
mirror=$(apt-get indextargets --format '$(REPO_URI) $(COMPONENT)' 2> /dev/null |
  awk '$2 == "main" && $1 ~ /debian\/?$/ { print $1; exit }')
[ -n "$mirror" ] || skip "apt names no archive of Debian"

work=$(realpath -m "$work")
mkdir -p "$work/archives"
all=0
for suite in "${suites[@]}"; do
  rm -rf --one-file-system "${work:?}/$suite"
  # What is mounted there goes with the process.
  unshare --mount bash "$here/one_root.sh" "$suite" "$work" "$mirror" "$cache" || all=1
  [ "$keep" = yes ] || rm -rf --one-file-system "${work:?}/$suite/root"
done
exit "$all"
