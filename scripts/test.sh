#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs what is missing, builds, and runs every test. Options are passed on to ctest (-R NAME, -LE slow, ...).
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing "${build_packages[@]}" "${lammps_packages[@]}" "${test_packages[@]}"
preset=${NANOCARBON_PRESET:-release}
cmake --preset "$preset"
cmake --build --preset "$preset"
# A LAMMPS with the PLUGIN package, for the tests of its own plugin load; takes minutes, but only the first time.
if [ -z "${NANOCARBON_PLUGIN_LAMMPS:-}" ]; then
  NANOCARBON_PLUGIN_LAMMPS=$(scripts/build-lammps-with-plugin.sh | tail -n 1)
  export NANOCARBON_PLUGIN_LAMMPS
fi
ctest --preset "$preset" -j "$(nproc)" "$@"
