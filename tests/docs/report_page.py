#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds preprocessor/doc/report.md to the reports that the program writes: every key of theirs, and no other.

    report_page.py PROGRAM PAGE MESH FOLDER
"""

import json
import re
import subprocess
import sys


def keys(value, path=""):
    for key, inner in value.items():
        yield from keys(inner, f"{path}{key}.") if isinstance(inner, dict) else [path + key]


def main():
    program, page, mesh, folder = sys.argv[1:]
    written = set()
    periodic = f"{folder}/schwarz-p.off"
    subprocess.run([program, "make", "mesh", "schwarz-p", "-o", periodic, "--quiet"], check=True)
    opened = f"{folder}/hemisphere.off"
    subprocess.run([program, "make", "mesh", "hemisphere", "-o", opened, "--quiet"], check=True)
    meshes = {"periodic": periodic, "open": opened}
    for name, options in {"periodic": ["--quality", "draft"], "open": ["--quality", "draft"], "annealed": ["--quality", "draft", "--certify"], "thesis": ["--recipe", "thesis"]}.items():
        report = f"{folder}/{name}.json"
        subprocess.run([program, "build", meshes.get(name, mesh), "-o", f"{folder}/{name}.data", "--atoms", "300", "--quiet", "--report",
                        report, *options], check=True)
        with open(report) as text:
            written |= set(keys(json.load(text)))
    documented = set(re.findall(r"^\| `([a-z0-9_.*]+)` \|", open(page).read(), re.M))
    # A star stands for every key below: ring sizes, and keys that are explained once.
    stars = tuple(key[:-1] for key in documented if key.endswith("*"))
    complaints = [f"{key} is missing from the page" for key in sorted(written - documented) if not key.startswith(stars)]
    complaints += [f"the page has {key}, no report has"
                   for key in sorted(documented - written)
                   if not (key.endswith("*") and any(w.startswith(key[:-1]) for w in written))]
    if complaints:
        sys.exit("\n".join([*complaints, "Please bring the page preprocessor/doc/report.md up to date."]))


if __name__ == "__main__":
    main()
