#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# How well energy is conserved in hot amorphous carbon, by rebo and by rebo/opt: drift.sh BUILD_FOLDER [PS [FS...]]
#
# 2.5 g/cm^3, molten at 8,000 K and cooled to 3,000 K within 5 ps, then PS picoseconds (10) at constant energy with each
# time step (0.5 and 0.2 fs). Both styles begin from the same atoms and velocities. Prints the total energy against the
# start, eV, ten times, and the temperature at the end; then, of several samples, means of the last and their scatter.
#   CELLS="20 25 10"   how many atoms along each axis: 5,000
#   SAMPLES=1          how many melts, each with other random numbers
set -euo pipefail
build=$(cd "$1" && pwd)
ps=${2:-10}
shift; [ $# -eq 0 ] || shift
steps_fs=${*:-0.5 0.2}
read -r nx ny nz <<<"${CELLS:-20 25 10}"
samples=${SAMPLES:-1}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
lammps() {
  "$build/lammps-plugin/lmp-nanocarbon" -log none -var plugin "$build/lammps-plugin/nanocarbonplugin.so" "$@" >"$work/log" ||
    { tail "$work/log"; exit 1; }
}

for ((sample = 1; sample <= samples; ++sample)); do
  lammps -in "$here/amorphous_carbon.in" -var temperature 3000 -var quench_steps 25000 -var out "$work/amorphous.data" \
    -var nx "$nx" -var ny "$ny" -var nz "$nz" -var seed "$((4710 + sample))"
  for fs in $steps_fs; do
    for style in rebo rebo/opt; do
      lammps -in "$here/drift.in" -var data "$work/amorphous.data" -var style "$style" \
        -var step "$(awk -v fs="$fs" 'BEGIN { print fs / 1000 }')" \
        -var steps "$(awk -v fs="$fs" -v ps="$ps" 'BEGIN { printf "%.0f", ps * 1000 / fs }')"
      awk -v name="$style, $fs fs" -v file="$work/${style/\//_}.$fs" '
        /Step +Time/ { reading = 1; next }
        /^Loop time/ { reading = 0 }
        reading { if (!started) { first = $3; begin = $4; started = 1 } else { line = line sprintf(" %+.3f", $3 - first) } end = $4; last = $3 }
        END { printf "%-16s %s eV, %.0f to %.0f K\n", name, line, begin, end; print last - first >>file }' "$work/log"
    done
  done
done
echo "energy gained in $ps ps by $((nx * ny * nz)) atoms, eV: mean, standard deviation of $samples"
for fs in $steps_fs; do
  for style in rebo rebo/opt; do
    awk -v name="$style, $fs fs" '
      { sum += $1; squares += $1 * $1 }
      END { mean = sum / NR; printf "%-16s %+.3f %.3f\n", name, mean, NR > 1 ? sqrt((squares - NR * mean * mean) / (NR - 1)) : 0 }' \
      "$work/${style/\//_}.$fs"
  done
done
