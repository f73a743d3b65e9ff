#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The newcomer's test: a fresh root filesystem of a Debian release, git, a clone of this repository, and nothing else;
# then `./run demo` and `./run test` in there. Prints how long each step took.
# Usage: fresh-debian.sh SUITE [SOURCE_DIR [WORK_DIR]]; SUITE: bookworm (Debian 12), trixie (13), forky.
# Exit code 77 (skipped) where this machine cannot do it: not root, no debootstrap, no Debian mirror set up.
set -euo pipefail

here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
suite="${1:?which release of Debian?}"
source_dir="${2:-$(cd "$here/../.." && pwd)}"
work_dir="${3:-$(mktemp -d -t fresh-debian.XXXXXX)}"
# shellcheck source=debian-root.sh
source "$here/debian-root.sh"

timed "debootstrap, git" make_root git ca-certificates
timed "clone" clone
((status == 0)) || exit 1
timed "./run demo (with setup and build)" in_root /root/project/run demo
timed "./run demo again" in_root /root/project/run demo
timed "./run test" in_root /root/project/run test
report
ls -la "$root/root/project/demo-output" || status=1
exit "$status"
