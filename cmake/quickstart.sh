#!/usr/bin/env bash
# From a bare Debian to earthquakes: installs what is missing, configures, builds, and then
#
#   bash cmake/quickstart.sh run     simulates xml/wedge_2d.xml and draws the figures
#   bash cmake/quickstart.sh test    runs the default suite of tests
#
# Options
#   --build DIR     where to build                    (default: build, beside README.md)
#   --output DIR    where `run` puts its results      (default: results/wedge_2d)
#   --jobs N        compilers that run side by side   (default: by cores and memory)
#   --no-install    install nothing; CMake says what it does not find
#   --strict        for `test`, as continuous integration runs it: warnings in our code are errors,
#                   and the packages are also built and tested briefly with the preset `debug`
#
# A Trilinos of your own is taken from Trilinos_ROOT or CMAKE_PREFIX_PATH instead of Debian's.
set -euo pipefail

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$top/build
output=$top/results/wedge_2d
jobs=
install=yes # read by quickstart_packages.sh
strict=no
mode=

usage()
{
  sed -n '2,16s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"
}

fail()
{
  printf '\nquickstart: %s\n' "$*" >&2
  exit 1
}

absolute()
{
  case "$1" in
    /*) printf '%s\n' "$1" ;;
    *) printf '%s/%s\n' "$PWD" "$1" ;;
  esac
}

parse_arguments()
{
  while [ $# -gt 0 ]; do
    case "$1" in
      run | test) mode=$1 ;;
      --build | --output | --jobs)
        [ $# -ge 2 ] || fail "$1 needs a value. See --help."
        case "$1" in
          --build) build=$(absolute "$2") ;;
          --output) output=$(absolute "$2") ;;
          --jobs) jobs=$2 ;;
        esac
        shift ;;
      --no-install) install=no ;;
      --strict) strict=yes ;;
      -h | --help) usage; exit 0 ;;
      *) fail "unknown argument '$1'. See --help." ;;
    esac
    shift
  done
  [ -n "$mode" ] || { usage >&2; exit 1; }
  [ "$strict" = no ] || [ "$mode" = test ] || fail "--strict belongs to \`test\`, not to \`$mode\`."
  [ -z "$jobs" ] || [[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "--jobs $jobs is not a positive number."
}

phase_count=0
phase_start=0
phase()
{
  phase_count=$((phase_count + 1))
  phase_start=$SECONDS
  printf '\n[%d/%d] %s\n' "$phase_count" "$([ "$strict" = yes ] && echo 5 || echo 4)" "$*"
}

phase_done()
{
  printf '      %d s\n' "$((SECONDS - phase_start))"
}

# 1.5 GB of memory for each compiler: files that include MueLu need most of that.
default_jobs()
{
  local cores kilobytes limit
  cores=$(nproc)
  kilobytes=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo)
  if read -r limit 2> /dev/null < /sys/fs/cgroup/memory.max && [[ $limit =~ ^[0-9]+$ ]]; then
    limit=$((limit / 1024))
    kilobytes=$((limit < kilobytes ? limit : kilobytes))
  fi
  local fitting=$((kilobytes / 1500000))
  fitting=$((fitting < 1 ? 1 : fitting))
  printf '%d\n' "$((fitting < cores ? fitting : cores))"
}

configure()
{
  phase "Configure ($build)"
  command -v cmake > /dev/null || fail 'there is no cmake on PATH.'
  local -a generator=()
  if [ ! -f "$build/CMakeCache.txt" ]; then
    # Eight sources in one unit read the headers of Trilinos once.
    generator=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON)
    ! command -v ninja > /dev/null || generator+=(-G Ninja)
  fi
  local -a options=()
  if [ "$mode" = test ]; then
    options=(-DASPERITY_ENABLE_TESTS=ON)
  elif [ "${#generator[@]}" -gt 0 ]; then # a build folder that has tests keeps them
    options=(-DASPERITY_ENABLE_TESTS=OFF)
  fi
  [ "$strict" = no ] || options+=(-DASPERITY_WARNINGS_AS_ERRORS=ON)
  cmake -S "$top" -B "$build" "${generator[@]}" "${options[@]}"
  phase_done
}

compile()
{
  jobs=${jobs:-$(default_jobs)}
  phase "Build ($jobs at a time)"
  cmake --build "$build" --parallel "$jobs" "$@"
  phase_done
}

# The preset `debug` has assertions, a checked standard library and no precompiled headers, so that
# a missing #include is an error. Debug symbols are not needed here and would only take time.
check_debug()
{
  phase "Build the packages with assertions and without precompiled headers ($build-debug)"
  cmake -S "$top" --preset debug -B "$build-debug" -DCMAKE_CXX_FLAGS_DEBUG= \
    -DASPERITY_WARNINGS_AS_ERRORS=ON -DASPERITY_ENABLE_MESH_TOOL=OFF
  cmake --build "$build-debug" --parallel "$jobs" --target asperity_packages asperity_quick_tests
  ctest --test-dir "$build-debug" -L '^quick$' --parallel "$(nproc)" --output-on-failure
  phase_done
}

simulate()
{
  phase "Simulate $output"
  "$build/drivers/asperity" "$top/xml/wedge_2d.xml" --output "$output" --overwrite
  phase_done
  printf '\nFigures\n'
  "$build/drivers/asperity-plot" "$output"
  printf '\nDone in %d s. The results are in %s\n' "$SECONDS" "$output"
}

# Nothing is printed after ctest's own summary.
run_tests()
{
  phase "Test (after $SECONDS s)"
  ctest --test-dir "$build" --label-exclude '^benchmark$' \
    --parallel "$(nproc)" --output-on-failure
}

# shellcheck source=cmake/quickstart_packages.sh
. "$top/cmake/quickstart_packages.sh"
parse_arguments "$@"

# In a container the user is root, and a process may not read the memory of another one.
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_btl_vader_single_copy_mechanism=none

packages
configure
case "$mode" in
  run)
    compile --target asperity-programs
    simulate ;;
  test)
    compile
    [ "$strict" = no ] || check_debug
    run_tests ;;
esac
