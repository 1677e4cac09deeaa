#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Makes known structures, relaxes them in LAMMPS with REBO2, and prints their energies beside the known ones.
#
#   examples/structures/run.sh [FOLDER]    files go to FOLDER (default: out/structures)
#
# Environment: NANOCARBON, the program (default: nanocarbon); LAMMPS (default: lmp).
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
folder=${1:-out/structures}
mkdir -p "$folder"

compare() {  # compare NAME KNOWN BOUNDARY CELL MAKE-ARGUMENTS...
  local name=$1 known=$2 boundary=$3 cell=$4 energy
  shift 4
  "${NANOCARBON:-nanocarbon}" make "$@" --quiet -o "$folder/$name.data"
  "${LAMMPS:-lmp}" -in "$here/relax.in" -var data "$folder/$name.data" -var boundary "$boundary" -var cell "$cell" \
    -log "$folder/$name.log" -screen none
  energy=$(sed -n 's/^energy per atom: \(.*\) eV$/\1/p' "$folder/$name.log")
  printf '%-12s %12s %12s\n' "$name" "$energy" "$known"
}

printf '%-12s %12s %12s   eV for each atom\n' structure here known
compare graphene -7.394997 "p p f" xy graphene --cells 6 4
compare tube-10-10 -7.355858 "f f p" z tube 10 10 --length 15 --periodic
compare tube-5-5 -7.246168 "f f p" z tube 5 5 --length 15 --periodic
compare C60 -6.842065 "f f f" none fullerene 1 1
compare C240 -7.205094 "f f f" none fullerene 2 2
compare C540 -7.294654 "f f f" none fullerene 3 3
compare C720 -7.315190 "f f f" none fullerene 6 0
compare C960 -7.332492 "f f f" none fullerene 4 4
compare D688 -7.245690 "p p p" iso schwarzite d688 --cells 2
compare P688 -7.118862 "p p p" iso schwarzite p688 --cells 2
compare G688 -7.155575 "p p p" iso schwarzite g688 --cells 1
compare P192 -7.279339 "p p p" iso schwarzite p192
compare D168 -7.242802 "p p p" iso schwarzite d168
compare D192 -7.242428 "p p p" iso schwarzite d192
compare G384 -7.259174 "p p p" iso schwarzite g384
compare diamond -7.369997 "p p p" iso diamond --cells 3
