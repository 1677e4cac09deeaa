#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Fuzzes the readers of files under the address and undefined-behaviour sanitizers: tests/fuzz/run.sh RUNS [FUZZER...]
#
# Builds the fuzzers in build/fuzz (by clang, which is installed where it is missing), gives each small files of its
# format to begin with, runs one after the other and prints what they did. Ends with 1 if one found something: the
# input is then in build/fuzz/findings/FUZZER, and build/fuzz/tests/fuzz/fuzz_FUZZER FILE shows it again.
# What they learn stays in build/fuzz/corpus, for the next run.
#   SEEDS="FOLDER..."  other files to begin with: those that end in .FORMAT, or all for a fuzzer of no format
#   SECONDS_EACH=N     stops a fuzzer after N seconds, if it has not had its runs
set -euo pipefail
[[ ${1:-} =~ ^[0-9]+$ ]] || { sed -n '3,11s/^# \?//p' "$0"; exit 2; }
runs=$1
shift
all="mesh_off mesh_obj mesh_ply mesh_stl mesh_glb mesh_gltf mesh_3mf mesh_vtk mesh_vtp mesh_vtu mesh_vti mesh_msh mesh_cube mesh_mrc
  molecule_data molecule_dump molecule_yaml molecule_xyz molecule_cif molecule_poscar molecule_packed
  types potential_rebo potential_airebo potential_airebo_m"
fuzzers=${*:-$all}
cd "$(dirname "$0")/../.."
. scripts/packages.sh
install_missing "${build_packages[@]}" libgtest-dev libgmock-dev clang libomp-dev
potentials=${LAMMPS_POTENTIALS:-/usr/share/lammps/potentials}

cmake --preset fuzz >build/fuzz.log || { cat build/fuzz.log; exit 1; }
cmake --build --preset fuzz
seeds=build/fuzz/seeds
rm -rf $seeds
build/fuzz/tests/fuzz/write_seeds $seeds
gzip -1 $seeds/molecule_packed/*
cp tests/molecule/formats/files/*.{data,data2,lmp,lmpdat} tests/molecule/formats/files/data.* $seeds/molecule_data
cp tests/molecule/formats/files/*.{xyz,extxyz} $seeds/molecule_xyz
cp tests/molecule/formats/files/*.dump $seeds/molecule_dump
mkdir $seeds/types $seeds/potential_{rebo,airebo,airebo_m}
printf 'C\nH' >$seeds/types/order
printf '1=C,2=H\nCA=C hc=hydrogen\nAu=79' >$seeds/types/names
# The tables that follow are passed over.
head -n 200 "$potentials/CH.rebo" >$seeds/potential_rebo/CH.rebo
head -n 200 "$potentials/CH.airebo" >$seeds/potential_airebo/CH.airebo
head -n 200 "$potentials/CH.airebo-m" >$seeds/potential_airebo_m/CH.airebo-m
for fuzzer in $all; do
  for folder in ${SEEDS:-}; do
    find "$folder" -maxdepth 1 -type f -size -20k -name "*${fuzzer##*_}" -exec cp {} "$seeds/$fuzzer" \;
  done
done

printf '%-20s %10s %8s %9s %8s  %s\n' fuzzer runs seconds branches inputs result
status=0
for fuzzer in $fuzzers; do
  corpus=build/fuzz/corpus/$fuzzer findings=build/fuzz/findings/$fuzzer log=build/fuzz/$fuzzer.log
  mkdir -p "$corpus" "$findings"
  # Files of a few kilobytes are as odd as large ones, and read in a moment.
  max_len=12000
  # In binary that is a field of 15^3 values, to whose surface nearly all the time would go: of 44 here.
  [[ $fuzzer != mesh_mrc ]] || max_len=1200
  result=clean
  UBSAN_OPTIONS=print_stacktrace=1 "build/fuzz/tests/fuzz/fuzz_$fuzzer" -runs="$runs" -timeout=10 -rss_limit_mb=2048 \
    -max_len=$max_len -max_total_time="${SECONDS_EACH:-0}" -print_final_stats=1 -artifact_prefix="$findings/" \
    "$corpus" "$seeds/$fuzzer" >"$log" 2>&1 || { result="see $log"; status=1; }
  done_runs=$(sed -n 's/^stat::number_of_executed_units: *//p' "$log")
  seconds=$(sed -n 's/^Done .* in \([0-9]*\) second.*/\1/p' "$log")
  branches=$(sed -n 's/.*cov: \([0-9]*\) .*/\1/p' "$log" | tail -n 1)
  printf '%-20s %10s %8s %9s %8s  %s\n' "$fuzzer" "${done_runs:-?}" "${seconds:-?}" "${branches:-?}" \
    "$(ls "$corpus" | wc -l)" "$result"
done
exit $status
