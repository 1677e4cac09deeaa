#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Compares pair_style rebo/opt with rebo: rebo_opt.sh BUILD_FOLDER [ROUNDS]
#
# Runs rebo_opt.in for both styles in turn and prints medians of CPU time, microseconds an atom and step: LAMMPS's own
# timings times the share of the processor that it had, so that other load on the machine matters little.
# Cases: 10,000 atoms of graphene at 300 K, a molecule of 10,140 (a fullerene), 200,000 atoms of graphene, and where
# there are two cores, the 200,000 on one rank and on two.
set -euo pipefail
build=$(cd "$1" && pwd)
rounds=${2:-3}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
lammps=$build/lammps-plugin/lmp-nanocarbon
"$build/preprocessor/cli/nanocarbon" make fullerene 13 13 --atom-style atomic -q -o "$work/molecule.data"

. "$here/rebo_opt_compare.sh"

echo "microseconds of CPU time an atom and step, medians of $rounds"
compare "graphene 10k, 300 K" 50 500
small=$last_step
compare "fullerene 10k, 300 K" 50 500 -var from file -var data "$work/molecule.data" -var boundary "f f f"
large=$(for ((round = 0; round < rounds; ++round)); do run 1 rebo/opt 25 -var nx 294 -var ny 170; done | cut -d' ' -f2 | median)
echo "rebo/opt, graphene 200k: step $large us, $(ratio "$large" "$small") times that of 10k"
if [ "$(nproc --all)" -ge 2 ]; then  # nproc alone would heed OMP_NUM_THREADS
  for ((round = 0; round < rounds; ++round)); do
    run 1 rebo/opt 50 -var nx 294 -var ny 170 | cut -d' ' -f2 >>"$work/one"
    run 2 rebo/opt 50 -var nx 294 -var ny 170 | cut -d' ' -f2 >>"$work/two"
  done
  # Wall time of two ranks against CPU time of one: means nothing on a machine that is busy otherwise.
  echo "rebo/opt, graphene 200k: two ranks are $(ratio "$(median <"$work/one")" "$(median <"$work/two")") times one (wall time)"
fi
