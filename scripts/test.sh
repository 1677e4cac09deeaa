#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Installs what is missing, builds, and runs every test. Options are passed on to ctest (-R NAME, -LE slow, ...).
# Environment: NANOCARBON_MODELS (a folder of meshes to test with), NANOCARBON_CMAKE_OPTIONS (passed on to CMake).
set -euo pipefail
cd "$(dirname "$0")/.."
. scripts/packages.sh

install_missing "${build_packages[@]}" "${lammps_packages[@]}" "${test_packages[@]}"
# What decides which tests there are is said here, for the cache may remember another choice: that of scripts/demo.sh, or
# of a build of the plugin alone.
cmake --preset release -DBUILD_TESTING=ON -DNANOCARBON_PREPROCESSOR=ON -DNANOCARBON_PLUGIN=ON -DLAMMPS_SOURCE_DIR= \
  ${NANOCARBON_CMAKE_OPTIONS:-}
cmake --build --preset release
# A LAMMPS with the PLUGIN package, for the tests of its own plugin load; takes minutes, but only the first time.
if [ -z "${NANOCARBON_PLUGIN_LAMMPS:-}" ]; then
  NANOCARBON_PLUGIN_LAMMPS=$(scripts/build-lammps-with-plugin.sh | tail -n 1)
  export NANOCARBON_PLUGIN_LAMMPS
fi
ctest --preset release --no-tests=error -j "$(nproc)" "$@"
