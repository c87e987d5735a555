#!/usr/bin/env bash
# For roots.sh, in a mount namespace of its own:
#   one_root.sh SUITE WORK_FOLDER ARCHIVE COMPILER_CACHE
set -euo pipefail
suite=$1 work=$2 mirror=$3 cache=$4
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
top=$(cd "$here/../.." && pwd)
folder=$work/$suite
root=$folder/root
log=/dev/null
mkdir -p "$root"

# shellcheck disable=SC2317 # called by the trap
show_failure()
{
  [ "$?" -eq 0 ] || tail -n 25 "$log"
}
trap show_failure EXIT
step()
{
  log=$folder/$1.log
  printf '== %s: %s (%d s)\n' "$suite" "$1" "$SECONDS"
}
inside()
{
  chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 \
    DEBIAN_FRONTEND=noninteractive "$@"
}

make_root()
{
  local base=$suite name proxy
  [ "$suite" != experimental ] || base=sid
  debootstrap --variant=minbase --cache-dir="$work/archives" "$base" "$root" "$mirror"
  for name in proc dev sys; do
    mount --rbind "/$name" "$root/$name"
  done
  cp /etc/resolv.conf "$root/etc/"
  # Without its name mpirun waits for a name server, seconds each time.
  echo "127.0.0.1 localhost $(hostname)" > "$root/etc/hosts"
  # A copy of the archive may lag behind.
  echo 'Acquire::Check-Valid-Until "false";' > "$root/etc/apt/apt.conf.d/90archive"
  for name in http https; do
    proxy=${name}_proxy
    [ -z "${!proxy:-}" ] ||
      echo "Acquire::$name::Proxy \"${!proxy}\";" >> "$root/etc/apt/apt.conf.d/90archive"
  done
  if [ "$suite" = experimental ]; then # as `apt-get -t experimental`, for Trilinos alone
    echo "deb $mirror experimental main" > "$root/etc/apt/sources.list.d/experimental.list"
    printf '%s\n' 'Package: src:trilinos' 'Pin: release a=experimental' 'Pin-Priority: 990' \
      > "$root/etc/apt/preferences.d/trilinos"
  fi
}

# Who may use sudo, and has the tree as a folder without git; the root has no compiler.
make_user()
{
  inside apt-get update -qq
  inside apt-get install -y -qq --no-install-recommends sudo
  inside useradd --create-home --shell /bin/bash user
  echo 'user ALL=(ALL) NOPASSWD: ALL' > "$root/etc/sudoers.d/user"
  git -c safe.directory='*' clone -q --no-hardlinks "$top" "$root/home/user/asperity"
  if [ -n "$cache" ]; then
    inside apt-get install -y -qq --no-install-recommends ccache
    mkdir -p "$cache/$suite" "$root/ccache"
    mount --bind "$cache/$suite" "$root/ccache"
    inside chown -R user: /ccache
  fi
  inside chown -R user: /home/user
}

# Sets `result` where it fails, and `seconds`.
quickstart()
{
  local start=$SECONDS
  # shellcheck disable=SC2016 # a home in the root
  inside ${cache:+CCACHE_DIR=/ccache CCACHE_SLOPPINESS=pch_defines,time_macros} \
    su user -c 'cd "$HOME/asperity" && bash cmake/quickstart.sh '"$1" > "$log" 2>&1 ||
    { result=1; tail -n 25 "$log"; }
  seconds=$((SECONDS - start))
}

step root
make_root > "$log" 2>&1
step user
make_user > "$log" 2>&1
result=0
step run
quickstart run
run_seconds=$seconds
step test
quickstart test
step version
inside su user -c /home/user/asperity/build/drivers/asperity' --version' > "$log" 2>&1 || result=1
log=/dev/null
python3 -B "$here/table.py" row "$folder" "$run_seconds" "$seconds" ${cache:+--cached}
exit "$result"
