#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Builds a LAMMPS with its PLUGIN package, which Debian leaves out, and prints the path of its lmp program on the last line.
# Built once, kept in ~/.cache/nanocarbon (or XDG_CACHE_HOME); src/ beside it is for LAMMPS_SOURCE_DIR.
#
#   scripts/build-lammps-with-plugin.sh             the LAMMPS of this system's own source package
#   scripts/build-lammps-with-plugin.sh FOLDER      the LAMMPS whose source is unpacked in FOLDER
set -euo pipefail
folder=
if [ $# -gt 0 ]; then
  folder=$(cd "$1" && pwd)
  if [ ! -r "$folder/src/version.h" ]; then
    echo "build-lammps-with-plugin: $1 has no src/version.h: name the folder that a LAMMPS was unpacked to" >&2
    exit 3
  fi
fi
cd "$(dirname "$0")/.."
. scripts/packages.sh
install_missing "${lammps_packages[@]}" g++ cmake ninja-build xz-utils >&2

# "URI suite/component" of the archive that the installed LAMMPS headers came from.
archive_of() { apt-cache policy "$1" | awk '$2 ~ /^[a-z+]+:\/\// || $2 ~ /^file:/ { print $2, $3; exit }'; }
if [ -n "$folder" ]; then
  version=$(sed -nE 's/.*LAMMPS_VERSION "(.*)".*/\1/p' "$folder/src/version.h" | tr -d ' ')
else
  if [ -z "$(archive_of liblammps-dev)" ]; then
    if [ "$(id -u)" -eq 0 ]; then apt-get update -qq >&2; else sudo apt-get update -qq >&2; fi
  fi
  read -r archive suite_component <<<"$(archive_of liblammps-dev)"
  version=$(dpkg-query -W -f='${source:Version}' liblammps-dev)
fi

cache=${XDG_CACHE_HOME:-$HOME/.cache}/nanocarbon
home=$cache/lammps-${version//[^A-Za-z0-9.+]/_}-plugin
if [ -x "$home/bin/lmp" ]; then echo "$home/bin/lmp"; exit; fi
mkdir -p "$cache"
work=$(mktemp -d "$cache/build.XXXXXX")
trap 'rm -rf "$work"' EXIT

if [ -z "$folder" ]; then
  # The source archive, by an apt configuration of our own: nothing of the system's is changed.
  mkdir -p "$work/apt/lists/partial" "$work/source"
  keyring=/usr/share/keyrings/debian-archive-keyring.gpg
  signed=$([ -e "$keyring" ] && echo "[signed-by=$keyring] " || true)
  echo "deb-src $signed$archive ${suite_component%%/*} ${suite_component#*/}" >"$work/apt/sources.list"
  apt=(apt-get -qq -o Dir::Etc::SourceList="$work/apt/sources.list" -o Dir::Etc::SourceParts=/dev/null
    -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt" -o APT::Sandbox::User=root)
  "${apt[@]}" update >&2
  (cd "$work" && "${apt[@]}" source --download-only --tar-only "lammps=$version" >&2)
  tar -xf "$work"/lammps_*.orig.tar.* -C "$work/source"
  # Some archives have a folder around it all.
  folder=$(dirname "$(dirname "$(find "$work/source" -maxdepth 3 -path "*/src/version.h" -print -quit)")")
fi

cmake -S "$folder/cmake" -B "$work/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX="$work/home" \
  -DBUILD_SHARED_LIBS=ON -DBUILD_MPI=ON -DBUILD_OMP=OFF -DLAMMPS_EXCEPTIONS=ON -DCMAKE_INSTALL_RPATH='$ORIGIN/../lib' \
  -DCMAKE_INSTALL_LIBDIR=lib -DCMAKE_BUILD_WITH_INSTALL_RPATH=ON -DPKG_PLUGIN=ON -DPKG_MANYBODY=ON -DPKG_MOLECULE=ON -DWITH_JPEG=OFF -DWITH_PNG=OFF \
  -DWITH_GZIP=OFF -DWITH_FFMPEG=OFF >&2
cmake --build "$work/build" --target lmp -j "$(nproc)" >&2
mkdir -p "$work/home/bin" "$work/home/lib"
cp -a "$work"/build/liblammps*.so* "$work/home/lib/"
cp "$work/build/lmp" "$work/home/bin/lmp"
cp -r "$folder/src" "$work/home/src"
cp "$folder/potentials/CH.rebo" "$work/home/"
rm -rf "$home"
mv "$work/home" "$home"
echo "$home/bin/lmp"
