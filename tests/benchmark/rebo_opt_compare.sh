#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# What rebo_opt.sh and rebo_opt_general.sh share; sourced by them. Needs build, here, work, lammps and rounds.

# run RANKS STYLE STEPS VARIABLES...: prints "pair step" in CPU microseconds an atom and step (wall time for ranks > 1)
run() {
  local ranks=$1 style=$2 steps=$3
  shift 3
  local command=("$lammps")
  if [ "$ranks" -gt 1 ]; then command=(mpirun -np "$ranks" "$lammps"); fi
  "${command[@]}" -log none -in "$here/rebo_opt.in" -var style "$style" -var steps "$steps" \
    -var plugin "$build/lammps-plugin/nanocarbonplugin.so" "$@" | awk -v ranks="$ranks" '
      /^Loop time of/ { loop = $4; steps = $9; atoms = $12 }
      /CPU use with/ { cpu = $1 / 100; if (ranks > 1) cpu = 1 }
      /^Pair / { pair = $5 }
      END { unit = cpu * 1e6 / steps / atoms; printf "%.4f %.4f\n", pair * unit, loop * unit }'
}

median() { sort -g | awk '{ v[NR] = $1 } END { print v[int((NR + 1) / 2)] }'; }
ratio() { awk -v a="$1" -v b="$2" 'BEGIN { printf "%.2f", a / b }'; }

# compare NAME STEPS_REBO STEPS_OPT VARIABLES...
compare() {
  local name=$1 slow=$2 fast=$3
  shift 3
  : >"$work/rebo"; : >"$work/opt"
  for ((round = 0; round < rounds; ++round)); do
    run 1 rebo "$slow" "$@" >>"$work/rebo"
    run 1 rebo/opt "$fast" "$@" >>"$work/opt"
  done
  local rebo_pair rebo_step opt_pair opt_step
  rebo_pair=$(cut -d' ' -f1 "$work/rebo" | median); rebo_step=$(cut -d' ' -f2 "$work/rebo" | median)
  opt_pair=$(cut -d' ' -f1 "$work/opt" | median); opt_step=$(cut -d' ' -f2 "$work/opt" | median)
  printf '%-28s rebo: pair %s, step %s us   rebo/opt: pair %s, step %s us   ratios: pair %s, step %s\n' "$name" \
    "$rebo_pair" "$rebo_step" "$opt_pair" "$opt_step" "$(ratio "$rebo_pair" "$opt_pair")" \
    "$(ratio "$rebo_step" "$opt_step")"
  last_step=$opt_step
}
