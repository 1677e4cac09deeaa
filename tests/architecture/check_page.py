#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds preprocessor/doc/architecture.md to the source: every path that it names exists, and its table of rooms has every
room with its namespace.

    check_page.py REPOSITORY
"""

import pathlib
import re
import sys

PLACEHOLDER = re.compile(r"NAME|ROOM|SUBCOMMAND")


def named_paths(page):
    """Words in backticks that look like paths, without what is below a placeholder."""
    for word in re.findall(r"`([^`\s]+)`", page):
        if "::" in word or "<" in word:
            continue
        if PLACEHOLDER.search(word):
            word = word[: PLACEHOLDER.search(word).start()].rpartition("/")[0]
        if "/" in word.strip("/") or re.search(r"\.(h|cpp|py|sh|md|cmake|txt)$", word):
            yield word.rstrip("/")


def exists(repository, path):
    for base in (repository, repository / "preprocessor", repository / "preprocessor" / "nanocarbon"):
        if (base / path).exists() or (base / f"{path}.h").exists() or (base / f"{path}.cpp").exists():
            return True
    return False


def rooms_of(repository):
    rooms = {}
    root = repository / "preprocessor" / "nanocarbon"
    for cmake in root.rglob("CMakeLists.txt"):
        target = re.search(r"nanocarbon_room\(\s*(\w+)", cmake.read_text()).group(1)
        rooms[str(cmake.parent.relative_to(root))] = "(itself)" if target == "core" else f"`{target.split('_')[0]}`"
    return rooms


def main():
    repository = pathlib.Path(sys.argv[1])
    page = (repository / "preprocessor" / "doc" / "architecture.md").read_text()
    paths = sorted(set(named_paths(page)))
    faults = [f"the page names {p}, which does not exist" for p in paths
              if p not in ("rebo/opt", "airebo/opt") and not exists(repository, p)]
    listed = dict(re.findall(r"^\| `([\w/]+)` \| (\S+) \|", page, re.M))
    rooms = rooms_of(repository)
    faults += [f"{r} is not in the table of rooms" for r in sorted(set(rooms) - set(listed))]
    faults += [f"the table of rooms has {r}, which is no room" for r in sorted(set(listed) - set(rooms))]
    faults += [f"the table gives {listed[r]} as the namespace of {r}; it is {rooms[r]}"
               for r in sorted(set(rooms) & set(listed)) if listed[r] != rooms[r]]
    print(f"{len(paths)} paths, {len(rooms)} rooms")
    if len(paths) < 60:
        faults.append("hardly any paths were found: has the page another form?")
    if faults:
        sys.exit("\n".join(faults))


if __name__ == "__main__":
    main()
