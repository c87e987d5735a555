# The first phase of quickstart.sh, which sources this file: names the Debian packages that are
# missing, says what they are for, and installs them as root or through sudo.
# Taken from quickstart.sh: mode (run or test), install (yes or no), fail, phase, phase_done.
# shellcheck shell=bash disable=SC2154

# "purpose: packages", one line each.
required_packages()
{
  cat <<'LIST'
compiler and build: g++ cmake make ninja-build
MPI: libopenmpi-dev openmpi-bin
results in parallel HDF5: libhdf5-openmpi-dev
mesh partitioning: libmetis-dev
expressions in decks: libmuparser-dev
command lines: libcli11-dev
sparse Cholesky: libeigen3-dev
tests: libgtest-dev clang-format-14
figures: python3 python3-h5py python3-numpy python3-matplotlib
LIST
  if ! own_trilinos > /dev/null; then
    # TrilinosConfig.cmake asks for all of these, and Debian's packages do not pull each other in.
    printf 'linear algebra (Trilinos, Kokkos): libptscotch-dev'
    printf ' libtrilinos-%s-dev' amesos amesos2 anasazi aztecoo belos epetra epetraext galeri \
      ifpack ifpack2 intrepid2 isorropia kokkos kokkos-kernels ml muelu rtop sacado shards shylu \
      stratimikos teko teuchos thyra tpetra triutils trilinosss xpetra zoltan zoltan2
    printf '\n'
  fi
}

optional_packages()
{
  cat <<'LIST'
faster rebuilds (optional): ccache
meshes from Gmsh, asperity-mesh (optional): libgmsh-dev
LIST
  if [ "${mode:-}" = test ]; then
    printf 'tests of pip without a network (optional):'
    printf ' python3-%s' pip venv setuptools wheel
    printf '\n'
  fi
}

# The TrilinosConfig.cmake the user points to, by the places where CMake looks.
own_trilinos()
{
  local prefix file
  local -a prefixes
  IFS=':;' read -r -a prefixes <<< "${Trilinos_ROOT:-}:${Trilinos_DIR:-}:${CMAKE_PREFIX_PATH:-}"
  for prefix in "${prefixes[@]}"; do
    [ -n "$prefix" ] || continue
    for file in "$prefix"/{,lib*/,lib*/*/,share/}{,cmake/Trilinos/}TrilinosConfig.cmake; do
      if [ -f "$file" ]; then
        printf '%s\n' "$file"
        return 0
      fi
    done
  done
  return 1
}

# Keeps of "purpose: packages" lines what is not installed; lines with nothing left disappear.
missing_of()
{
  local purpose packages package missing
  while IFS=: read -r purpose packages; do
    missing=
    for package in $packages; do
      [[ $installed == *" $package "* ]] || missing+=" $package"
    done
    [ -z "$missing" ] || printf '%s:%s\n' "$purpose" "$missing"
  done
}

# "purpose: packages" lines for the reader, wrapped.
show_packages()
{
  local line
  while IFS= read -r line; do
    [ -z "$line" ] || fold -s -w 84 <<< "$line" | sed '1s/^/        /; 1!s/^/          /'
  done
}

# Only the packages of "purpose: packages" lines, in one line.
names_of()
{
  local purpose packages all=
  while IFS=: read -r purpose packages; do
    all+=$packages
  done
  printf '%s' "${all# }"
}

apt()
{
  local -a as_root=()
  [ "$(id -u)" -eq 0 ] || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@"
}

# Writes apt-get's output to a file and shows the sizes, and the last lines if it fails.
install_packages()
{
  local log status=0
  log=$(mktemp)
  apt update > "$log" 2>&1 ||
    printf '      apt-get update failed; the known lists of packages are used.\n'
  apt install -y --no-install-recommends "$@" 2>&1 | tee -a "$log" |
    sed -n '/^Need to get/s/^/      /p; /^After this operation/s/^/      /p' || status=$?
  if [ "$status" -ne 0 ]; then
    tail -n 25 "$log"
    rm -f "$log"
    return 1
  fi
  rm -f "$log"
}

packages()
{
  local required optional names
  phase 'Packages'
  if own_trilinos > /dev/null; then
    printf '      Your Trilinos: %s\n' "$(own_trilinos)"
  fi
  if [ "$install" = no ]; then
    printf '      No package is installed, because of --no-install.\n'
    return
  fi
  if ! command -v apt-get > /dev/null || ! command -v dpkg-query > /dev/null; then
    printf '      This is not Debian. The build needs, by their Debian names:\n'
    { required_packages; optional_packages; } | show_packages
    printf '      CMake looks for them next.\n'
    return
  fi
  installed=" $(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2> /dev/null |
    sed -n 's/^installed //p' | tr '\n' ' ') "
  required=$(required_packages | missing_of)
  optional=$(optional_packages | missing_of)
  if [ -z "$required$optional" ]; then
    printf '      All packages are installed.\n'
    return
  fi
  printf '      Debian packages to install, and what for:\n'
  printf '%s\n%s\n' "$required" "$optional" | show_packages
  names=$(printf '%s\n%s\n' "$required" "$optional" | sed '/^$/d' | names_of)
  if [ "$(id -u)" -ne 0 ] && ! command -v sudo > /dev/null; then
    [ -z "$required" ] || fail "you are not root and there is no sudo. Ask for, as root:

  apt-get update && apt-get install --no-install-recommends $names

or, if you have these libraries elsewhere, say --no-install."
    printf '      You are not root and there is no sudo, so that they are not installed.\n'
    return
  fi
  # shellcheck disable=SC2086 # a list of names
  install_packages $names || [ -z "$required" ] ||
    fail "apt-get could not install the packages; its last lines stand above. The names are those of
Debian 12. If you have these libraries elsewhere, say --no-install."
  phase_done
}
