# SPDX-License-Identifier: GPL-2.0-or-later
# Sourced by the other scripts: install_missing PACKAGE... installs by apt what is not there yet, through sudo
# when not root, and does nothing when nothing is missing.

install_missing() {
  local missing=() package
  for package in "$@"; do
    dpkg-query -W -f='${Status}' "$package" 2>/dev/null | grep -q 'ok installed' || missing+=("$package")
  done
  [ ${#missing[@]} -eq 0 ] && return
  local as_root=()
  if [ "$(id -u)" -ne 0 ]; then as_root=(sudo); fi
  echo "Installing: ${missing[*]}"
  "${as_root[@]}" apt-get update -qq
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}"
}

build_packages=(g++ cmake ninja-build libopenmesh-dev libeigen3-dev libnanoflann-dev libcli11-dev libfmt-dev
  nlohmann-json3-dev libspectra-dev liblbfgspp-dev libxsimd-dev libmuparser-dev
  zlib1g-dev libpugixml-dev gemmi-dev tao-pegtl-dev libjs-three libcgal-dev)
lammps_packages=(lammps liblammps-dev lammps-data libopenmpi-dev openmpi-bin)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev python3-ase valgrind doxygen groff-base dpkg-dev file)
test_packages+=(pybind11-dev python3-dev python3-markdown-it python3-docutils)
