#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# Does the plugin work with a LAMMPS of your own? Builds it for that LAMMPS and runs C60 and a molecule of some 3,000
# atoms with pair_style rebo, rebo/opt, airebo and airebo/opt, watched by fix bond/topology, on 1 and 2 ranks.
#
#   scripts/check-lammps.sh LMP CMAKE_OPTIONS...
#
#   scripts/check-lammps.sh lammps/build/lmp -DLAMMPS_SOURCE_DIR=$PWD/lammps/src     # built in its source
#   scripts/check-lammps.sh ~/.local/bin/lmp -DLAMMPS_DIR=$HOME/.local/lib/cmake/LAMMPS    # installed with headers
#
# LMP has the packages PLUGIN, MANYBODY and MOLECULE. Needs the build that scripts/demo.sh leaves. Fails if energies of
# a style and its /opt, or of the numbers of ranks, differ by more than 1e-7 of their size, or a molecule is not intact.
# Environment: STEPS (200), POTENTIALS (rebo airebo).
set -euo pipefail
if [ $# -lt 2 ]; then sed -n 's/^# \{0,1\}//p' "$0" | sed 1d >&2; exit 2; fi
lammps=$(realpath "$(command -v "$1")")
shift
cd "$(dirname "$0")/.."
program=build/release/preprocessor/cli/nanocarbon
[ -x $program ] || { echo "check-lammps: there is no $program: run scripts/demo.sh first" >&2; exit 2; }
# Open MPI 4 and 5 have their own names for more ranks than cores.
export OMP_NUM_THREADS=1 OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
if [ "$(id -u)" -eq 0 ]; then export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1; fi

work=out/check-lammps
rm -rf "$work"
mkdir -p "$work"
cmake -G Ninja -S . -B "$work/build" -DNANOCARBON_PREPROCESSOR=OFF -DCMAKE_BUILD_TYPE=Release "$@" >"$work/configured"
grep -- '-- LAMMPS' "$work/configured"
cmake --build "$work/build" --target nanocarbonplugin >"$work/built" || { tail -n 40 "$work/built"; exit 1; }
cp examples/topology/c60.data "$work/"
$program build examples/meshes/torus.off --atoms 3000 --quality draft --quiet -o "$work/torus.data"

failed=0
printf '%-6s %-11s %-5s %-18s %s\n' data style ranks 'energy at start, eV' verdict
for data in c60 torus; do
  for style in $(printf '%s\n' ${POTENTIALS:-rebo airebo} | sed 'p; s,$,/opt,'); do
    case $style in */opt) ;; *) first= ;; esac
    for ranks in 1 2; do
      run=$work/$data-${style/\//-}-$ranks
      mpirun -np "$ranks" "$lammps" -in examples/validate.in -var data "$work/$data.data" -var pair "$style" -var steps "${STEPS:-200}" \
        -var pixels 0 -var plugin "$work/build/lammps-plugin/nanocarbonplugin.so" -var out "$run" -log "$run.log" >"$run.screen" 2>&1 ||
        { tail -n 5 "$run.screen"; failed=1; continue; }
      energy=$(awk '$1 == "Step" { table = 1; next } table { print $3; exit }' "$run.log")
      verdict=$(sed -n 's/^verdict: //p' "$run.log")
      first=${first:-$energy}
      printf '%-6s %-11s %-5s %-18s %s\n' "$data" "$style" "$ranks" "$energy" "$verdict"
      awk -v a="$first" -v b="$energy" 'BEGIN { d = a - b; if (d < 0) d = -d; exit !(b < 0 && d < 1e-7 * -b) }' ||
        { echo "  differs from $first"; failed=1; }
      case $verdict in intact*) ;; *) failed=1 ;; esac
    done
  done
done
exit $failed
