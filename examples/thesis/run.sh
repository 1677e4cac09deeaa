#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The experiments of chapter 5 of the thesis, run again.
#
#   examples/thesis/run.sh MODELS_FOLDER [--short] [--out DIR] [--jobs N] [--only PART] [--page]
#
# MODELS_FOLDER holds egea, bunny, fertility and rocker-arm as OFF, OBJ, PLY or STL (see README.md for the sizes).
#   --short     few steps on small meshes, in under a minute: does everything still work?
#   --out DIR   where files go (default: out/thesis); what is there already is not made again
#   --jobs N    how many runs at a time (default: 1)
#   --only PART only one of the parts: remeshing, visited, interval, long, cg, earlier, default,
#               rebo, airebo, figures
#   --page      also put the tables into README.md beside this script
#
# Environment: NANOCARBON, the program; LAMMPS, lmp-nanocarbon; PLUGIN, nanocarbonplugin.so. Without them those of
# build/release are taken, or else those in the PATH. Needs Python 3 and nothing else.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
case "${1:-}" in
  "" | -h | --help) sed -n '2,/^set/{/^set/d;s/^# \{0,1\}//;p}' "$0"; if [ $# -gt 0 ]; then exit 0; else exit 2; fi ;;
esac

build=$here/../../build/release
built() { if [ -e "$build/$1" ]; then echo "$build/$1"; else echo "$2"; fi; }
export NANOCARBON=${NANOCARBON:-$(built preprocessor/cli/nanocarbon nanocarbon)}
export LAMMPS=${LAMMPS:-$(built lammps-plugin/lmp-nanocarbon lmp-nanocarbon)}
export PLUGIN=${PLUGIN:-$(built lammps-plugin/nanocarbonplugin.so nanocarbonplugin.so)}
export OMP_NUM_THREADS=1 PYTHONDONTWRITEBYTECODE=1
for program in "$NANOCARBON" "$LAMMPS"; do
  command -v "$program" >/dev/null || { echo "thesis: no program $program: build first, see README.md" >&2; exit 3; }
done
exec python3 "$here/experiments.py" "$@"
