#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# From a mesh to a verdict: installs what is missing, builds, makes a molecule, runs it in LAMMPS with REBO2 or AIREBO.
#
#   scripts/demo.sh [MESH] [BUILD OPTIONS...]     e.g. scripts/demo.sh bunny.off --atoms 5000
#
# Writes to out/NAME/. What is already there and newer than what it was made from is not made again.
# Environment: STEPS (5000), TEMPERATURE (0: from rest), RANKS (1), PAIR (rebo; or airebo, airebo/morse, or /opt of each: the
# molecule is built with that potential), NANOCARBON_CMAKE_OPTIONS (passed on to CMake).
set -euo pipefail
started_in=$PWD
cd "$(dirname "$0")/.."
. scripts/packages.sh

case "${1:-}" in -h | --help) sed -n 's/^# \{0,1\}//p' scripts/demo.sh | sed 1,2d; exit ;; esac
mesh=examples/meshes/torus.off
if [ $# -gt 0 ]; then
  mesh=$1
  shift
  case "$mesh" in /*) ;; *) mesh=$started_in/$mesh ;; esac
  if [ ! -r "$mesh" ]; then
    echo "demo: $mesh: no such file, or not readable" >&2
    exit 3
  fi
fi
steps=${STEPS:-5000} temperature=${TEMPERATURE:-0} ranks=${RANKS:-1} pair=${PAIR:-rebo}
case $pair in
  rebo | rebo/opt) potential=() ;;
  airebo | airebo/opt) potential=(--potential airebo) ;;
  airebo/morse | airebo/morse/opt) potential=(--potential airebo-m) ;;
  *) echo "demo: PAIR is $pair, but must be rebo, airebo, airebo/morse, or one of these with /opt" >&2; exit 2 ;;
esac

install_missing "${build_packages[@]}" "${lammps_packages[@]}"
# Without the tests, which need more packages; scripts/test.sh turns them on again.
[ -f build/release/build.ninja ] || cmake --preset release -DBUILD_TESTING=OFF ${NANOCARBON_CMAKE_OPTIONS:-}
cmake --build --preset release --target nanocarbon lmp-nanocarbon nanocarbonplugin
program=build/release/preprocessor/cli/nanocarbon
lammps=build/release/lammps-plugin/lmp-nanocarbon
plugin=build/release/lammps-plugin/nanocarbonplugin.so

# LAMMPS scripts cannot name files with spaces in them.
name=$(basename "${mesh%.*}" | LC_ALL=C tr -c 'A-Za-z0-9._\n-' '_')
folder=out/$name
mkdir -p "$folder"
data=$folder/$name.data

# The command is part of what a result was made from.
remember() {  # remember FILE TEXT: FILE changes only when TEXT does
  if [ "$(cat "$1" 2>/dev/null)" != "$2" ]; then printf '%s' "$2" >"$1"; fi
}
newer() {  # newer RESULT SOURCE...: RESULT exists and is newer than every SOURCE
  local result=$1 source
  shift
  [ -e "$result" ] || return 1
  for source in "$@"; do [ "$result" -nt "$source" ] || return 1; done
}

remember "$folder/build.command" "$mesh ${potential[*]-} $*"
if newer "$data" "$mesh" "$program" "$folder/build.command"; then
  echo "The molecule $data is up to date."
else
  "$program" build "$mesh" -o "$data" --xyz "$folder/$name.xyz" --mesh "$folder/$name-mesh.ply" \
    --report "$folder/$name-report.json" --page "$folder/$name.html" ${potential[@]+"${potential[@]}"} "$@"
fi

log=$folder/$name.log
remember "$folder/run.command" "$steps $temperature $ranks $pair"
if newer "$log" "$data" "$lammps" "$plugin" examples/validate.in "$folder/run.command"; then
  echo "The run $log is up to date."
else
  echo "Running $steps steps of 1 fs in LAMMPS with pair_style $pair ..."
  launch=()
  if [ "$ranks" -gt 1 ]; then launch=(mpirun -np "$ranks"); fi
  if ! ${launch[@]+"${launch[@]}"} "$lammps" -in examples/validate.in -var data "$data" -var steps "$steps" \
    -var temperature "$temperature" -var pair "$pair" -var plugin "$plugin" -var out "$folder/$name" -log "$log.part" \
    >"$folder/$name.screen" 2>&1; then
    tail -n 20 "$folder/$name.screen" >&2
    echo "demo: LAMMPS failed; its output is in $folder/$name.screen" >&2
    exit 8
  fi
  mv "$log.part" "$log"
fi

echo
grep '^verdict:' "$log"
echo
printf '  %-12s %s\n' data "$data" log "$log" trajectory "$folder/$name.lammpstrj" \
  "before" "$folder/$name-before.png" after "$folder/$name-after.png" report "$folder/$name-report.json" \
  "look at it" "$folder/$name.html"
grep -q '^verdict: intact' "$log"
