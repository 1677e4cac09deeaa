#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Compiles the plugin against a LAMMPS source folder that has a header of each name that the plugin includes from
# elsewhere: the standard library, other libraries, the project's own. Each of them is an error when it is read. Recent
# LAMMPS have such a header indeed, nlohmann/json.hpp; nothing in that folder may get in the way of what is ours.
#
#   header_traps.sh SOURCE_FOLDER LAMMPS_INCLUDE_FOLDER LAMMPS_DATE WORK_FOLDER
set -euo pipefail
source=$1 include=$2 date=$3 work=$4
rm -rf "$work"
mkdir -p "$work/lammps"
ln -s "$include"/*.h "$work/lammps/"
for folder in fmt nlohmann; do  # LAMMPS's own, which its headers read
  if [ -d "$include/$folder" ]; then
    mkdir "$work/lammps/$folder"
    ln -s "$include/$folder"/* "$work/lammps/$folder/"
  fi
done
rm -f "$work/lammps/version.h"
echo "#define LAMMPS_VERSION \"$date\"" >"$work/lammps/version.h"

traps=0
while read -r name; do
  # What LAMMPS has, and what it may lack and we stand in for, is LAMMPS's.
  if [ -e "$work/lammps/$name" ] || [ -e "$source/lammps-plugin/compat/stand-in/$name" ]; then continue; fi
  mkdir -p "$(dirname "$work/lammps/$name")"
  echo "#error LAMMPS's $name was read instead of ours" >"$work/lammps/$name"
  traps=$((traps + 1))
done < <(find "$source/lammps-plugin" "$source/preprocessor/nanocarbon" -name '*.h' -o -name '*.cpp' |
  xargs sed -nE 's/^#include [<"]([^>"]+)[>"].*/\1/p' | sort -u)
for expected in nlohmann/json.hpp vector nanocarbon/core/error.h plugin/styles.h; do
  [ -s "$work/lammps/$expected" ] || { echo "no trap $expected"; exit 1; }
done

cmake -G Ninja -S "$source" -B "$work/build" -DNANOCARBON_PREPROCESSOR=OFF -DLAMMPS_SOURCE_DIR="$work/lammps" \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG=-O0 -DCMAKE_OPTIMIZE_DEPENDENCIES=ON
cmake --build "$work/build" --target nanocarbon_styles lammps-plugin/CMakeFiles/nanocarbonplugin.dir/plugin/plugin_init.cpp.o
echo "compiled beside $traps traps"
