#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Builds a molecule from every mesh of a folder, runs each in LAMMPS, and prints what became of them.

    tests/suite/run.py FOLDER [--atoms N] [--jobs J] [--out OUT] [-- BUILD OPTIONS...]

Each molecule runs for STEPS steps of 1 fs from rest, and as many more under a Langevin thermostat at 600 K, watched by
fix bond/topology. With --pair airebo or airebo/morse (or their /opt) the molecules are built with that potential, too.
Writes OUT/suite.tsv and OUT/suite.md (which is also printed), and OUT/index.html, which leads to a page of each molecule;
data files, reports, logs and pictures stay in OUT. Meshes that the program refuses stand in the table with its reason, and
with --follow-refusals they are built again at the size that it says would do; with --follow-advice also with the options
that it names, one after the other, so that the table shows whether what it says is true. A run that was cut short goes on
with --resume.
"""

import argparse
import concurrent.futures
import json
import os
import pathlib
import subprocess
import sys
import tempfile

from measure import STYLES, row_of
from table import write_tables

ROOT = pathlib.Path(__file__).resolve().parents[2]
MESH_ENDINGS = {".off", ".obj", ".ply", ".stl", ".glb", ".gltf", ".3mf", ".vtk", ".vtp", ".vtu", ".msh"}


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Words after -- go to nanocarbon build.")
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--atoms", type=int, default=10000)
    parser.add_argument("--steps", type=int, default=5000, help="of each of the two runs; 0: build only")
    parser.add_argument("--jobs", type=int, default=1, help="meshes at a time")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/suite"))
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="the build folder")
    parser.add_argument("--pair", default="rebo/opt", choices=[*STYLES, *(style + "/opt" for style in STYLES)],
                        help="pair style of the runs; molecules are built with the potential that goes with it")
    parser.add_argument("--only", default="", help="only meshes whose name holds one of these, separated by commas")
    parser.add_argument("--resume", action="store_true", help="keep rows that OUT has of the same request")
    parser.add_argument("--follow-refusals", action="store_true", help="build refused shapes at the size named")
    parser.add_argument("--follow-advice", action="store_true",
                        help="build refused shapes with whatever size and options the program names")
    parser.add_argument("--largest", type=int, default=40000, help="do not follow to more atoms than this")
    parser.add_argument("--lammps-energy", action="store_true",
                        help="minimise with LAMMPS's own pair style, too, and compare energies")
    parser.add_argument("--no-pages", dest="pages", action="store_false", help="no pages of the molecules")
    parser.add_argument("--launcher", default="", help="command to put before every program, as 'nice -n 5'")
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    args = parser.parse_args(words[:cut])
    args.options = words[cut + 1:]
    args.root = ROOT
    return args


def request_of(args):
    """What a row depends on besides the mesh and the program."""
    return {"atoms": args.atoms, "steps": args.steps, "pair": args.pair, "options": args.options,
            "follow": args.follow_refusals, "advice": args.follow_advice, "largest": args.largest,
            "lammps": args.lammps_energy, "pages": args.pages}


def makes_pages(args):
    """Whether the program was built with what pages need."""
    with tempfile.TemporaryDirectory() as folder:
        atoms = pathlib.Path(folder) / "two.xyz"
        atoms.write_text("2\n\nC 0 0 0\nC 1.4 0 0\n")
        done = subprocess.run([args.build / "preprocessor/cli/nanocarbon", "analyse", atoms, "-q", "--page",
                               atoms.with_suffix(".html")], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        print(f"suite: no pages: {done.stderr.strip()}", file=sys.stderr)
    return done.returncode == 0


def row_or_old_row(args, mesh):
    store, request = args.out / f"{mesh.stem}.row.json", request_of(args)
    if args.resume and store.exists():
        old = json.loads(store.read_text())
        if old["request"] == request:
            return old["row"]
    row = row_of(args, mesh)
    store.write_text(json.dumps({"request": request, "row": row}, indent=1) + "\n")
    return row


def main():
    args = arguments()
    if not args.folder.is_dir():
        sys.exit(f"suite: {args.folder}: no such folder")
    if not (args.build / "preprocessor/cli/nanocarbon").exists():
        sys.exit(f"suite: no program in {args.build}: build first, see README.md")
    args.out.mkdir(parents=True, exist_ok=True)
    args.pages = args.pages and makes_pages(args)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    wanted = args.only.split(",")
    meshes = sorted(m for m in args.folder.iterdir()
                    if m.suffix.lower() in MESH_ENDINGS and any(word in m.name for word in wanted))
    if not meshes:
        sys.exit(f"suite: {args.folder} holds no mesh" + (f" with '{args.only}' in its name" if args.only else ""))

    rows = {}
    with concurrent.futures.ThreadPoolExecutor(args.jobs) as pool:
        futures = {pool.submit(row_or_old_row, args, mesh): mesh for mesh in meshes}
        for done in concurrent.futures.as_completed(futures):
            rows[futures[done]] = done.result()
            print(f"suite: {len(rows)} of {len(meshes)}: {futures[done].name}", file=sys.stderr, flush=True)
            write_tables(args.out, [rows[mesh] for mesh in meshes if mesh in rows], " ".join(sys.argv[1:]))
    print((args.out / "suite.md").read_text(), end="")


if __name__ == "__main__":
    main()
