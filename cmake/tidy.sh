#!/usr/bin/env bash
# clang-tidy with the checks of .clang-tidy over what packages/ and drivers/ compile, and their
# headers; more than half an hour on two cores. Words are parts of paths, which choose some files:
#
#     bash cmake/tidy.sh [WORD ...]
#
# Debian packages: clang-tidy-14. Status 0 if nothing was found.
set -euo pipefail
cd "$(dirname "$0")/.."
cmake --preset tidy > /dev/null
words=$(IFS='|'; echo "${*:-.}")
run-clang-tidy-14 -quiet -p build-tidy "^$PWD/(packages|drivers)/.*($words).*\.cpp$"
