#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Builds molecules on minimal surfaces in a cell and prints the table of periodic.md.

    periodic_table.py PROGRAM FOLDER [SURFACE:ATOMS[:QUALITY] ...]

Reports that are in FOLDER already are taken as they are, so that a run may be stopped and gone on with. The page's table:

    periodic_table.py build/release/preprocessor/cli/nanocarbon OUT
"""

import json
import pathlib
import resource
import subprocess
import sys

# What make mesh is asked for: the least cell of each, and the genus of the surface in it.
SURFACES = {
    "P": (["schwarz-p"], 3),
    "G": (["gyroid", "--primitive"], 3),
    "D": (["schwarz-d", "--primitive"], 3),
    "I-WP": (["i-wp", "--primitive"], 4),
}

# Networks of hexagons and octagons (of hexagons and heptagons, D168 and D224) at rest, by atoms: meV above graphene.
CRYSTALS = {
    "P": {144: 141.64, 192: 115.66, 432: 77.19, 576: 68.47, 768: 56.66, 1728: 34.8, 2304: 29.3},
    "G": {144: 143.06, 192: 135.82},
    "D": {144: 156.56, 168: 152.20, 192: 152.57, 224: 127.48, 768: 148.0},
}

ROWS = [f"{surface}:{atoms}" for surface in SURFACES for atoms in (190, 400, 1000, 1600, 3000, 10000)]


def build(program, folder, surface, atoms, quality):
    """The report of a build, from the folder where it is there."""
    kind, _ = SURFACES[surface]
    name = folder / f"{surface}-{atoms}-{quality}"
    report = name.with_suffix(".json")
    if not report.exists():
        mesh = folder / f"{surface}.off"
        subprocess.run([program, "make", "mesh", *kind, "-o", mesh, "-q"], check=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
        subprocess.run([program, "build", mesh, "-o", name.with_suffix(".data"), "--atoms", str(atoms), "--quality", quality,
                        "--relax-cell", "triclinic", "--report", report, "--threads", "1", "-q"], check=True)
        seconds = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before
        name.with_suffix(".seconds").write_text(f"{seconds:.0f}\n")
    return json.loads(report.read_text()), name.with_suffix(".seconds").read_text().strip()


def crystal(surface, atoms):
    """The known network of nearest size, if one is within a tenth."""
    near = min(CRYSTALS.get(surface, {}), key=lambda n: abs(n - atoms), default=None)
    if near is None or abs(near - atoms) > 0.1 * atoms:
        return ""
    return f"{CRYSTALS[surface][near]:.1f} ({near})"


def row(program, folder, text):
    surface, atoms, quality = (text.split(":") + ["good"])[:3]
    report, seconds = build(program, folder, surface, int(atoms), quality)
    molecule, annealing = report["molecule"], report["annealing"]
    if molecule["genus"] != SURFACES[surface][1]:
        sys.exit(f"{text}: genus {molecule['genus']}")
    rings = "/".join(str(molecule["rings_by_size"].get(size, 0)) for size in "5678")
    stress = max(abs(s) for line in report["cell"]["stress"] for s in line)
    return (f"| {surface} | {quality} | {molecule['atoms']} | {molecule['genus']} | {rings} | "
            f"{1e3 * annealing['above_graphene']:.1f} | {crystal(surface, molecule['atoms'])} | {stress:.0e} | {seconds} |")


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    print("| surface | quality | atoms | genus | rings 5/6/7/8 | meV an atom | known network (atoms) | stress, GPa | CPU, s |")
    print("|---|---|---|---|---|---|---|---|---|")
    for text in sys.argv[3:] or ROWS:
        print(row(program, folder, text), flush=True)


if __name__ == "__main__":
    main()
