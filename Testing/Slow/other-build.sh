#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The core's tests once more in another preset: dev keeps CGAL's own checks, which a release switches off, and makes
# every warning an error; asan looks for errors of memory and undefined behaviour; core does without ParaView.
# Usage: other-build.sh SOURCE_DIR WORK_DIR PRESET [CTEST_ARGUMENTS ...]
set -euo pipefail
source_dir="$1" work_dir="$2/$3" preset="$3"
shift 3
launcher=()
command -v ccache >/dev/null && launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S "$source_dir" --preset "$preset" -B "$work_dir" "${launcher[@]}"
ninja -C "$work_dir"
ctest --test-dir "$work_dir" --output-on-failure -j "$(nproc)" -LE slow "$@"
