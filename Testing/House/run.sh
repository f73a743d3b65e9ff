#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# `run`, from outside: a second run does no work twice, failures are one sentence, output goes where it should.
# Usage: run.sh SOURCE_DIR BINARY_DIR
set -uo pipefail
run="$1/run"
export CONTOUR_BUILD_DIR="$2"
status=0
fail() { echo "FAILED: $*"; status=1; }

plugin="$("$run" plugin)" || fail "run plugin fails"
[[ "$plugin" == "$CONTOUR_BUILD_DIR"/*.so && -f "$plugin" ]] || fail "run plugin prints '$plugin'"

before="$(stat -c %Y "$plugin")"
log_lines="$(wc -l <"$CONTOUR_BUILD_DIR/.ninja_log")"
"$run" build || fail "a second build fails"
[[ "$(stat -c %Y "$plugin")" == "$before" ]] || fail "a second build links the plugin again"
[[ "$(wc -l <"$CONTOUR_BUILD_DIR/.ninja_log")" == "$log_lines" ]] || fail "a second build compiles something"

# `cmake --install` after no more than `run build` finds all that it copies; the Python package is installed only when
# asked for.
installed="$(find "$CONTOUR_BUILD_DIR" -name cmake_install.cmake -not -path "*/Plugin/python/*" -exec grep -h "file(INSTALL" {} + |
  grep -o "\"$CONTOUR_BUILD_DIR/[^\"]*\"" | tr -d '"' | sed "s|^$CONTOUR_BUILD_DIR/||" | sort -u)"
made="$(ninja -C "$CONTOUR_BUILD_DIR" -t targets all | sed 's/: [^:]*$//' | sort -u)"
# The inputs of its inputs, and these themselves.
by_plugin="$(
  {
    ninja -C "$CONTOUR_BUILD_DIR" -t inputs plugin
    ninja -C "$CONTOUR_BUILD_DIR" -t query plugin | sed 's/^ *//'
    ninja -C "$CONTOUR_BUILD_DIR" -t query plugin | sed 's/^ *//' | grep '^Plugin/[A-Za-z]*$' |
      xargs -rn1 ninja -C "$CONTOUR_BUILD_DIR" -t query | sed 's/^ *//'
  } | sort -u
)"
grep -q '\.so$' <<<"$installed" || fail "no library is found among what is installed: $installed"
missing="$(comm -23 <(comm -12 <(echo "$installed") <(echo "$made")) <(echo "$by_plugin"))"
[[ -z "$missing" ]] || fail "run build does not make what is installed: $missing"

words="$("$run" nonsense 2>&1 >/dev/null)" && fail "an unknown command succeeds"
grep -q "no command nonsense" <<<"$words" || fail "an unknown command is not named: $words"
"$run" help | grep -q "reconstruct IN OUT" || fail "help does not show reconstruct"
"$run" test --nonsense >/dev/null 2>&1 && fail "an unknown option of test is taken"

# A user who may not install is told in one sentence what is missing, and nothing is tried.
fake="$(mktemp -d)"
trap 'rm -rf "$fake"' EXIT
printf '#!/bin/sh\nexit 1\n' >"$fake/dpkg-query"
printf '#!/bin/sh\necho 1000\n' >"$fake/id"
chmod +x "$fake"/*
for tool in bash dirname grep sed cat printf tail mktemp nproc awk rm; do
  [[ -e "$fake/$tool" ]] || ln -s "$(command -v "$tool")" "$fake/$tool"
done
words="$(PATH="$fake" "$fake/bash" "$run" setup 2>&1)" && fail "setup succeeds without packages and rights"
[[ "$(wc -l <<<"$words")" == 1 && "$words" == *"are missing"*paraview* ]] || fail "setup says: $words"
((status == 0)) && echo "run: all checks passed"
exit "$status"
