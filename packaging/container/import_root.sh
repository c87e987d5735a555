#!/bin/sh
# import_root.sh ROOT IMAGE [OPTION...]: makes an image for buildah of a folder that debootstrap
# filled; OPTIONs are global ones of buildah, such as --storage-driver vfs.
set -eu
root=$1
image=$2
shift 2
container=$(buildah "$@" from scratch)
tar -C "$root" --one-file-system -cf "$root.tar" .
buildah "$@" add "$container" "$root.tar" /
buildah "$@" config --cmd /bin/bash "$container"
buildah "$@" commit --rm "$container" "$image"
rm "$root.tar"
