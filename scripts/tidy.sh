#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Runs clang-tidy, with the settings of .clang-tidy, and shows what it finds in the lines that changed.
#
#   scripts/tidy.sh [BASE]     what is different from the commit BASE, edits not yet committed included
#
# Without BASE: since this branch left origin/main, or on main itself, what the last day of work has changed. Needs the
# build that scripts/test.sh leaves. Environment: TIDY_MINUTES, after which no further source is begun (60); it is said
# how many are left out then, those with the fewest changes.
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/packages.sh

build=build/release
if [ ! -f $build/compile_commands.json ]; then
  echo "tidy: there is no $build/compile_commands.json: run scripts/test.sh first" >&2
  exit 2
fi
install_missing clang-tidy

base=${1:-}
if [ -z "$base" ]; then
  base=$(git merge-base HEAD origin/main 2>/dev/null || git rev-parse HEAD)
  if [ "$base" = "$(git rev-parse HEAD)" ]; then
    base=$(git rev-list -1 --before="$(($(git log -1 --format=%ct) - 86400))" HEAD)
    base=${base:-$(git rev-list --max-parents=0 HEAD | tail -n 1)}
  fi
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# Without the headers that gcc has precompiled, which mean nothing to clang.
sed -E 's/ -Winvalid-pch//; s/ -include [^ ]*cmake_pch\.hxx//' $build/compile_commands.json >"$work/compile_commands.json"
# The lines that are new, as clang-tidy wants them: [{"name": "a.cpp", "lines": [[1, 3], [7, 7]]}, ...].
git diff -M -U0 "$base" -- '*.cpp' '*.h' | awk '
  /^\+\+\+ b\// { file = substr($0, 7) }
  /^@@/ { split($3, at, ","); count = at[2] == "" ? 1 : at[2]
          if (count > 0) lines[file] = lines[file] (lines[file] == "" ? "" : ",") "[" at[1]+0 "," at[1]+count-1 "]" }
  END { for (file in lines) { printf "%s{\"name\":\"%s\",\"lines\":[%s]}", separator, file, lines[file]; separator = "," } }
' >"$work/lines"
# The sources with the most changes first; of a header that changed, the source of its name.
git diff -M --numstat "$base" -- '*.cpp' '*.h' | awk -F'\t' '{ print $1 "\t" $3 }' |
  sed -E 's/\{[^{}]* => ([^{}]*)\}/\1/; s/\t.* => /\t/; s,//,/,' | sort -rn | cut -f 2 | sed 's/\.h$/.cpp/' | awk '!seen[$0]++' |
  while read -r source; do
    if grep -qF "/$source\"" $build/compile_commands.json; then echo "$source"; fi
  done >"$work/sources"
echo "tidy: $(wc -l <"$work/sources") sources changed since $(git log -1 --format='%h (%cs)' "$base")"

export work deadline=$(($(date +%s) + 60 * ${TIDY_MINUTES:-60}))
check() {  # some flags of the build's compiler say nothing to clang
  if [ "$(date +%s)" -ge "$deadline" ]; then echo "$1" >>"$work/left"; return; fi
  clang-tidy --quiet -p "$work" --line-filter="[$(cat "$work/lines")]" --extra-arg=-Wno-unknown-warning-option "$1" 2>"$work/errors.$$" ||
    { cat "$work/errors.$$" >&2; return 1; }
}
export -f check
failed=0
xargs -r -P "$(nproc)" -I{} bash -c 'check {}' <"$work/sources" || failed=1
if [ -f "$work/left" ]; then echo "tidy: out of time, $(wc -l <"$work/left") sources were not looked at"; fi
exit $failed
