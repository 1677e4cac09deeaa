#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs the project to a folder of its own, and builds and runs examples/library with nothing but that.
#
#   library_example.sh BUILD_FOLDER SOURCE_FOLDER WORK_FOLDER
set -euo pipefail
build=$1 source=$2 work=$3
rm -rf "$work"
cmake --install "$build" --prefix "$work/installed" >"$work.install.log"
cmake -G Ninja -S "$work/installed/share/nanocarbon/examples/library" -B "$work/build" -DCMAKE_BUILD_TYPE=Release \
  -DCMAKE_PREFIX_PATH="$work/installed"
cmake --build "$work/build"
"$work/build/from_mesh_to_molecule" "$source/examples/meshes/sphere.off" 300 "$work/sphere.data" | tee "$work/said"
# A closed surface of three-coordinated atoms has 3/2 bonds for each atom, and Euler's number of rings.
read -r atoms _ bonds _ rings _ < <(tr -d , <"$work/said")
[ $((2 * bonds)) -eq $((3 * atoms)) ]
[ $((atoms - bonds + rings)) -eq 2 ]
grep -q "^$atoms atoms" "$work/sphere.data"
# The installed program is whole as well.
"$work/installed/bin/nanocarbon" make fullerene 1 1 --quiet -o "$work/c60.data"
grep -q "^60 atoms" "$work/c60.data"
if "$work/build/from_mesh_to_molecule" "$work/missing.off" 300 "$work/x.data" 2>"$work/message"; then exit 1; fi
grep -q missing.off "$work/message"
