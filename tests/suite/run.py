#!/usr/bin/env python3
"""Builds a molecule from every mesh of a folder, runs each in LAMMPS, and prints what became of them.

    tests/suite/run.py FOLDER [--atoms N] [--out OUT] [-- BUILD OPTIONS...]

Each molecule runs for STEPS steps of 1 fs from rest, and as many more under a Langevin thermostat at 600 K, watched by
fix bond/topology. Writes OUT/suite.tsv and OUT/suite.md (which is also printed); data files, reports, logs and
pictures stay in OUT. Meshes that the program refuses stand in the table with its reason.
"""

import argparse
import json
import os
import pathlib
import re
import resource
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
MESH_ENDINGS = {".off", ".obj", ".ply", ".stl"}
COLUMNS = ["mesh", "atoms", "meV above graphene", "5/7 rings", "other rings", "% defects", "bonds, A", "bond cv",
           "angle sd", "distance, A", "CPU s", "from rest", "at 600 K"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--atoms", type=int, default=10000)
    parser.add_argument("--steps", type=int, default=5000)
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/suite"))
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build/release", help="the build folder")
    parser.add_argument("--pair", default="rebo/opt", help="pair style of the runs: rebo or rebo/opt")
    parser.add_argument("--only", default="", help="only meshes whose name holds this")
    parser.add_argument("options", nargs="*", help="more options of nanocarbon build")
    return parser.parse_args()


def cpu_seconds():
    usage = resource.getrusage(resource.RUSAGE_CHILDREN)
    return usage.ru_utime + usage.ru_stime


def run_in_lammps(args, data, prefix, temperature):
    """The verdict of one run, or what LAMMPS said instead."""
    plugin = args.build / "lammps-plugin"
    command = [plugin / "lmp-nanocarbon", "-in", ROOT / "examples/validate.in", "-log", f"{prefix}.log",
               "-var", "data", data, "-var", "steps", args.steps, "-var", "temperature", temperature,
               "-var", "plugin", plugin / "nanocarbonplugin.so", "-var", "pair", args.pair, "-var", "out", prefix]
    with open(f"{prefix}.screen", "w") as screen:
        subprocess.run([str(word) for word in command], stdout=screen, stderr=subprocess.STDOUT, check=False)
    text = pathlib.Path(f"{prefix}.screen").read_text(errors="replace")
    verdict = re.search(r"^verdict: ([a-z ]+), (\d+) atoms repelled", text, re.M)
    if not verdict:
        error = re.search(r"^ERROR.*", text, re.M)
        return error.group(0) if error else "no verdict"
    return verdict.group(1) + (f", {verdict.group(2)} repelled" if verdict.group(2) != "0" else "")


def row_of(args, mesh):
    prefix = args.out / mesh.stem
    data, report_file = prefix.with_suffix(".data"), prefix.with_suffix(".json")
    before = cpu_seconds()
    built = subprocess.run([args.build / "preprocessor/cli/nanocarbon", "build", mesh, "-o", data, "--quiet", "--report",
                            report_file, "--atoms", str(args.atoms), *args.options],
                           capture_output=True, text=True, check=False)
    seconds = cpu_seconds() - before
    if built.returncode != 0:
        reason = built.stderr.strip().splitlines()[-1] if built.stderr.strip() else "no message"
        return {"mesh": mesh.stem, "atoms": f"exit {built.returncode}: {reason.split(': ', 3)[-1]}"}
    report = json.loads(report_file.read_text())
    molecule, bonds = report["molecule"], report["bond_lengths"]
    rings = {int(size): count for size, count in molecule["rings_by_size"].items()}
    total = sum(rings.values())
    row = {
        "mesh": mesh.stem,
        "atoms": molecule["atoms"],
        "5/7 rings": f"{rings.get(5, 0)}/{rings.get(7, 0)}",
        "other rings": sum(count for size, count in rings.items() if not 5 <= size <= 7),
        "% defects": f"{100 * (total - rings.get(6, 0)) / total:.1f}",
        "bonds, A": f"{bonds['min']:.3f}-{bonds['max']:.3f}",
        "bond cv": f"{bonds['standard_deviation'] / bonds['mean']:.4f}",
        "angle sd": f"{report['bond_angles']['standard_deviation']:.2f}",
        "distance, A": f"{report['distance']['atoms_to_surface']['mean']:.2f}",
        "CPU s": f"{seconds:.1f}",
    }
    if "annealing" in report:
        row["meV above graphene"] = f"{1000 * report['annealing']['above_graphene']:.1f}"
    if args.steps > 0:
        row["from rest"] = run_in_lammps(args, data, f"{prefix}-rest", 0)
        # As it was after the run from rest.
        row["at 600 K"] = run_in_lammps(args, f"{prefix}-rest-after.data", f"{prefix}-hot", 600)
    return row


def main():
    args = arguments()
    if not args.folder.is_dir():
        sys.exit(f"suite: {args.folder}: no such folder")
    if not (args.build / "preprocessor/cli/nanocarbon").exists():
        sys.exit(f"suite: no program in {args.build}: build first, see README.md")
    args.out.mkdir(parents=True, exist_ok=True)
    os.environ.setdefault("OMP_NUM_THREADS", "1")
    meshes = sorted(m for m in args.folder.iterdir() if m.suffix.lower() in MESH_ENDINGS and args.only in m.name)
    if not meshes:
        sys.exit(f"suite: {args.folder} holds no mesh" + (f" with '{args.only}' in its name" if args.only else ""))

    tsv = ["\t".join(COLUMNS)]
    markdown = ["| " + " | ".join(COLUMNS) + " |", "|" + "---|" * len(COLUMNS)]
    print("\n".join(markdown))
    for mesh in meshes:
        row = row_of(args, mesh)
        cells = [str(row.get(column, "")) for column in COLUMNS]
        tsv.append("\t".join(cells))
        markdown.append("| " + " | ".join(cells) + " |")
        print(markdown[-1], flush=True)
        (args.out / "suite.tsv").write_text("\n".join(tsv) + "\n")
        (args.out / "suite.md").write_text("\n".join(markdown) + "\n")


if __name__ == "__main__":
    main()
