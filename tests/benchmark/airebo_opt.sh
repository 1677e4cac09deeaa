#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Compares pair_style airebo/opt with airebo: airebo_opt.sh BUILD_FOLDER POTENTIALS_FOLDER [ROUNDS]
#
# Runs airebo_opt.in for both styles in turn and prints medians of CPU time, microseconds an atom and step: LAMMPS's own
# timings times the share of the processor that it had, so that other load on the machine matters little. Pair time
# is that of the pair style; a step has the making of lists in it as well.
# Cases: a sheet molecule of 10,140 atoms (a fullerene) and graphite of 10,080 at 300 K, also by Morse, hydrocarbon soup of
# 4,000 at 2500 K, and airebo/opt alone: graphite of 201,600 atoms, on one rank and, where there are two cores, on two.
set -euo pipefail
build=$(cd "$1" && pwd)
potentials=$(cd "$2" && pwd)
rounds=${3:-3}
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export OMP_NUM_THREADS=1 OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
lammps=$build/lammps-plugin/lmp-nanocarbon
"$build/preprocessor/cli/nanocarbon" make fullerene 13 13 --atom-style atomic -q -o "$work/molecule.data"
# The soup of the tests' reference values.
python3 - "$here/../potential/airebo/reference.json" "$work/soup.data" <<'PYTHON'
import json, sys
soup = next(s for s in json.load(open(sys.argv[1])) if s["name"] == "soup")
with open(sys.argv[2], "w") as out:
    out.write(f"soup\n\n{len(soup['elements'])} atoms\n2 atom types\n\n")
    for (low, high), axis in zip(soup["box"], "xyz"):
        out.write(f"{low!r} {high!r} {axis}lo {axis}hi\n")
    out.write("\nMasses\n\n1 12.011\n2 1.008\n\nAtoms # atomic\n\n")
    for i, element in enumerate(soup["elements"]):
        out.write(f"{i + 1} {'CH'.index(element) + 1} " + " ".join(map(repr, soup["positions"][3 * i : 3 * i + 3])) + "\n")
PYTHON

# run RANKS STYLE STEPS VARIABLES...: prints "pair step" in CPU microseconds an atom and step (wall time for ranks > 1)
run() {
  local ranks=$1 style=$2 steps=$3
  shift 3
  local command=("$lammps") file=CH.airebo
  case $style in airebo/morse*) file=CH.airebo-m ;; esac
  if [ "$ranks" -gt 1 ]; then command=(mpirun -np "$ranks" "$lammps"); fi
  "${command[@]}" -log none -in "$here/airebo_opt.in" -var style "$style 3.0" -var steps "$steps" \
    -var plugin "$build/lammps-plugin/nanocarbonplugin.so" -var potential "$potentials/$file" "$@" | awk -v ranks="$ranks" '
      /^Loop time of/ { loop = $4; steps = $9; atoms = $12 }
      /CPU use with/ { cpu = $1 / 100; if (ranks > 1) cpu = 1 }
      /^Pair / { pair = $5 }
      END { unit = cpu * 1e6 / steps / atoms; printf "%.4f %.4f\n", pair * unit, loop * unit }'
}

median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'; }

# compare NAME STYLE STEPS_OF_LAMMPS STEPS_OPT VARIABLES...
compare() {
  local name=$1 style=$2 slow=$3 fast=$4
  shift 4
  : >"$work/theirs"; : >"$work/opt"
  for ((round = 0; round < rounds; ++round)); do
    run 1 "$style" "$slow" "$@" >>"$work/theirs"
    run 1 "$style/opt" "$fast" "$@" >>"$work/opt"
  done
  local their_pair their_step opt_pair opt_step
  their_pair=$(cut -d' ' -f1 "$work/theirs" | median); their_step=$(cut -d' ' -f2 "$work/theirs" | median)
  opt_pair=$(cut -d' ' -f1 "$work/opt" | median); opt_step=$(cut -d' ' -f2 "$work/opt" | median)
  printf '%-26s %s: pair %s, step %s us   /opt: pair %s, step %s us   ratios: pair %s, step %s\n' "$name" "$style" \
    "$their_pair" "$their_step" "$opt_pair" "$opt_step" "$(ratio "$their_pair" "$opt_pair")" \
    "$(ratio "$their_step" "$opt_step")"
  last_step=$opt_step
}

echo "microseconds of CPU time an atom and step, medians of $rounds"
molecule=(-var from file -var data "$work/molecule.data" -var boundary "f f f" -var nx 1 -var ny 1 -var nz 1)
compare "sheet molecule, 300 K" airebo 30 400 "${molecule[@]}"
compare "sheet molecule, 300 K" airebo/morse 30 400 "${molecule[@]}"
compare "soup, 2500 K" airebo 50 200 -var from file -var data "$work/soup.data" -var nx 2 -var ny 2 -var nz 2 \
  -var temperature 1250 -var timestep 0.0002
compare "graphite, 300 K" airebo/morse 20 200
compare "graphite, 300 K" airebo 20 200
small=$last_step
large=$(for ((round = 0; round < rounds; ++round)); do run 1 airebo/opt 10 -var nx 84 -var ny 60; done | cut -d' ' -f2 | median)
echo "airebo/opt, graphite of 201,600: step $large us, $(ratio "$large" "$small") times that of 10,080"
if [ "$(nproc --all)" -ge 2 ]; then  # nproc alone would heed OMP_NUM_THREADS
  for ((round = 0; round < rounds; ++round)); do
    run 1 airebo/opt 20 -var nx 84 -var ny 60 | cut -d' ' -f2 >>"$work/one"
    run 2 airebo/opt 20 -var nx 84 -var ny 60 | cut -d' ' -f2 >>"$work/two"
  done
  # Wall time of two ranks against CPU time of one: means nothing on a machine that is busy otherwise.
  echo "airebo/opt, graphite of 201,600: two ranks are $(ratio "$(median <"$work/one")" "$(median <"$work/two")") times one (wall time)"
fi
