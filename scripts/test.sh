#!/usr/bin/env bash
# Installs what is missing, builds, and runs every test. Options are passed on to ctest (-R NAME, -LE slow, ...).
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing "${build_packages[@]}" "${lammps_packages[@]}" "${test_packages[@]}"
preset=${NANOCARBON_PRESET:-release}
cmake --preset "$preset"
cmake --build --preset "$preset"
ctest --preset "$preset" -j "$(nproc)" "$@"
