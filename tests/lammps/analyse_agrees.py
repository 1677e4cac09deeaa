#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compares `nanocarbon analyse` of a trajectory with what fix bond/topology wrote while it ran.

    analyse_agrees.py PROGRAM LMP_NANOCARBON PLUGIN DATA FOLDER

C60 is heated until bonds break; the fix looks at every frame that is written. Bonds broken and formed and repelled atoms
must be the same in each, verdict and rings wherever the fix tells them.
"""

import json
import pathlib
import subprocess
import sys

SCRIPT = """
plugin load {plugin}
units metal
boundary f f f
read_data {data}
pair_style rebo
pair_coeff * * {potential} C H
timestep 0.0005
velocity all create 6000 {seed} mom yes rot yes
fix move all nve
fix heat all langevin 6000 9000 0.05 {seed} zero yes
fix watch all bond/topology 20 file {jsonl}
dump frames all xyz 20 {xyz}
dump_modify frames element C H sort id format line "%s %.17g %.17g %.17g"
thermo_modify lost ignore
run 4400
"""


def main():
    program, lammps, plugin, data, folder = sys.argv[1:]
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    potential = next(p for p in ["/usr/share/lammps/potentials/CH.rebo", "CH.rebo"] if pathlib.Path(p).exists())
    jsonl, xyz, script = folder / "watch.jsonl", folder / "run.xyz", folder / "run.in"
    jsonl.unlink(missing_ok=True)
    script.write_text(SCRIPT.format(plugin=plugin, data=data, potential=potential, seed=4711, jsonl=jsonl, xyz=xyz))
    subprocess.run([lammps, "-in", script, "-log", "none", "-screen", "none"], check=True)
    watched = [json.loads(line) for line in jsonl.read_text().splitlines()]
    done = subprocess.run([program, "analyse", xyz, "--json", "--potential", "none", "--form", "1.7", "--break", "2.0"],
                          capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    frames = json.loads(done.stdout)["frames"]
    changes = {line["step"]: line for line in watched if line["event"] == "change"}
    assert len(changes) > 5 and any(line["since_start"]["broken"] > 0 for line in changes.values()), "nothing broke"
    current = {"verdict": "intact", "since_start": {"broken": 0, "formed": 0, "repelled": 0}}
    compared = 0
    for number, frame in enumerate(frames):
        change = changes.get(20 * number)
        current = change or current
        since = current["since_start"]
        if since.get("lost"):
            break  # atoms have no names in an XYZ file
        compared += 1
        found = [len(frame["broken"]), len(frame["formed"]), len(frame["repelled"])]
        assert found == [since["broken"], since["formed"], since["repelled"]], (number, found, since)
        # The same bonds may make a surface at one time and be too crumpled for one at another, which the fix writes
        # down only when bonds change.
        if change:
            assert frame["verdict"] == change["verdict"], (number, frame["verdict"], change["verdict"])
            if change.get("surface"):
                assert frame["rings"] == change["rings"], (number, frame["rings"], change["rings"])
    assert compared > 100, compared
    print(f"{compared} of {len(frames)} frames, {len(changes)} changes, at the end {frames[-1]['verdict']}")


if __name__ == "__main__":
    main()
