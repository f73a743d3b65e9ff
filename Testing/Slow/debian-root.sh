# SPDX-License-Identifier: GPL-3.0-or-later
# Sourced: a fresh root filesystem of a Debian release, and what is done in there. The caller sets suite (its code name)
# and work_dir (a folder whose name has fresh-debian. in it), and takes exit code 77 for skipped.
root="$work_dir/root"
skip() { echo "SKIPPED: $*"; exit 77; }

[[ "$(id -u)" == 0 ]] || skip "only root can make and enter a root filesystem"
command -v debootstrap >/dev/null || skip "debootstrap is not installed"
command -v chroot >/dev/null || skip "there is no chroot"

# The mirror that this machine itself uses, so that whoever is behind a proxy or a mirror of their own is served;
# Debian's mirrors have all its releases.
mirror="$(apt-get indextargets --format '$(ORIGIN) $(LABEL) $(REPO_URI)' 2>/dev/null |
  awk '$1 == "Debian" && $2 == "Debian" { print $3; exit }')"
[[ -n "$mirror" ]] || skip "apt on this machine has no mirror of Debian"
# A debootstrap that is older than the release knows no script of that name, but all new ones are like sid's.
script=()
[[ -e "/usr/share/debootstrap/scripts/$suite" ]] || script=(/usr/share/debootstrap/scripts/sid)

in_root() { chroot "$root" /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin TERM=dumb DEBIAN_FRONTEND=noninteractive "$@"; }

leave()
{
  for place in proc sys dev/shm dev/pts; do
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

# make_root PACKAGE ...: the release, its essential packages, and those named.
make_root()
{
  debootstrap --variant=minbase "$suite" "$root" "$mirror" "${script[@]}" >"$work_dir/debootstrap.log" 2>&1 ||
    { tail "$work_dir/debootstrap.log"; exit 1; }
  mount -t proc proc "$root/proc"
  mount -t sysfs -o ro sysfs "$root/sys"
  mkdir -p "$root/dev/shm"
  mount -t tmpfs tmpfs "$root/dev/shm"
  # Terminals of its own, which a test of the command line opens.
  mkdir -p "$root/dev/pts"
  mount -t devpts -o newinstance,ptmxmode=0666 devpts "$root/dev/pts"
  ln -sf pts/ptmx "$root/dev/ptmx"
  [[ -f /etc/resolv.conf ]] && cp -L /etc/resolv.conf "$root/etc/resolv.conf"
  # The host's way to the mirror, but nothing else of its settings.
  apt-config dump | grep -iE '^Acquire::(.*proxy|Check-)' >"$root/etc/apt/apt.conf.d/90proxy" || true
  in_root apt-get update >"$work_dir/apt.log" 2>&1
  in_root apt-get install -y --no-install-recommends "$@" >>"$work_dir/apt.log" 2>&1 ||
    { tail "$work_dir/apt.log"; exit 1; }
}

# What is committed in $source_dir, as /root/project.
clone()
{
  # Through a bundle: the root filesystem sees what is committed, and nothing of this machine.
  git -C "$source_dir" bundle create "$root/root/project.bundle" HEAD >/dev/null 2>&1
  in_root git -c advice.detachedHead=false clone -q /root/project.bundle /root/project
}

report()
{
  echo
  echo "Fresh Debian ($suite), $(nproc) processors:"
  printf '  %s\n' "${steps[@]}"
}
