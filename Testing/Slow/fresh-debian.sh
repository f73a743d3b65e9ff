#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The newcomer's test: a fresh Debian 12 root filesystem, git, a clone of this repository, and nothing else;
# then `./run demo` and `./run test` in there. Prints how long each step took.
# Usage: fresh-debian.sh [SOURCE_DIR [WORK_DIR]]
# Exit code 77 (skipped) where this machine cannot do it: not root, no debootstrap, no Debian mirror set up.
set -euo pipefail

source_dir="${1:-$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)}"
work_dir="${2:-$(mktemp -d -t fresh-debian.XXXXXX)}"
root="$work_dir/root"
skip() { echo "SKIPPED: $*"; exit 77; }

[[ "$(id -u)" == 0 ]] || skip "only root can make and enter a root filesystem"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
command -v chroot >/dev/null || skip "there is no chroot"

# The mirror that this machine itself uses, so that whoever is behind a proxy or a mirror of their own is served.
mirror="$(apt-get indextargets --format '$(CODENAME) $(ORIGIN) $(REPO_URI)' 2>/dev/null |
  awk '$1 == "bookworm" && $2 == "Debian" { print $3; exit }')"
[[ -n "$mirror" ]] || skip "apt on this machine has no mirror of Debian 12 (bookworm)"

in_root() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb DEBIAN_FRONTEND=noninteractive "$@"; }

leave()
{
  for place in proc sys dev/shm; do
    # Never remove anything below a place that is still mounted.
    ! mountpoint -q "$root/$place" || umount "$root/$place" || return 0
  done
  [[ "$work_dir" == *fresh-debian.* ]] && rm -rf "$work_dir"
  return 0
}
trap leave EXIT

declare -a steps
status=0
timed()
{
  local name="$1" start=$SECONDS verdict=ok
  shift
  echo "== $name"
  "$@" || { verdict=FAILED status=1; }
  steps+=("$(printf '%-42s %5d s  %s' "$name" "$((SECONDS - start))" "$verdict")")
}

make_root()
{
  debootstrap --variant=minbase bookworm "$root" "$mirror" >"$work_dir/debootstrap.log" 2>&1 ||
    { tail "$work_dir/debootstrap.log"; exit 1; }
  mount -t proc proc "$root/proc"
  mount -t sysfs -o ro sysfs "$root/sys"
  mkdir -p "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/dev/shm"
  [[ -f /etc/resolv.conf ]] && cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  # The host's way to the mirror, but nothing else of its settings.
  apt-config dump | grep -i '^Acquire::.*proxy' >"$root/etc/apt/apt.conf.d/90proxy" || true
  in_root apt-get update >"$work_dir/apt.log" 2>&1
  in_root apt-get install -y --no-install-recommends git ca-certificates >>"$work_dir/apt.log" 2>&1 ||
    { tail "$work_dir/apt.log"; exit 1; }
}

clone()
{
  # Through a bundle: the root filesystem sees what is committed, and nothing of this machine.
  git -C "$source_dir" bundle create "$root/root/project.bundle" HEAD >/dev/null 2>&1
  in_root git -c advice.detachedHead=false clone -q /root/project.bundle /root/project
}

timed "debootstrap, git" make_root
timed "clone" clone
((status == 0)) || exit 1
timed "./run demo (with setup and build)" in_root /root/project/run demo
timed "./run demo again" in_root /root/project/run demo
timed "./run test" in_root /root/project/run test
echo
echo "Fresh Debian 12, $(nproc) processors:"
printf '  %s\n' "${steps[@]}"
ls -la "$root/root/project/demo-output" || status=1
exit "$status"
