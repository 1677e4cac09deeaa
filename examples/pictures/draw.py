#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Draws molecules, and the meshes they were made from, side by side, by LAMMPS.

    draw.py OUT.png FILE... [--theta T] [--phi P] [--up "X Y Z"] [--zoom Z] [--pixels N]

A FILE is a LAMMPS data file of atom style molecular (FILE.data), or an OFF mesh, which is drawn as large as the last
data file. Environment: LAMMPS (default: lmp).
"""

import argparse
import os
import pathlib
import subprocess
import tempfile

import images

HERE = pathlib.Path(__file__).resolve().parent
VIEW = {"theta": "65", "phi": "30", "up": "0 0 1", "zoom": "1.6"}


def render(picture, data, view, **variables):
    """One picture, twice as large as it will be."""
    command = [os.environ.get("LAMMPS", "lmp"), "-in", HERE / "picture.in", "-log", "none"]
    for name, value in {"data": data, "picture": picture, **view, **variables}.items():
        command += ["-var", name, value]
    done = subprocess.run([str(word) for word in command], capture_output=True, text=True, check=False)
    if done.returncode != 0 or not picture.exists():
        raise RuntimeError(f"LAMMPS drew no picture of {data}: {done.stdout[-500:]}")
    return images.halved(images.read_ppm(picture))


def draw(out, scenes, view, pixels=480):
    """Scenes (data file, further variables of picture.in) side by side in one PNG."""
    with tempfile.TemporaryDirectory() as folder:
        drawn = [render(pathlib.Path(folder) / f"{n}.ppm", data, VIEW | view, **variables, pixels=2 * pixels)
                 for n, (data, variables) in enumerate(scenes)]
    images.write_png(out, images.beside(images.cropped(drawn)))


def box_of(data):
    """The atoms' bounding box, and the lines of the file that say how large its own box is."""
    positions, sides, section = [], [], None
    for line in open(data):
        words = line.split()
        if len(words) >= 4 and words[3] in ("xhi", "yhi", "zhi"):
            sides.append(line)
        if words and words[0].isalpha():
            section = words[0]
        elif section == "Atoms" and words:
            positions.append(tuple(map(float, words[3:6])))
    return [min(c) for c in zip(*positions)], [max(c) for c in zip(*positions)], sides


def mesh_as_data(mesh, like, path):
    """A data file whose atoms and bonds are a mesh's vertices and edges, as large as a molecule."""
    words = " ".join(line.split("#")[0] for line in open(mesh)).split()[1:]
    vertices, faces = int(words[0]), int(words[1])
    numbers = words[3:]
    points = [tuple(map(float, numbers[3 * v:3 * v + 3])) for v in range(vertices)]
    edges, at = set(), 3 * vertices
    for _ in range(faces):
        corners = [int(c) for c in numbers[at + 1:at + 1 + int(numbers[at])]]
        at += 1 + int(numbers[at])
        edges |= {(min(a, b), max(a, b)) for a, b in zip(corners, corners[1:] + corners[:1])}
    low, high, sides = box_of(like)
    own = [min(c) for c in zip(*points)], [max(c) for c in zip(*points)]
    scale = max(h - b for b, h in zip(low, high)) / max(h - b for b, h in zip(*own))
    middle = [(b + h) / 2 for b, h in zip(low, high)]
    centre = [(b + h) / 2 for b, h in zip(*own)]
    with open(path, "w") as out:
        out.write(f"{mesh}\n\n{vertices} atoms\n1 atom types\n{len(edges)} bonds\n1 bond types\n"
                  f"20 extra bond per atom\n\n{''.join(sides)}\nAtoms # molecular\n\n")
        for v, point in enumerate(points):
            place = (m + scale * (c - o) for m, c, o in zip(middle, point, centre))
            out.write(f"{v + 1} 1 1 " + " ".join(f"{x:.5f}" for x in place) + "\n")
        out.write("\nBonds\n\n")
        for e, (a, b) in enumerate(sorted(edges)):
            out.write(f"{e + 1} 1 {a + 1} {b + 1}\n")


def draw_files(out, files, view, pixels=480):
    """Data files, and OFF meshes drawn as large as the last data file."""
    molecules = [file for file in files if file.suffix != ".off"]
    with tempfile.TemporaryDirectory() as folder:
        scenes = []
        for file in files:
            if file.suffix == ".off":
                data = pathlib.Path(folder) / f"{file.stem}.data"
                mesh_as_data(file, molecules[-1], data)
                scenes.append((data, {"atom": "0.3", "bond": "0.3", "colour": "steelblue"}))
            else:
                scenes.append((file, {}))
        draw(out, scenes, view, pixels)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("out", type=pathlib.Path)
    parser.add_argument("files", type=pathlib.Path, nargs="+")
    for name, value in VIEW.items():
        parser.add_argument("--" + name, default=value)
    parser.add_argument("--pixels", type=int, default=480)
    args = parser.parse_args()
    if all(file.suffix == ".off" for file in args.files):
        parser.error("at least one data file is needed")
    draw_files(args.out, args.files, {name: getattr(args, name) for name in VIEW}, args.pixels)


if __name__ == "__main__":
    main()
