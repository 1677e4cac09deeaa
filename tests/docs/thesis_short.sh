#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-2.0-or-later
# The experiments of examples/thesis in their short form: every part runs, and every row of its tables has a verdict.
#
#   thesis_short.sh SOURCE_FOLDER WORK_FOLDER PROGRAM HOST_PROGRAM PLUGIN
set -euo pipefail
source=$1 work=$2
export NANOCARBON=$3 LAMMPS=$4 PLUGIN=$5
rm -rf "$work"
mkdir -p "$work"
"$source/examples/thesis/run.sh" "${NANOCARBON_MODELS:-$source/examples/meshes}" --short --out "$work" >"$work/said" 2>&1 || {
  cat "$work/said"
  exit 1
}
# A part that there is not, and a program that fails, do not go unnoticed.
for wrong in "--only figurs" "--jobs 0" "--out $work/a\ b"; do
  if eval "$source/examples/thesis/run.sh" "$source/examples/meshes" --short $wrong >/dev/null 2>&1; then
    echo "$wrong was taken"
    exit 1
  fi
done
if LAMMPS=false "$source/examples/thesis/run.sh" "$source/examples/meshes" --short --only rebo --out "$work/failing" >/dev/null 2>&1; then
  echo "a failing LAMMPS went unnoticed"
  exit 1
fi
for part in remeshing visited interval long earlier default rebo airebo; do
  grep -vE '^\| model|^\|---|^$' "$work/$part.md" >"$work/rows"
  rows=$(wc -l <"$work/rows")
  held=$(grep -cE '\| (intact|homeomorphic|broken|not a surface) \|' "$work/rows")
  echo "$part: $rows rows, $held with a verdict"
  [ "$rows" -gt 0 ] && [ "$rows" -eq "$held" ]
done
# Three minimisations.
[ "$(grep -oE '[0-9]+ repelled, [0-9]+ broken' "$work/cg.md" | wc -l)" -eq 3 ]
[ -s "$work/figure-5.5.png" ] && [ -s "$work/figure-default.png" ]
# The tables have a place on the page, each.
cp "$source/examples/thesis/README.md" "$work/page.md"
python3 -B - "$source/examples/thesis" "$work" <<'PYTHON'
import pathlib, sys
sys.path.insert(0, sys.argv[1])
import runs, tables
work = pathlib.Path(sys.argv[2])
# A command that has succeeded is not run again, one that failed is.
for exit_code, times in ((0, 1), (3, 2)):
    calls = work / f"calls-{exit_code}"
    for _ in range(2):
        runs.call(work / "call", ["sh", "-c", f"echo called >>{calls}; exit {exit_code}"])
    assert len(calls.read_text().split()) == times, (exit_code, times)
made = {name: (work / f"{name}.md").read_text() for name in tables.TABLES}
tables.put_into(work / "page.md", made)
text = (work / "page.md").read_text()
assert all(table in text for table in made.values())
PYTHON
