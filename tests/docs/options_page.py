#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Holds preprocessor/doc/options.md to what the program's --help prints: the same options with the same defaults.

    options_page.py PROGRAM PAGE
"""

import re
import subprocess
import sys


def helped(program, path):
    """Options of a subcommand with their defaults, and the names of its own subcommands."""
    text = subprocess.run([program, *path, "--help"], capture_output=True, text=True, check=True).stdout
    text = re.sub(r"\x1b\[[0-9;]*m", "", text)
    options, subcommands, listing = {}, [], False
    for line in text.splitlines():
        if re.match(r"\S", line):
            listing = line == "Subcommands:"
        elif listing and (name := re.match(r"  ([a-z][a-z-]*)", line)):
            subcommands.append(name[1])
        elif option := re.match(r" +((?:-\w,)?--[a-z-]+|-\w)(.*)", line):
            value = re.match(r" (?:[A-Z]+(?::(?:\{[^}]*\}|[A-Z]+(?: in \[[^\]]*\])?))?)=(\S+)", option[2])
            default = value[1].strip("[]").replace(",", " ") if value else None
            options[tuple(option[1].split(","))] = default
    options.pop(("-h", "--help"), None)
    return options, subcommands


def documented(page):
    """The same from the page, by heading."""
    sections, section = {}, None
    for line in open(page):
        if line.startswith("## "):
            section = sections.setdefault(line[3:].strip(), {})
        elif row := re.match(r"\| (`-.*?) \| (.*?) \|", line):
            section[tuple(re.findall(r"`(--?[a-z-]+)", row[1]))] = row[2].strip() or None
    return sections


def compare(program, sections, path, inherited, complaints):
    heading = " ".join(["nanocarbon", *path])
    if heading not in sections:
        complaints.append(f"the page has no section '## {heading}'")
        return set()
    options, subcommands = helped(program, path)
    own = sections[heading]
    known = {**inherited, **own}
    for names, default in options.items():
        if names not in known:
            complaints.append(f"{heading}: {', '.join(names)} is missing from the page")
        elif default is not None and default != known[names]:
            complaints.append(f"{heading}: the default of {names[-1]} is {default}, not {known[names]}")
    seen = set(options)
    for name in subcommands:
        # What a section says of its own is common to the subcommands below it.
        seen |= compare(program, sections, [*path, name], {**inherited, **own} if path else {}, complaints)
    for names in set(own) - seen - {("-h", "--help")}:
        complaints.append(f"{heading}: the page has {', '.join(names)}, the program has not")
    sections[heading] = None
    return seen


def main():
    program, page = sys.argv[1:]
    sections, complaints = documented(page), []
    compare(program, sections, [], {}, complaints)
    complaints += [f"the page has a section '{name}', the program has no such subcommand"
                   for name, section in sections.items() if section is not None]
    if complaints:
        sys.exit("\n".join([*complaints, "Please bring the page preprocessor/doc/options.md up to date."]))


if __name__ == "__main__":
    main()
