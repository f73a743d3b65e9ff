#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The VTK modules in a fresh root filesystem with Debian's VTK and no ParaView, by the lines of
# Documentation/installation.md; its tests are those of the core, of VTK's Python and of a stranger's program.
# Usage: plain-vtk.sh SUITE [SOURCE_DIR]; SUITE: bookworm (VTK 9.1), trixie (9.3), forky.
# Exit code 77 (skipped) where this machine cannot do it: not root, no debootstrap, no Debian mirror set up.
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
suite="${1:?which release of Debian?}"
source_dir="${2:-$(cd "$here/../.." && pwd)}"
work_dir="$(mktemp -d -t fresh-debian.XXXXXX)"
# shellcheck source=debian-root.sh
source "$here/debian-root.sh"

page="$source_dir/Documentation/installation.md"
line() { sed -n "s/^    \($1.*\)/\1/p" "$page" | head -n 1; }
packages="$(line 'apt install.*libvtk9-dev' | sed 's/^apt install //')"
commands="$(line 'cmake -S \. -B build\/vtk')"
[[ -n "$packages" && -n "$commands" ]] || { echo "FAILED: $page has no such lines"; exit 1; }

# shellcheck disable=SC2086 # a list of words on purpose
timed "debootstrap, packages" make_root git ca-certificates $packages
timed "clone" clone
((status == 0)) || exit 1
timed "build" in_root bash -c "cd /root/project && { $commands; } >/root/build.log 2>&1 || { tail -n 40 /root/build.log; false; }"
timed "tests" in_root ctest --test-dir /root/project/build/vtk -LE slow -j "$(nproc)" --output-on-failure
report
exit "$status"
