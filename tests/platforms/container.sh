#!/usr/bin/env bash
# container.sh SOURCE WORK: builds the image of packaging/container from a root of its own, without
# a registry, and runs it as its user: one rank, two ranks by a plain mpirun, and figures.
#
# Needs root, debootstrap and buildah. SUITE (bookworm) is the release of Debian. Packages in
# SOURCE/debs are installed; without any the image builds them.
set -euo pipefail
source=$(cd "$1" && pwd)
mkdir -p "$2"
work=$(cd "$2" && pwd)
suite=${SUITE:-bookworm}
store=(--root "$work/storage" --runroot "$work/run" --storage-driver vfs)

[ -d "$work/$suite" ] || debootstrap --variant=minbase "$suite" "$work/$suite"
"$source/packaging/container/import_root.sh" "$work/$suite" "localhost/$suite" "${store[@]}"
buildah "${store[@]}" bud --isolation chroot --build-arg "BASE=localhost/$suite" \
  -t localhost/asperity -f "$source/packaging/container/Containerfile" "$source"

container=$(buildah "${store[@]}" from localhost/asperity)
trap 'buildah "${store[@]}" rm "$container" > /dev/null' EXIT
inside() { buildah "${store[@]}" run --isolation chroot "$container" -- bash -euc "$1"; }

user=$(inside 'id -un')
[ "$user" = asperity ] || { echo "The user is $user, not asperity." >&2; exit 1; }
decks=/usr/share/asperity/decks
inside "asperity $decks/spring_slider.xml --output one"
inside "mpirun -np 2 asperity $decks/spring_slider.xml --output two"
for run in one two; do
  inside "grep -q '<Parameter' $run/parameters.xml && asperity-status $run && asperity-plot $run"
  inside "ls $run/figures/*.png"
done
inside "asperity --version && test -d /usr/share/doc/asperity/docs"
echo "The image runs as $user on one and two ranks."
