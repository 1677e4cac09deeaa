#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# memory_check.sh LMP OBJECT CH.REBO C60.DATA: runs the fix on two ranks under valgrind, through all that touches memory,
# and fails when a report has the plugin's code in it. (MPI has leaks of its own.)
set -euo pipefail
lmp=$1 object=$2 potential=$3 data=$4
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat >in.memory <<END
variable again loop 2
label again
plugin load $object
units metal
boundary f f f
read_data $data
pair_style rebo
pair_coeff * * $potential C H
velocity all create 11000 4711
fix move all nve
fix watch all bond/topology 5 file changes.jsonl
fix second all bond/topology 7
thermo_style custom step f_watch f_watch[*]
thermo_modify lost ignore
timestep 0.0005
run 60 post no
write_restart state.restart
group some id 1:4
delete_atoms group some
run 20 post no
minimize 0 1e-3 5 10
clear
plugin load $object
units metal
read_restart state.restart
pair_style rebo
pair_coeff * * $potential C H
fix watch all bond/topology 5 append changes.jsonl
fix move all nve
run 20 post no
fix_modify watch reset yes
run 10 post no
write_dump all image picture.ppm f_watch[1] type fix watch type 0.2 0
unfix watch
clear
next again
jump SELF again
END
mpirun --allow-run-as-root --oversubscribe -n 2 valgrind -q --leak-check=full --show-leak-kinds=definite \
  --keep-debuginfo=yes --log-file=report.%p "$lmp" -in in.memory -log none >screen 2>&1 || { cat screen; exit 1; }
grep -q 'bonds broken' screen || { echo "the fix did not run"; cat screen; exit 1; }
if grep -l -e nanocarbonplugin -e 'nanocarbon::' report.* >/dev/null; then
  cat report.*
  exit 1
fi
echo "no report with the plugin's code in it"
