#!/bin/bash
# SPDX-License-Identifier: GPL-2.0-or-later
# How soon the program says no: refusal.sh BUILD_FOLDER [ROUNDS]
#
# Asks for 2,000 atoms of a pipe of 100,000 triangles whose wall is too thin (cylinders of radius 1 and 0.97), on one thread.
# Prints medians of CPU time and of time on the clock, seconds: of the first reason as it appears, and of the refusal, with
# the size that would do; then of --atoms fit, which refuses to go on to so many. Reading the file is in all.
set -euo pipefail
build=$(cd "$1" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
python3 - "$build/preprocessor/cli/nanocarbon" "$work" "${2:-3}" <<'PYTHON'
import math, os, pathlib, statistics, subprocess, sys, time

program, work, rounds = sys.argv[1], pathlib.Path(sys.argv[2]), int(sys.argv[3])

columns, rows, length = 200, 124, 4.0
circles = [(1.0, length * j / rows) for j in range(rows + 1)]
circles += [(0.97, length * (rows - j) / rows) for j in range(rows + 1)]
with open(work / "pipe.off", "w") as out:
    out.write(f"OFF\n{columns * len(circles)} {2 * columns * len(circles)} 0\n")
    for radius, z in circles:
        for i in range(columns):
            angle = 2 * math.pi * i / columns
            out.write(f"{radius * math.cos(angle)!r} {radius * math.sin(angle)!r} {z!r}\n")
    for j in range(len(circles)):
        below, above = j * columns, (j + 1) % len(circles) * columns
        for i in range(columns):
            k = (i + 1) % columns
            out.write(f"3 {below + i} {below + k} {above + k}\n3 {below + i} {above + k} {above + i}\n")


def cpu_of(process):
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def run(atoms, reason, size):
    start = time.monotonic()
    process = subprocess.Popen(
        [program, "build", work / "pipe.off", "-o", work / "pipe.data", "--atoms", atoms, "--threads", "1"],
        stderr=subprocess.PIPE, stdout=subprocess.DEVNULL, text=True)  # fmt: skip
    first, last = None, ""
    for line in process.stderr:
        if first is None and reason in line:
            first = (cpu_of(process), time.monotonic() - start)
        last = line if line.strip() else last
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != 6 or first is None or size not in last:
        sys.exit(f"not refused as it should be: {last}")
    return *first, usage.ru_utime + usage.ru_stime, time.monotonic() - start, last


runs = [run("2000", "too small", "next size") for _ in range(rounds)]
cpu_first, clock_first, cpu, clock = (statistics.median(r[k] for r in runs) for k in range(4))
print(f"first reason: {cpu_first:.2f} s of CPU, after {clock_first:.2f} s")
print(f"next size:    {cpu:.2f} s of CPU, after {clock:.2f} s")
print(runs[-1][4].strip())
fits = [run("fit", "looking for", "fit builds up to") for _ in range(rounds)]
cpu, clock = (statistics.median(r[k] for r in fits) for k in (2, 3))
print(f"fit:          {cpu:.2f} s of CPU, after {clock:.2f} s")
print(fits[-1][4].strip())
PYTHON
