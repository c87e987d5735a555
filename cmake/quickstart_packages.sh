# The first phase of quickstart.sh, which sources this file: names the Debian packages that are
# missing, says what they are for, and installs them as root or through sudo.
# Taken from quickstart.sh: mode (run or test), install (yes or no), fail, phase, phase_done.
# shellcheck shell=bash disable=SC2154

# "purpose: packages", one line each. a|b means the first one that the release has; - means none.
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
figures: python3 python3-h5py python3-numpy python3-matplotlib
LIST
  if [ "${mode:-}" = test ]; then
    # Other versions of clang-format format differently; without 14 the test style.format is left
    # out.
    echo 'tests: libgtest-dev clang-format-14|-'
  fi
  own_trilinos > /dev/null || trilinos_packages
}

# TrilinosConfig.cmake needs all of these, and Debian's packages do not depend on each other.
# Trilinos 17 has neither Epetra nor the packages that use it.
trilinos_packages()
{
  local name
  printf 'linear algebra (Trilinos, Kokkos): libptscotch-dev'
  for name in amesos2 anasazi belos galeri ifpack2 intrepid2 kokkos kokkos-kernels muelu rtop \
    sacado shards shylu stratimikos teko teuchos thyra tpetra trilinosss xpetra zoltan zoltan2; do
    printf ' libtrilinos-%s-dev' "$name"
  done
  for name in amesos aztecoo epetra epetraext ifpack isorropia ml triutils; do
    printf ' libtrilinos-%s-dev|-' "$name"
  done
  printf '\n'
}

optional_packages()
{
  echo 'meshes from Gmsh, asperity-mesh (optional): libgmsh-dev|-'
  if [ "${mode:-}" = test ]; then
    echo 'projections in asperity-mesh (optional): libproj-dev|-'
    echo 'meshes from surfaces of faults, asperity-mesh build (optional): libcgal-dev|-'
    echo 'faster rebuilds (optional): ccache|-'
    echo 'tests of pip without a network (optional): python3-pip|- python3-venv|-' \
      'python3-setuptools|- python3-wheel|-'
    echo 'the manual, and a browser that reads it (optional): python3-sphinx|-' \
      'python3-myst-parser|- python3-breathe|- furo|- doxygen|- chromium|-'
  fi
}

# The TrilinosConfig.cmake that the user's environment variables lead to, as CMake finds it.
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

# Sets `installed` and `offered`: names of packages, with a space before and after each. Packages of
# Trilinos with another version than trilinos-dev, from another release, do not count as offered.
read_system()
{
  installed=" $(dpkg-query -W -f '${db:Status-Status} ${Package}\n' 2> /dev/null |
    sed -n 's/^installed //p' | tr '\n' ' ') "
  offered=" $({ required_packages; optional_packages; } | sed 's/^[^:]*://' | tr -s ' ' '\n' |
    tr '|' '\n' | sed '/^-\{0,1\}$/d' | LC_ALL=C xargs apt-cache policy trilinos-dev 2> /dev/null |
    awk '/^[^ ]/ { name = $1; sub(/:$/, "", name) }
      $1 == "Candidate:" && $2 != "(none)" {
        if (name == "trilinos-dev") trilinos = $2
        else if (name !~ /^libtrilinos-/ || trilinos == "" || $2 == trilinos) print name
      }' | tr '\n' ' ') "
}

# Sets `chosen`: of a|b the name that is installed, or else the first that the release has; nothing
# for -. If neither exists, for example because the lists of packages were never fetched, the first.
choose()
{
  local -a choices
  IFS='|' read -r -a choices <<< "$1"
  for chosen in "${choices[@]}"; do
    [[ $installed != *" $chosen "* ]] || return 0
  done
  if [[ $offered == *[a-z]* ]]; then
    for chosen in "${choices[@]}"; do
      [ "$chosen" != - ] || { chosen=; return 0; }
      [[ $offered != *" $chosen "* ]] || return 0
    done
  fi
  chosen=${choices[0]}
}

# Replaces the packages of "purpose: packages" lines by their chosen names, and keeps those for
# which the given condition holds; lines without packages are left out.
select_of()
{
  local purpose packages package chosen kept
  while IFS=: read -r purpose packages; do
    kept=
    for package in $packages; do
      choose "$package"
      [ -z "$chosen" ] || ! "$1" "$chosen" || kept+=" $chosen"
    done
    [ -z "$kept" ] || printf '%s:%s\n' "$purpose" "$kept"
  done
}
any() { true; }
missing() { [[ $installed != *" $1 "* ]]; }
unknown() { missing "$1" && [[ $offered == *[a-z]* && $offered != *" $1 "* ]]; }

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
  apt install -y --no-install-recommends "$@" 2>&1 | tee "$log" |
    sed -u -n '/^Need to get/s/^/      /p; /^After this operation/s/^/      /p' || status=$?
  [ "$status" -eq 0 ] || tail -n 25 "$log"
  rm -f "$log"
  return "$status"
}

# Sets `required`, `optional` and `names` to the packages that are missing.
find_missing()
{
  read_system
  required=$(required_packages | select_of missing)
  optional=$(optional_packages | select_of missing)
  names=$(printf '%s\n%s\n' "$required" "$optional" | sed '/^$/d' | names_of)
}

show_missing()
{
  printf '      Debian packages to install, and what for:\n'
  printf '%s\n%s\n' "$required" "$optional" | show_packages
}

without_root()
{
  show_missing
  [ -z "$required" ] || fail "you are not root and there is no sudo. Run as root:

  apt-get update && apt-get install --no-install-recommends $names

or, if you have these libraries elsewhere, use --no-install."
  printf '      You are not root and there is no sudo, so that they are not installed.\n'
}

# What the release offers is known after its lists have been fetched.
fetch_and_install()
{
  local lacking
  apt update > /dev/null 2>&1 ||
    printf '      apt-get update failed; the known lists of packages are used.\n'
  find_missing
  [ -n "$names" ] || return 0
  show_missing
  lacking=$(required_packages | select_of unknown)
  [ -z "$lacking" ] || fail "this release does not have these packages, which the build needs:
$(show_packages <<< "$lacking")
If you have these elsewhere, use --no-install; docs/cost/platforms.md lists the tested releases."
  # shellcheck disable=SC2086 # a list of names
  install_packages $names || [ -z "$required" ] ||
    fail "apt-get could not install the packages; see its last lines above. If you have these
libraries elsewhere, use --no-install."
}

packages()
{
  local installed offered required optional names
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
    { required_packages; optional_packages; } | sed 's/|[^ ]*//g' | show_packages
    printf '      CMake looks for them next.\n'
    return
  fi
  find_missing
  if [ -z "$names" ]; then
    printf '      All packages are installed.\n'
  elif [ "$(id -u)" -ne 0 ] && ! command -v sudo > /dev/null; then
    without_root
  else
    fetch_and_install
  fi
  phase_done
}
