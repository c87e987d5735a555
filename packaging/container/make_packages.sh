#!/bin/sh
# make_packages.sh SOURCE TO: the packages for Debian, for Containerfile. Copies those in
# SOURCE/debs, but libasperity-dev; without any, installs what a build needs and builds them.
set -eu
source=$1
to=$2

build_packages()
{
  apt-get update
  DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends \
    g++ cmake ninja-build file dpkg-dev libopenmpi-dev openmpi-bin libhdf5-openmpi-dev \
    libmetis-dev libmuparser-dev libcli11-dev libeigen3-dev libgmsh-dev libptscotch-dev \
    libproj-dev libcgal-dev \
    trilinos-all-dev python3 python3-h5py python3-numpy python3-matplotlib
  cmake -S "$source" -B /build -G Ninja -DCMAKE_BUILD_TYPE=Release -DASPERITY_ENABLE_TESTS=OFF
  cmake --build /build
  (cd /build && cpack -G DEB -B "$source/debs")
}

ls "$source"/debs/*.deb > /dev/null 2>&1 || build_packages
mkdir -p "$to"
cp "$source"/debs/asperity*.deb "$to"
