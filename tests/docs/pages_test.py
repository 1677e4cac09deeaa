#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds the completion of bash and the manual pages to what the program's --help prints.

    pages_test.py PROGRAM FOLDER_OF_PAGES MANUAL_PAGE...
"""

import gzip
import pathlib
import re
import shutil
import subprocess
import sys

from options_page import helped


def complete(script, *words):
    """What bash offers at the end of a line; the last word is the one begun, perhaps empty."""
    code = 'source "$1"; shift; COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1)); _nanocarbon; printf "%s\\n" "${COMPREPLY[@]}"'
    done = subprocess.run(["bash", "-uc", code, "bash", script, "nanocarbon", *words],
                          capture_output=True, text=True, check=True)
    return set(done.stdout.split())


def compare(program, script, path, pages, complaints):
    options, subcommands = helped(program, path)
    command = " ".join(["nanocarbon", *path])
    offered = complete(script, *path, "-")
    page = pages["-".join(["nanocarbon", *path[:1]])]
    if "--help" not in offered:
        complaints.append(f"{command}: --help is not offered")
    for name in sorted(name for names in options for name in names):
        if name not in offered:
            complaints.append(f"{command}: {name} is not offered")
        if name.replace("-", "\\-") not in page:
            complaints.append(f"{command}: the manual page lacks {name}")
    if complete(script, *path, "") != set(subcommands):
        complaints.append(f"{command}: offered {complete(script, *path, '')}, the subcommands are {subcommands}")
    text = subprocess.run([program, *path, "--help"], capture_output=True, text=True, check=True).stdout
    for name, choices in re.findall(r"(--[a-z-]+) [A-Z]+:\{([^}]*)\}", re.sub(r"\x1b\[[0-9;]*m", "", text)):
        if complete(script, *path, name, "") != set(choices.split(",")):
            complaints.append(f"{command} {name}: offered {complete(script, *path, name, '')}, there are {choices}")
    for name in subcommands:
        compare(program, script, [*path, name], pages, complaints)


def main():
    program, folder, *others = sys.argv[1:]
    folder, complaints = pathlib.Path(folder), []
    pages = {page.name.removesuffix(".1.gz"): gzip.open(page, "rt").read() for page in (folder / "man1").glob("*.1.gz")}
    compare(program, folder / "nanocarbon.bash", [], pages, complaints)
    if complete(folder / "nanocarbon.bash", "build", "--quality", "dr") != {"draft"}:
        complaints.append("nanocarbon build --quality dr is not completed to draft")
    texts = pages | {other: pathlib.Path(other).read_text() for other in others}
    if shutil.which("groff"):
        for name, text in texts.items():
            done = subprocess.run(["groff", "-man", "-ww", "-Tutf8", "-z"], input=text, capture_output=True, text=True,
                                  check=False)
            if done.stderr or done.returncode != 0:
                complaints.append(f"{name}: {done.stderr}")
    if complaints:
        sys.exit("\n".join(complaints))
    print(f"{len(texts)} pages")


if __name__ == "__main__":
    main()
