#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds preprocessor/doc/analysis.md to the JSON of `nanocarbon analyse`: every key of it, and no other.

    analysis_page.py PROGRAM PAGE FOLDER
"""

import json
import pathlib
import re
import subprocess
import sys

from report_page import keys

STRUCTURES = {"c60.data": ["fullerene", "1", "1"], "diamond.xyz": ["diamond", "--cells", "2"],
              "acetylene.xyz": None, "heap.xyz": None, "hydrogen.xyz": None}


def main():
    program, page, folder = sys.argv[1], sys.argv[2], pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "acetylene.xyz").write_text("4\n\nC 0 0 0\nC 1.3 0 0\nH 2.3 0 0\nH -1 0 0\n")
    (folder / "hydrogen.xyz").write_text("2\n\nH 0 0 0\nH 0.74 0 0\n")
    (folder / "heap.xyz").write_text("20\n\n" + "".join(f"C {0.05 * i} 0 0\n" for i in range(20)))
    written = set()
    for name, structure in STRUCTURES.items():
        if structure:
            subprocess.run([program, "make", *structure, "-q", "-o", folder / name], check=True)
        done = subprocess.run([program, "analyse", folder / name, "--json"], capture_output=True, text=True, check=True)
        for key in keys(json.loads(done.stdout)):
            written.add(key)
    documented = set(re.findall(r"^\| `([A-Za-z0-9_.*-]+)` \|", open(page).read(), re.M))
    stars = tuple(key[:-1] for key in documented if key.endswith("*"))
    complaints = [f"{key} is missing from the page" for key in sorted(written - documented) if not key.startswith(stars)]
    complaints += [f"the page has {key}, no analysis has"
                   for key in sorted(documented - written)
                   if not (key.endswith("*") and any(w.startswith(key[:-1]) for w in written))]
    if complaints:
        sys.exit("\n".join([*complaints, "Please bring the page preprocessor/doc/analysis.md up to date."]))


if __name__ == "__main__":
    main()
