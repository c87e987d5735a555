#!/usr/bin/env bash
# Installs our packages for Debian in a root that debootstrap has just made, and uses them there as
# an ordinary user: programs, figures, two ranks, pip without an index, a plugin by find_package.
#
#     fresh_root.sh BUILD_FOLDER WORK_FOLDER
#
# Needs root and debootstrap; archive and keys are those that apt uses on this machine. Takes 2 GB
# and many minutes. Status 77 where it cannot be tried.
set -euo pipefail
build=$1 work=$2
root=$work/root

skip() { echo "skipped: $1"; exit 77; }
[ "$(id -u)" = 0 ] || skip "not root"
command -v debootstrap > /dev/null || skip "no debootstrap"
command -v cpack > /dev/null || skip "no cpack"
command -v file > /dev/null || skip "no file"
command -v dpkg-shlibdeps > /dev/null || skip "no dpkg-shlibdeps, of the package dpkg-dev"
if [ "${ASPERITY_OWN_MOUNTS:-}" != 1 ]; then # what is mounted below goes with this process
  ASPERITY_OWN_MOUNTS=1 exec unshare --mount -- "$0" "$@"
fi

step() { printf '== %s (%d s)\n' "$1" "$SECONDS"; }
inside()
{
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 "${proxy[@]}" "$@"
}
as_user() { inside su user -c "cd && $1"; }
apt_install()
{
  inside DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "$@" \
    > "$work/apt.log" 2>&1 || { tail -20 "$work/apt.log"; exit 1; }
}
expect() # FILE PATTERN
{
  grep -Eq "$2" "$1" || { echo "'$2' is not in $1:"; tail -20 "$1"; exit 1; }
}
proxy=()
for name in http_proxy https_proxy no_proxy; do
  [ -z "${!name:-}" ] || proxy+=("$name=${!name}")
done

step "packages"
rm -rf "$work"
mkdir -p "$root" "$work/packages"
(cd "$build" && cpack -G DEB -B "$work/packages" > "$work/cpack.log" 2>&1) ||
  { tail -20 "$work/cpack.log"; exit 1; }
for name in asperity asperity-mesh libasperity-dev asperity-doc; do
  ls "$work"/packages/"${name}"_*.deb
done

step "a fresh root"
# The release that the packages are made on; sid calls itself by the next release's name.
archives=$(apt-get indextargets --format '$(REPO_URI) $(CODENAME)')
for suite in "$(. /etc/os-release && echo "$VERSION_CODENAME")" sid; do
  mirror=$(awk -v suite="$suite" '$2 == suite { print $1; exit }' <<< "$archives")
  [ -z "$mirror" ] || break
done
[ -n "$mirror" ] || skip "apt names no archive of this release"
debootstrap --variant=minbase "$suite" "$root" "$mirror" > "$work/debootstrap.log" 2>&1 ||
  { tail -20 "$work/debootstrap.log"; exit 1; }
mount -t proc proc "$root/proc"
mount --rbind /dev "$root/dev"
mount --rbind /sys "$root/sys" # without it hwloc prints lines of its own
cp /etc/resolv.conf "$root/etc/"
rm -f "$root/etc/apt/sources.list"
cp -r /etc/apt/sources.list* "$root/etc/apt/"
cp -r /usr/share/keyrings/. "$root/usr/share/keyrings/"
inside apt-get update -qq
inside useradd --create-home user
cp "$work"/packages/*.deb "$root/home/user/"

step "programs"
debs=$(cd "$root" && ls home/user/asperity_*.deb home/user/asperity-mesh_*.deb \
  home/user/asperity-doc_*.deb | sed 's#^#/#')
# shellcheck disable=SC2086  # several names
apt_install $debs
as_user "asperity --version" > "$work/version.log"
expect "$work/version.log" "^Asperity [0-9.]+ on "
as_user "asperity /usr/share/asperity/decks/spring_slider.xml \
  --set 'Time Stepping/Final Time=600' --output slider" > "$work/slider.log"
expect "$root/home/user/slider/events.csv" "^1,"
as_user "mpirun --oversubscribe -np 2 asperity /usr/share/asperity/decks/spring_slider.xml \
  --set 'Time Stepping/Final Time=20' --set 'Mesh/Rectangle/Cells X=2' --output ranks" \
  > "$work/ranks.log"
expect "$work/ranks.log" "2 ranks"
as_user "asperity-plot slider --dpi 40" > "$work/plot.log"
[ -s "$root/home/user/slider/figures/slip_rate.png" ]
as_user "asperity-report slider && asperity-status slider" > "$work/report.log"
expect "$work/report.log" "finished"
as_user "asperity-mesh wedge wedge.h5 && asperity-mesh info wedge.h5" > "$work/mesh.log"
expect "$work/mesh.log" "base"
[ -s "$root/usr/share/doc/asperity-doc/README.md" ] ||
  find "$root/usr/share/doc" -name 'model.md*' | grep -q . || { echo "no documents"; exit 1; }

step "pip without an index"
apt_install python3-venv python3-pip python3-setuptools python3-wheel
as_user "cp -r /usr/share/asperity/python . && python3 -m venv --system-site-packages own &&
  own/bin/pip install --no-index --no-build-isolation ./python" > "$work/pip.log"
as_user "own/bin/python -c \"import asperity
run = asperity.Run('slider')
print(asperity.__file__, len(run.events), run.fault['slip_rate'].shape)\"" > "$work/module.log"
expect "$work/module.log" "^/home/user/own/.* 1 "

step "a plugin by find_package"
apt_install "$(cd "$root" && ls home/user/libasperity-dev_*.deb | sed 's#^#/#')"
as_user "cp -r /usr/share/asperity/examples/plugin . && cmake -S plugin -B plugin_build &&
  cmake --build plugin_build" > "$work/plugin.log" 2>&1
as_user "asperity --plugin plugin_build/libviscous.so plugin/viscous.xml --output viscous" \
  > "$work/viscous.log"
# exactly 1e-6 (1000 - 500 (1 - exp(-2))) = 5.67668e-4
expect "$root/home/user/viscous/mean_slip.csv" "^1000,0\\.000567(66|67)"
step "all done"
