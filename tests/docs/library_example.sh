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
# Components: a room without a mesh library is found where there is none, one with it is not, and one that is not there
# is named.
find() {  # find COMPONENT OPTIONS...
  mkdir -p "$work/find"
  printf '%s\n' 'cmake_minimum_required(VERSION 3.22)' 'project(user LANGUAGES CXX)' \
    "find_package(nanocarbon REQUIRED COMPONENTS $1)" >"$work/find/CMakeLists.txt"
  cmake --fresh -G Ninja -S "$work/find" -B "$work/find/build" -DCMAKE_PREFIX_PATH="$work/installed" "${@:2}" >"$work/found" 2>&1
}
find "core topology" -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON
if find building -DCMAKE_DISABLE_FIND_PACKAGE_OpenMesh=ON; then exit 1; fi
grep -q OpenMesh "$work/found"
if find "core cellar"; then exit 1; fi
grep -q 'no component cellar' "$work/found"
if "$work/build/from_mesh_to_molecule" "$work/missing.off" 300 "$work/x.data" 2>"$work/message"; then exit 1; fi
grep -q missing.off "$work/message"
