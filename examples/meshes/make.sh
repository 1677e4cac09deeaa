#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Makes the example meshes again: the shapes beside this file, each with the nanocarbon program.
#
#   examples/meshes/make.sh [FOLDER]    writes to FOLDER (default: beside this file)
#
# Environment: NANOCARBON, the program (default: nanocarbon, as found in PATH).
set -euo pipefail
folder=${1:-$(dirname "$0")}
make() {  # make NAME SHAPE OPTIONS...
  local name=$1
  shift
  "${NANOCARBON:-nanocarbon}" make mesh "$@" -o "$folder/$name.off"
}

make sphere sphere --radius 1 --subdivisions 10
make torus torus --major 2 --minor 0.8 --edge 0.22
make capsule capsule --radius 1 --length 4 --edge 0.18
make genus-two genus-two --major 2 --minor 0.8 --edge 0.3
make y-junction junction --kind y --tube-radius 1 --arm-length 4 --edge 0.3
make t-junction junction --kind t --tube-radius 1 --arm-length 4 --edge 0.3 --closed
make x-junction junction --kind x --tube-radius 1 --arm-length 4 --edge 0.3
make helix helix --coil-radius 3 --tube-radius 0.8 --pitch 3 --turns 2 --edge 0.3
make hemisphere hemisphere --radius 1 --edge 0.12
make gyroid-piece gyroid-piece --period 1 --cells 1 --edge 0.05
make gyroid-shell gyroid-piece --period 1 --cells 1 --thickness 0.15 --edge 0.05
