#!/usr/bin/env bash
# Compiles the packages that need Kokkos alone, friction and multigrid, for a device with nvcc: to
# object code, which says that they compile and nothing about results. No device is needed.
#
#   device_objects.sh [--work DIR] [--arch sm_90] [--jobs N]
#
# The headers are those of Kokkos 5 in Debian sid's libkokkos-dev, which come with all backends;
# their configuration is changed from OpenMP to CUDA and Serial. Needs nvcc, Eigen, apt and a
# network. Status 0: all compile, 1: not all, 77: it cannot be tried here.
set -euo pipefail
top=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)

skip() { echo "skipped: $1"; exit 77; }
usage() { sed -n '2,9s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; }

work=$top/build/device_objects
arch=sm_90
jobs=1
while [ $# -gt 0 ]; do
  [ $# -ge 2 ] || { usage >&2; exit 2; }
  case "$1" in
    --work) work=$2 ;;
    --arch) arch=$2 ;;
    --jobs) jobs=$2 ;;
    *) usage >&2; exit 2 ;;
  esac
  shift 2
done
nvcc=$(command -v nvcc || echo /usr/local/cuda/bin/nvcc)
[ -x "$nvcc" ] || skip "no nvcc"
work=$(realpath -m "$work")
kokkos=$work/kokkos

# A state of apt of its own, so that the system's lists stay as they are.
download()
{
  local archive
  # shellcheck disable=SC2016 # apt's own names
  archive=$(apt-get indextargets --format '$(REPO_URI) $(COMPONENT)' 2> /dev/null |
    awk '$2 == "main" && $1 ~ /debian\/?$/ { print $1; exit }')
  [ -n "$archive" ] || skip "apt names no archive of Debian"
  mkdir -p "$work"/apt/{lists,cache/archives}/partial
  echo "deb $archive sid main" > "$work/apt/sources.list"
  local -a options=(-qq -o "Dir::Etc::sourcelist=$work/apt/sources.list"
    -o Dir::Etc::sourceparts=/dev/null -o "Dir::State::lists=$work/apt/lists"
    -o "Dir::Cache=$work/apt/cache" -o Dir::State::status=/dev/null
    -o Acquire::Check-Valid-Until=false)
  (cd "$work" && apt-get "${options[@]}" update && apt-get "${options[@]}" download libkokkos-dev)
  dpkg-deb -x "$work"/libkokkos-dev_*.deb "$work/package"
}

# In a folder of headers, the backends as Kokkos's own CMake writes them.
select_cuda()
{
  local headers=$1 name kind folder
  local -a names=(ENABLE_SERIAL ENABLE_CUDA)
  case "$arch" in
    sm_80) names+=(ARCH_AMPERE ARCH_AMPERE80) ;;
    sm_90) names+=(ARCH_HOPPER ARCH_HOPPER90) ;;
    *) echo "device_objects.sh knows sm_80 and sm_90." >&2; exit 2 ;;
  esac
  for name in "${names[@]}"; do
    sed -i "s|/\* #undef KOKKOS_$name \*/|#define KOKKOS_$name|" "$headers/KokkosCore_config.h"
  done
  sed -i '/#define KOKKOS_ENABLE_OPENMP$/d' "$headers/KokkosCore_config.h"
  sed -i 's|/\* #undef DESUL_ATOMICS_ENABLE_CUDA \*/|#define DESUL_ATOMICS_ENABLE_CUDA|
          /#define DESUL_ATOMICS_ENABLE_OPENMP/d' "$headers/desul/atomics/Config.hpp"
  for kind in Declare Fwd; do
    folder=$([ "$kind" = Declare ] && echo decl || echo fwd)
    printf '#include <%s/Kokkos_%s_%s.hpp>\n' "$folder" "$kind" SERIAL "$folder" "$kind" CUDA \
      > "$headers/KokkosCore_Config_${kind}Backend.hpp"
  done
  echo '#include <setup/Kokkos_Setup_Cuda.hpp>' > "$headers/KokkosCore_Config_SetupBackend.hpp"
}

# Of warnings in headers that are not ours, those on functions which they mark for both sides.
compile()
{
  local object
  object=$work/$(echo "${1#"$top/packages/"}" | tr / _).o
  if "$nvcc" "-arch=$arch" -std=c++20 -x cu --expt-extended-lambda --expt-relaxed-constexpr \
    -diag-suppress 20011,20012,20014 -O2 -I "$kokkos" -I "$top/packages" \
    -I /usr/include/eigen3 -c "$1" -o "$object" > "$object.log" 2>&1; then
    echo "compiled ${1#"$top/"}"
  else
    echo "FAILED   ${1#"$top/"}"
    grep -m 3 error "$object.log" || true
    return 1
  fi
}

if [ ! -d "$kokkos" ]; then
  download
  select_cuda "$work/package/usr/include/kokkos"
  mv "$work/package/usr/include/kokkos" "$kokkos"
fi
export -f compile
export nvcc arch work kokkos top
# shellcheck disable=SC2016 # expanded by the inner shell
find "$top/packages/friction" "$top/packages/multigrid" -name '*.cpp' -print0 | sort -z |
  xargs -0 -n 1 -P "$jobs" bash -c 'compile "$1"' _ || exit 1
