#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Compares pair_style rebo/opt with rebo where atoms are not three-coordinated: rebo_opt_general.sh BUILD_FOLDER [ROUNDS [CASE...]]
#
# As rebo_opt.sh: runs rebo_opt.in for both styles in turn and prints medians of CPU time, microseconds an atom and step.
# Cases: diamond (8,000 atoms), pressed (the same at a lattice constant of 3.45 Angstrom, about 100 GPa), polyethylene (10,080)
# and benzene crystal (10,368), each at 300 K, and amorphous carbon (5,000 atoms at 2.5 g/cm^3, molten at 8,000 K) at 5,000 K.
set -euo pipefail
build=$(cd "$1" && pwd)
rounds=${2:-3}
shift; [ $# -eq 0 ] || shift
cases=${*:-diamond pressed polyethylene benzene amorphous}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
lammps=$build/lammps-plugin/lmp-nanocarbon
. "$here/rebo_opt_compare.sh"

python3 "$here/general_structures.py" "$work"
file() { echo "-var from file -var data $work/$1.data"; }

echo "microseconds of CPU time an atom and step, medians of $rounds"
for name in $cases; do
  temperature=300
  if [ "$name" = amorphous ]; then
    temperature=2500  # rebo_opt.in draws velocities of twice that, and these atoms are hot already
    "$lammps" -log none -in "$here/amorphous_carbon.in" -var plugin "$build/lammps-plugin/nanocarbonplugin.so" \
      -var out "$work/amorphous.data" >"$work/amorphous.log" || { tail "$work/amorphous.log"; exit 1; }
  fi
  # shellcheck disable=SC2046
  compare "$name" 40 200 $(file "$name") -var boundary "p p p" -var temperature $temperature
done
