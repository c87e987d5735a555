#!/usr/bin/env bash
# Builds Trilinos 13.2 with Kokkos' OpenMP from Debian 12's source package, with what Asperity needs
# and no more:
#
#     bash cmake/trilinos_openmp.sh [--jobs N] [--kokkos-only] FOLDER
#     cmake -S . -B build-openmp -DASPERITY_BACKEND=OpenMP -DTrilinos_ROOT=FOLDER/install
#
# FOLDER gets the source (170 MB to download, 1.5 GB unpacked), the build and the installation. Run
# it again after an interruption: it continues. It needs no root and does not change apt's lists.
# --kokkos-only builds Kokkos alone, in minutes, for -DASPERITY_KERNELS_ONLY=ON with
# -DKokkos_ROOT=FOLDER/install. The environment variable CXXFLAGS replaces the flags "-O2 -DNDEBUG".
#
# Debian packages: g++ gfortran cmake ninja-build dpkg-dev libopenmpi-dev liblapack-dev.
set -euo pipefail

jobs=1
packages="Kokkos KokkosKernels Teuchos Tpetra Xpetra Belos Ifpack2 MueLu"
folder=
while [ $# -gt 0 ]; do
  case $1 in
    --jobs) jobs=$2; shift ;;
    --kokkos-only) packages=Kokkos ;;
    -*) sed -n '2,14s/^# \{0,1\}//p' "$0"; exit 2 ;;
    *) folder=$1 ;;
  esac
  shift
done
[ -n "$folder" ] || { sed -n '2,14s/^# \{0,1\}//p' "$0"; exit 2; }
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)

# The archive that this machine takes its packages from.
own_mirror() { apt-get indextargets --format '$(SITE)' | sort -u | sed -n 1p; }

# apt's configuration and lists for source packages are in FOLDER: /etc/apt is not changed.
fetch_source()
{
  local apt=$folder/apt
  mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
  echo "deb-src [signed-by=/usr/share/keyrings/debian-archive-keyring.gpg]" \
    "${DEBIAN_MIRROR:-$(own_mirror)} bookworm main" > "$apt/sources.list"
  local -a options=(-q -o "Dir::Etc::sourcelist=$apt/sources.list" -o Dir::Etc::sourceparts=-
    -o "Dir::State::lists=$apt/lists" -o "Dir::Cache=$apt/cache")
  apt-get "${options[@]}" update
  (cd "$folder" && apt-get "${options[@]}" source --download-only trilinos)
  (cd "$folder" && dpkg-source --no-check -x trilinos_13.2.0-*.dsc source.part)
  mv "$folder/source.part" "$folder/source"
}

# Tpetra for double, int and long long only, and for one node type, OpenMP. The templates of MueLu
# and Ifpack2 are instantiated only in the one file of Asperity that uses them, so that fewer files
# are compiled here.
configure()
{
  local build=$1 package
  local -a enable=()
  for package in $packages; do
    enable+=("-DTrilinos_ENABLE_$package=ON")
  done
  cmake -S "$folder/source" -B "$build" -G Ninja \
    -DCMAKE_INSTALL_PREFIX="$folder/install" \
    -DCMAKE_C_COMPILER=mpicc -DCMAKE_CXX_COMPILER=mpicxx -DCMAKE_Fortran_COMPILER=mpif90 \
    -DCMAKE_BUILD_TYPE=NONE -DCMAKE_CXX_FLAGS="${CXXFLAGS:--O2 -DNDEBUG} -w" \
    -DCMAKE_C_FLAGS="-O2 -DNDEBUG -w" -DBUILD_SHARED_LIBS=ON \
    -DTPL_ENABLE_MPI=ON -DTPL_ENABLE_DLlib=ON \
    -DTrilinos_ENABLE_OpenMP=ON -DKokkos_ENABLE_OPENMP=ON -DKokkos_ENABLE_SERIAL=ON \
    -DTpetra_INST_OPENMP=ON -DTpetra_INST_SERIAL=OFF \
    -DTpetra_INST_DOUBLE=ON -DTpetra_INST_INT_LONG_LONG=ON -DTpetra_INST_INT_LONG=OFF \
    -DTpetra_INST_INT_INT=OFF -DTpetra_INST_COMPLEX_DOUBLE=OFF -DTpetra_INST_FLOAT=OFF \
    -DTrilinos_ENABLE_EXPLICIT_INSTANTIATION=ON -DMueLu_ENABLE_EXPLICIT_INSTANTIATION=OFF \
    -DIfpack2_ENABLE_EXPLICIT_INSTANTIATION=OFF -DTrilinos_ENABLE_Amesos2=OFF \
    -DKokkosKernels_INST_EXECSPACE_SERIAL=OFF \
    -DTrilinos_ENABLE_ALL_OPTIONAL_PACKAGES=OFF -DTrilinos_ENABLE_TESTS=OFF \
    -DTrilinos_ENABLE_EXAMPLES=OFF -DTrilinos_ENABLE_Epetra=OFF -DTrilinos_ENABLE_ThyraCore=OFF \
    -DTrilinos_INSTALL_TriBITS=OFF "${enable[@]}"
}

[ -d "$folder/source" ] || fetch_source
build=$folder/build
[ "$packages" != Kokkos ] || build=$folder/build-kokkos
configure "$build"
cmake --build "$build" --parallel "$jobs"
cmake --install "$build" > "$folder/install.log"
echo "Installed in $folder/install"
