#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Molecules of open surfaces in one picture: their boundaries with the hydrogen there.

    boundaries.py OUT.png [--atoms N] [--pixels N] [-- BUILD OPTIONS...]

Makes a hemisphere, an annulus, a saddle and half a torus, builds a molecule of each, prints what its boundary is made of and
draws it by LAMMPS. Environment: NANOCARBON, the program (default: nanocarbon); LAMMPS (default: lmp).
"""

import argparse
import json
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import draw

TURN = 2 * math.pi
# How many steps each way, whether each way closes, where a point is, and how it is looked at.
SHAPES = {
    "hemisphere": ((48, 24), (True, False),
                   lambda u, v: (math.sin(0.25 * TURN * (0.02 + 0.98 * v)) * math.cos(TURN * u),
                                 math.sin(0.25 * TURN * (0.02 + 0.98 * v)) * math.sin(TURN * u),
                                 math.cos(0.25 * TURN * (0.02 + 0.98 * v))), {"theta": "110", "phi": "20"}),
    "annulus": ((48, 12), (True, False),
                lambda u, v: ((0.45 + 0.55 * v) * math.cos(TURN * u), (0.45 + 0.55 * v) * math.sin(TURN * u), 0),
                {"theta": "30", "phi": "20"}),
    "saddle": ((24, 24), (False, False), lambda u, v: (2 * u - 1, 2 * v - 1, 0.5 * ((2 * u - 1) ** 2 - (2 * v - 1) ** 2)),
               {"theta": "60", "phi": "30"}),
    "half-torus": ((36, 24), (False, True),
                   lambda u, v: ((1 + 0.4 * math.cos(TURN * v)) * math.cos(0.5 * TURN * u),
                                 (1 + 0.4 * math.cos(TURN * v)) * math.sin(0.5 * TURN * u), 0.4 * math.sin(TURN * v)),
                   {"theta": "40", "phi": "-60"}),
}


def write_mesh(path, steps, closes, place):
    """A sheet of quadrangles; where a way closes, its end is its beginning. The hemisphere's pole is capped."""
    columns = [n if closed else n + 1 for n, closed in zip(steps, closes)]
    points = [place(i / steps[0], j / steps[1]) for i in range(columns[0]) for j in range(columns[1])]

    def number(i, j):
        return i % columns[0] * columns[1] + j % columns[1]

    faces = [(number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1))
             for i in range(steps[0]) for j in range(steps[1])]
    if path.stem == "hemisphere":
        faces.append([number(i, 0) for i in reversed(range(columns[0]))])
    lines = ["OFF", f"{len(points)} {len(faces)} 0", *(" ".join(f"{x:.9g}" for x in p) for p in points),
             *(" ".join(map(str, [len(f), *f])) for f in faces)]
    path.write_text("\n".join(lines) + "\n")


def build(folder, name, atoms, options):
    steps, closes, place, view = SHAPES[name]
    mesh, data, report = (folder / f"{name}.{ending}" for ending in ("off", "data", "json"))
    write_mesh(mesh, steps, closes, place)
    subprocess.run([os.environ.get("NANOCARBON", "nanocarbon"), "build", mesh, "-q", "--atoms", str(atoms), "-o", data,
                    "--report", report, *options], check=True)
    facts = json.loads(report.read_text())
    boundary = facts["boundary"]
    print(f"{name}: {facts['molecule']['formula']}, {1000 * facts['annealing']['above_graphene']:.1f} meV above graphene, "
          f"boundary {100 * boundary['zigzag']:.0f}% zigzag and {100 * boundary['armchair']:.0f}% armchair, "
          f"{boundary['energy_per_length']:.3f} eV/A", flush=True)
    return data, view


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0], epilog="Words after -- go to nanocarbon build; without any, drafts are built.")
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("--atoms", type=int, default=600, help="of each molecule")
    parser.add_argument("--pixels", type=int, default=300, help="of each molecule's picture, before it is cropped")
    words = sys.argv[1:]
    cut = words.index("--") if "--" in words else len(words)
    args = parser.parse_args(words[:cut])
    with tempfile.TemporaryDirectory() as folder:
        options = words[cut + 1:] or ["--quality", "draft"]
        scenes = [build(pathlib.Path(folder), name, args.atoms, options) for name in SHAPES]
        draw.draw(args.out, scenes, {}, args.pixels)


if __name__ == "__main__":
    main()
