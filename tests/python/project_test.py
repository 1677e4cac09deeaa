#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What pip's backend makes of pyproject.toml, without building: project_test.py SOURCE VERSION"""

import os
import pathlib
import sys
import tempfile

from scikit_build_core import build


def main():
    os.chdir(sys.argv[1])
    with tempfile.TemporaryDirectory() as folder:
        made = pathlib.Path(folder) / build.prepare_metadata_for_build_wheel(folder)
        metadata = (made / "METADATA").read_text(encoding="utf-8")
    for line in ("Name: nanocarbon-sp2", f"Version: {sys.argv[2]}", "Requires-Dist: numpy"):
        if line not in metadata.splitlines():
            sys.exit(f"the metadata lack '{line}':\n{metadata}")


if __name__ == "__main__":
    main()
