#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes a molecule of each example mesh and some known structures, with a page and a picture of each.

    examples/gallery/make.py [FOLDER]    files go to FOLDER (default: out/gallery)

FOLDER/gallery.json lists them; the project's site shows them. Environment: NANOCARBON, the program (default: nanocarbon);
LAMMPS, which draws the pictures (default: lmp; without it there are none).
"""

import json
import os
import pathlib
import shutil
import subprocess
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "pictures"))

import draw  # noqa: E402

# Name, title, and how many atoms it gets as a draft; how it is looked at (angles of LAMMPS's dump image).
MESHES = [
    ("gyroid-shell", "A shell around the gyroid", 2400, {"theta": "40", "phi": "20"}),
    ("genus-two", "Two tori grown together", 1400, {"theta": "30", "phi": "20"}),
    ("torus", "A torus", 800, {"theta": "50"}),
    ("helix", "A helix", 1600, {"theta": "75"}),
    ("y-junction", "Three tubes that meet", 1000, {"theta": "20"}),
    ("t-junction", "A closed T of tubes", 1000, {"theta": "20"}),
    ("x-junction", "Four tubes that meet", 1200, {"theta": "20"}),
    ("capsule", "A capsule", 400, {}),
    ("sphere", "A sphere", 320, {}),
    ("hemisphere", "A bowl", 300, {"theta": "60"}),
    ("gyroid-piece", "A cube's worth of the gyroid", 900, {"theta": "40", "phi": "20"}),
]
STRUCTURES = [
    ("c60", "C60", ["fullerene", "1", "1"]),
    ("tube", "An armchair tube (10, 10)", ["tube", "10", "10", "--length", "40"]),
    ("p688", "The schwarzite P688", ["schwarzite", "p688", "--cells", "2"]),
]


def run(program, *arguments):
    subprocess.run([program, *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def picture(folder, name, files, view):
    """Mesh and molecule side by side; nothing where there is no LAMMPS."""
    if not shutil.which(os.environ.get("LAMMPS", "lmp")):
        return None
    draw.draw_files(folder / f"{name}.png", files, view, 320)
    return f"{name}.png"


def main():
    folder = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else "out/gallery")
    folder.mkdir(parents=True, exist_ok=True)
    program, items = os.environ.get("NANOCARBON", "nanocarbon"), []
    for name, title, atoms, view in MESHES:
        mesh, data, page = HERE.parent / "meshes" / f"{name}.off", folder / f"{name}.data", folder / f"{name}.html"
        run(program, "build", mesh, "--atoms", atoms, "--quality", "draft", "-q", "-o", data, "--page", page)
        items.append({"title": f"{title}, {atoms} atoms", "page": page.name, "picture": picture(folder, name, [mesh, data], view),
                      "command": f"nanocarbon build examples/meshes/{name}.off --atoms {atoms} --quality draft"})
    for name, title, what in STRUCTURES:
        data, page = folder / f"{name}.data", folder / f"{name}.html"
        run(program, "make", *what, "-q", "-o", data)
        run(program, "analyse", data, "-q", "--page", page)
        items.append({"title": title, "page": page.name, "picture": picture(folder, name, [data], {}),
                      "command": f"nanocarbon make {' '.join(what)}"})
    (folder / "gallery.json").write_text(json.dumps(items, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
