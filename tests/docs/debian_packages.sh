#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Makes Debian's packages, unpacks them elsewhere and uses what is in them.
#
#   debian_packages.sh BUILD_FOLDER WORK_FOLDER
set -euo pipefail
build=$1 work=$2
rm -rf "$work"
mkdir -p "$work/unpacked" "$work/dev"
(cd "$build" && cpack -B "$work/packages") >"$work/said" 2>&1 || { cat "$work/said"; exit 1; }
program=("$work"/packages/nanocarbon_*.deb) library=("$work"/packages/libnanocarbon-dev_*.deb)
dpkg-deb -x "${program[0]}" "$work/unpacked"
dpkg-deb -x "${library[0]}" "$work/dev"
dpkg-deb -f "${program[0]}" Package Version Depends

# What the program and LAMMPS's host are linked with.
for library_package in libc6 libopenmesh liblammps; do
  dpkg-deb -f "${program[0]}" Depends | grep -q "$library_package"
done
for file in bin/nanocarbon bin/lmp-nanocarbon lib/lammps/plugins/nanocarbonplugin.so share/man/man1/nanocarbon.1.gz \
  share/man/man1/nanocarbon-build.1.gz share/man/man1/lmp-nanocarbon.1.gz share/bash-completion/completions/nanocarbon \
  share/nanocarbon/examples/validate.in share/doc/nanocarbon/copyright; do
  [ -s "$work/unpacked/usr/$file" ] || { echo "the package lacks $file"; exit 1; }
done
[ ! -e "$work/unpacked/usr/include" ] && [ ! -e "$work/dev/usr/bin" ]

cd "$work"
"$work/unpacked/usr/bin/nanocarbon" make fullerene 1 1 --quiet -o c60.data
printf 'plugin load nanocarbonplugin.so\nplugin list\n' >load.in
"$work/unpacked/usr/bin/lmp-nanocarbon" -in load.in -log none | grep -q 'fix style plugin bond/topology'

mkdir user
printf '%s\n' 'cmake_minimum_required(VERSION 3.22)' 'project(user LANGUAGES CXX)' \
  'find_package(nanocarbon REQUIRED COMPONENTS core)' >user/CMakeLists.txt
cmake -G Ninja -S user -B user/build -DCMAKE_PREFIX_PATH="$work/dev/usr" >user/said || { cat user/said; exit 1; }
