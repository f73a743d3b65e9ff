#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The user's test of the Debian package: built here by `./run package`, judged by lintian, installed in a fresh root
# filesystem of this release, used as the documentation says, and removed, after which nothing of it is left.
# Usage: package.sh [SOURCE_DIR [PACKAGE.deb [SUITE]]]; without PACKAGE.deb it is built first, for this machine's release;
# SUITE is the release that another one was built for.
# Exit code 77 (skipped) where this machine cannot do it: not root, no debootstrap, no lintian, no Debian mirror set up.
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
source_dir="${1:-$(cd "$here/../.." && pwd)}"
suite="${3:-$(. /etc/os-release && printf '%s' "${VERSION_CODENAME:-}")}"
work_dir="$(mktemp -d -t fresh-debian.XXXXXX)"
# shellcheck source=debian-root.sh
source "$here/debian-root.sh"
command -v lintian >/dev/null || skip "lintian is not installed"

built() { package="$("$source_dir/run" package)"; }
judged() { lintian --allow-root --fail-on error,warning "$package"; }
installed()
{
  cp "$package" "$root/root/"
  in_root apt-get install -y --no-install-recommends "/root/$(basename "$package")" >"$work_dir/install.log" 2>&1 ||
    { tail "$work_dir/install.log"; return 1; }
}

# ParaView has the plugin without any setting, and a script needs no LoadPlugin.
listed()
{
  cat >"$root/root/listed.py" <<'END'
from paraview.simple import *
contours = NUAGESContourReader(FileName="/usr/share/doc/contour-reconstruction/examples/Data/brain.cnt")
certificate = SurfaceCertificate(Input=PolyhedralSurface(Input=contours), Contours=contours)
certificate.UpdatePipeline()
assert certificate.PointData.GetNumberOfArrays() >= 0 and contours.GetDataInformation().GetNumberOfCells() > 0
assert certificate.GetDataInformation().GetNumberOfCells() > 1000
END
  in_root pvpython --force-offscreen-rendering /root/listed.py
}

reconstructed()
{
  in_root contour-reconstruct /usr/share/doc/contour-reconstruction/examples/Data/brain.cnt /root/brain.stl &&
    [[ -s "$root/root/brain.stl" ]] && in_root contour-reconstruct --help >/dev/null
}

# ParaView's own list of plugins, where it has one.
own_list() { in_root sh -c 'cat /usr/lib/*/paraview-*/paraview.conf 2>/dev/null' || true; }

# Nothing of it is left but what belongs to another package, and ParaView's own list says what it said.
removed()
{
  in_root dpkg -L contour-reconstruction | grep -E '/(contour|paraview\.conf)' >"$work_dir/files"
  in_root apt-get purge -y contour-reconstruction >"$work_dir/purge.log" 2>&1 || { tail "$work_dir/purge.log"; return 1; }
  local file
  while read -r file; do
    [[ ! -e "$root$file" ]] || in_root dpkg -S "$file" >/dev/null 2>&1 || { echo "$file is left"; return 1; }
  done <"$work_dir/files"
  [[ -z "$(in_root dpkg-divert --list '*paraview*')" ]] || { echo "a diversion is left"; return 1; }
  [[ "$(own_list)" == "$listed_before" ]] || { echo "ParaView's own list of plugins is another one"; return 1; }
}

if [[ -n "${2:-}" ]]; then
  package="$(realpath "$2")"
else
  timed "./run package" built
fi
timed "lintian" judged
timed "debootstrap, ParaView" make_root ca-certificates paraview python3-paraview
listed_before="$(own_list)"
timed "install" installed
((status == 0)) || { report; exit 1; }
timed "ParaView has the plugin" listed
timed "contour-reconstruct" reconstructed
timed "remove" removed
report
exit "$status"
