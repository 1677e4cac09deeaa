#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# How well energy is conserved in hot amorphous carbon, by rebo and by rebo/opt: drift.sh BUILD_FOLDER [PS [FS...]]
#
# 5,000 atoms at 2.5 g/cm^3, molten at 8,000 K and cooled to 3,000 K within 5 ps, then PS picoseconds (10) at constant energy
# with each time step (0.5 and 0.2 fs). Both styles begin from the same atoms and velocities. Prints the total energy
# against the start, eV, ten times, and the temperature at the end.
set -euo pipefail
build=$(cd "$1" && pwd)
ps=${2:-10}
shift; [ $# -eq 0 ] || shift
steps_fs=${*:-0.5 0.2}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
lammps() {
  "$build/lammps-plugin/lmp-nanocarbon" -log none -var plugin "$build/lammps-plugin/nanocarbonplugin.so" "$@" >"$work/log" ||
    { tail "$work/log"; exit 1; }
}

lammps -in "$here/amorphous_carbon.in" -var temperature 3000 -var quench_steps 25000 -var out "$work/amorphous.data"
for fs in $steps_fs; do
  for style in rebo rebo/opt; do
    lammps -in "$here/drift.in" -var data "$work/amorphous.data" -var style "$style" \
      -var step "$(awk -v fs="$fs" 'BEGIN { print fs / 1000 }')" -var steps "$(awk -v fs="$fs" -v ps="$ps" 'BEGIN { printf "%.0f", ps * 1000 / fs }')"
    awk -v name="$style, $fs fs" '
      /Step +Time/ { reading = 1; next }
      /^Loop time/ { reading = 0 }
      reading { if (!started) { first = $3; begin = $4; started = 1 } else { line = line sprintf(" %+.3f", $3 - first) } end = $4 }
      END { printf "%-16s %s eV, %.0f to %.0f K\n", name, line, begin, end }' "$work/log"
  done
done
