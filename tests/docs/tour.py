#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Runs the commands of preprocessor/doc/tour.md one after the other, as a reader would, but shorter.

    tour.py PAGE SOURCE_FOLDER WORK_FOLDER PROGRAM_FOLDERS...

What the page shows as output must be in what the commands before it print. Blocks marked "not by the test" install and
build, which has been done; one marked "needs ase" is left out where there is no ASE.
"""

import os
import pathlib
import re
import shutil
import subprocess
import sys

# So that it takes seconds, not minutes.
SHORTER = [("--atoms 2400", "--atoms 2400 --quality draft"), ("--atoms 1000", "--atoms 600 --quality draft"),
           ("-var steps 2000", "-var steps 50 -var pixels 300"), ("-var steps 5000", "-var steps 200 -var pixels 300"),
           ("-var temperature", "-var steps 100 -var pixels 0 -var temperature")]


def main():
    page, source, work, *folders = sys.argv[1:]
    work = pathlib.Path(work)
    shutil.rmtree(work, ignore_errors=True)
    work.mkdir(parents=True)
    for folder in ("examples", "scripts"):
        (work / folder).symlink_to(pathlib.Path(source).resolve() / folder)
    environment = os.environ | {
        "PATH": os.pathsep.join([*map(os.path.abspath, folders), os.environ["PATH"]]), "OMP_NUM_THREADS": "1",
        "OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
        "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe",
        "OMPI_MCA_btl_vader_single_copy_mechanism": "none", "OMPI_MCA_mpi_yield_when_idle": "1"}
    with_ase = subprocess.run(["/usr/bin/python3", "-c", "import ase"], capture_output=True, check=False).returncode == 0

    text = open(page).read()
    for before, after in SHORTER:
        if before not in text:
            sys.exit(f"{page} no longer says '{before}': bring {sys.argv[0]} up to date")
    printed, ran = "", 0
    for mark, kind, block in re.findall(r"(<!-- [^\n]* -->\n)?```(\w+)\n(.*?)```", text, re.S):
        if kind == "text":
            for line in block.splitlines():
                if line not in printed:
                    sys.exit(f"the page shows '{line}', but the commands printed\n{printed}")
        elif "not by the test" in mark or ("needs ase" in mark and not with_ase):
            continue
        else:
            for before, after in SHORTER:
                block = block.replace(before, after)
            done = subprocess.run(["bash", "-euo", "pipefail", "-c", block], cwd=work, env=environment, text=True,
                                  stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            printed, ran = done.stdout, ran + 1
            if done.returncode != 0:
                sys.exit(f"exit {done.returncode} of\n{block}\n{printed[-3000:]}")
    print(f"{ran} blocks of commands ran")


if __name__ == "__main__":
    main()
