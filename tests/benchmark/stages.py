#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What building a molecule costs an atom, by stage and size, and how it grows.

    stages.py PROGRAM MESH... [--sizes 10000 40000 160000] [--quality draft] [--threads 1]

CPU time of all threads in ms an atom. The last column is the exponent of each stage's time as a power of the number of
atoms, by least squares in logarithms; 1 is linear. Stages that take less than a thousandth of the whole at the largest
size have none.
"""

import argparse
import json
import math
import os
import subprocess
import sys
import tempfile


def exponent(points):
    """The slope of log y over log x."""
    logs = [(math.log(x), math.log(y)) for x, y in points]
    mean_x = sum(x for x, _ in logs) / len(logs)
    mean_y = sum(y for _, y in logs) / len(logs)
    return sum((x - mean_x) * (y - mean_y) for x, y in logs) / sum((x - mean_x) ** 2 for x, _ in logs)


def build(program, mesh, atoms, options, folder):
    """Atoms, CPU seconds by stage and of the whole process, wall-clock seconds and peak memory in MB."""
    report = os.path.join(folder, "report.json")
    process = subprocess.Popen([program, "build", mesh, "-o", os.path.join(folder, "molecule.data"), "--atoms", str(atoms), "--quiet",
                                "--report", report, "--quality", options.quality, "--threads", str(options.threads), "--force"])
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        sys.exit(f"{mesh}: building {atoms} atoms failed")
    with open(report) as text:
        report = json.load(text)
    stages = {name: time["cpu"] for name, time in report["stages"].items()}
    whole = usage.ru_utime + usage.ru_stime
    stages["rest"] = max(whole - sum(stages.values()), 0)
    stages["all"] = whole
    wall = sum(time["wall"] for time in report["stages"].values())
    return report, stages, wall, usage.ru_maxrss / 1024


def table(mesh, program, options, folder):
    runs = [build(program, mesh, atoms, options, folder) for atoms in options.sizes]
    counts = [report["molecule"]["atoms"] for report, *_ in runs]
    print(f"{os.path.basename(mesh)}, {options.quality}, {options.threads} thread(s): CPU ms an atom")
    print(f"{'stage':<16}" + "".join(f"{count:>11}" for count in counts) + f"{'exponent':>11}")
    for stage in runs[-1][1]:
        times = [stages.get(stage, 0) for _, stages, *_ in runs]
        fitted = ""
        if len(counts) > 1 and min(times) > 0 and times[-1] > 1e-3 * runs[-1][1]["all"]:
            fitted = f"{exponent(list(zip(counts, times))):.2f}"
        print(f"{stage:<16}" + "".join(f"{1e3 * time / count:>11.4f}" for time, count in zip(times, counts)) + f"{fitted:>11}")
    for name, values in (("wall, s", [f"{wall:.1f}" for *_, wall, _ in runs]), ("memory, MB", [f"{memory:.0f}" for *_, memory in runs]),
                         ("eV an atom", [f"{report['annealing']['energy_per_atom']:.5f}" for report, *_ in runs]),
                         ("intact", [str(report["annealing"]["rebo2_sees_these_bonds"]).lower() for report, *_ in runs])):
        print(f"{name:<16}" + "".join(f"{value:>11}" for value in values))
    print(flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("meshes", nargs="+", metavar="MESH")
    parser.add_argument("--sizes", type=int, nargs="+", default=[10_000, 40_000, 160_000])
    parser.add_argument("--quality", default="draft")
    parser.add_argument("--threads", type=int, default=1)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        for mesh in options.meshes:
            table(mesh, options.program, options, folder)


if __name__ == "__main__":
    main()
