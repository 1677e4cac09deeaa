#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes the manual pages and the completion of bash from the page of options, which a test holds to the program.

    make_pages.py OPTIONS_PAGE README VERSION FOLDER

Writes FOLDER/man1/nanocarbon.1.gz, a page for each of its subcommands, and FOLDER/nanocarbon.bash. What is below a
subcommand (nanocarbon make tube) is a section of that subcommand's page.
"""

import dataclasses
import gzip
import pathlib
import re
import sys

SUMMARIES = {
    "nanocarbon": "carbon molecules from triangle meshes, ready for LAMMPS",
    "nanocarbon inspect": "tell what a mesh is, and every reason why it cannot be used",
    "nanocarbon build": "make a carbon molecule from a mesh",
    "nanocarbon energy": "energy and forces of a molecule by REBO2 or AIREBO",
    "nanocarbon analyse": "tell what structures and trajectories of carbon are made of",
    "nanocarbon make": "make known carbon structures, and shapes as meshes",
}


@dataclasses.dataclass
class Option:
    spellings: list  # as on the page: ["-o FILE", "--output FILE"]
    default: str
    what: str

    def names(self):
        return [spelling.split()[0] for spelling in self.spellings]

    def value(self):
        """What the option takes, as on the page (FILE, NAME, X); empty for a flag."""
        return " ".join(self.spellings[-1].split()[1:])

    def choices(self):
        return re.findall(r"`([a-z0-9-]+)`", self.what) if self.value() == "NAME" else []


@dataclasses.dataclass
class Section:
    name: str
    body: list = dataclasses.field(default_factory=list)  # paragraphs, commands and options, in order

    def options(self):
        return [part for part in self.body if isinstance(part, Option)]


@dataclasses.dataclass
class Command:  # an indented line
    text: str


def parse(page):
    sections, paragraph = [], []

    def end_paragraph():
        if paragraph and sections:
            sections[-1].body.append(" ".join(paragraph))
        paragraph.clear()

    for line in page.read_text().splitlines():
        if line.startswith("## "):
            end_paragraph()
            sections.append(Section(line[3:].strip()))
        elif line.startswith("|"):
            end_paragraph()
            cells = [cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]]
            if cells[0].startswith("`-"):
                sections[-1].body.append(Option(re.findall(r"`(-[^`]*)`", cells[0]), cells[1], cells[2]))
        elif line.startswith("    "):
            end_paragraph()
            sections[-1].body.append(Command(line.strip()))
        elif line.strip():
            paragraph.append(line.strip())
        else:
            end_paragraph()
    end_paragraph()
    return sections


def exit_codes(readme):
    table = re.search(r"^## Exit codes\n(.*?)^## ", readme.read_text(), re.M | re.S)[1]
    codes = re.findall(r"^\| (\d+) \| (.*) \|$", table, re.M)
    if not codes:
        sys.exit(f"{readme}: no table of exit codes")
    return codes


def roff(text, bold=False):
    """Plain text, and the page's marks for code and links, as roff."""
    # A link leads nowhere from a manual page: the file is named where the text does not do so.
    text = re.sub(r"\[([^]]*)\]\((?:[^)]*/)?([^)#]*)[^)]*\)",
                  lambda link: link[1] if re.search(r"[/.]", link[1]) else f"{link[1]} ({link[2]})", text)
    parts = []
    for k, part in enumerate(re.split(r"`([^`]*)`", text)):
        part = part.replace("\\", "\\e").replace("-", "\\-")
        parts.append(f"\\fB{part}\\fR" if part and (k % 2 == 1 or bold) else part)
    line = "".join(parts)
    return "\\&" + line if line.startswith((".", "'")) else line


def body_of(section):
    lines = []
    for part in section.body:
        if isinstance(part, Command):
            lines += [".PP", ".RS 4", roff(part.text, bold=True), ".RE"]
        elif isinstance(part, Option):
            lines += [".TP", ", ".join(roff(spelling, bold=True) for spelling in part.spellings), roff(part.what)]
            if part.default:
                lines[-1] += f" (default: {roff(part.default)})"
        else:
            lines += [".PP", roff(part)]
    return lines


def man_page(name, sections, codes, version):
    title = name.replace(" ", "-")
    lines = [f'.TH {title.upper()} 1 "" "nanocarbon {version}" "User Commands"', ".SH NAME",
             f"{title} \\- {roff(SUMMARIES[name])}"]
    if name == "nanocarbon":
        lines += [".SH SYNOPSIS", roff("nanocarbon SUBCOMMAND [OPTIONS]", bold=True), ".SH SUBCOMMANDS"]
        for other, summary in SUMMARIES.items():
            if other != name:
                lines += [".TP", roff(other.removeprefix("nanocarbon "), bold=True), roff(summary)]
    for section in sections:
        lines += [f'.SH "{roff(section.name)}"' if section.name != name else
                  ".SH OPTIONS" if name == "nanocarbon" else ".SH DESCRIPTION", *body_of(section)]
    lines += [".SH EXIT STATUS"]
    for code, meaning in codes:
        lines += [".TP", code, roff(meaning)]
    others = [other.replace(" ", "-") for other in SUMMARIES if other != name] + ["lmp-nanocarbon"]
    lines += [".SH SEE ALSO", *(f".BR {other} (1)," for other in others[:-1]), f".BR {others[-1]} (1)"]
    return "\n".join(lines) + "\n"


def completion(sections):
    """A function for bash that knows each subcommand's options, and the words that an option takes."""
    names = [section.name for section in sections]
    cases, values = [], []
    for section in sections:
        path = section.name.removeprefix("nanocarbon")
        below = [name.removeprefix(section.name + " ") for name in names if name.startswith(section.name + " ")]
        below = [name for name in below if " " not in name]
        # What a section says of its own is common to those below it, but for the program's own.
        above = [s for s in sections if s.name != "nanocarbon" and section.name.startswith(s.name + " ")]
        options = [option for s in [*above, section] for option in s.options()]
        flags = [name for option in options for name in option.names()]
        if path:
            flags += ["-h", "--help"]
        cases.append(f'    "{path}") words="{" ".join(below)}" options="{" ".join(dict.fromkeys(flags))}" ;;')
        for option in options:
            for name in option.names():
                if option.choices():
                    values.append(f'    "{path} {name}") words="{" ".join(option.choices())}" options= ;;')
                elif option.value():
                    values.append(f'    "{path} {name}") return ;;  # {option.value()}')
    known = "|".join(f'"{name.removeprefix("nanocarbon")}"' for name in names if name != "nanocarbon")
    return f"""# Completion of nanocarbon's command line for bash, made from the page of its options.
_nanocarbon() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} subcommand="" words="" options="" i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    case "$subcommand ${{COMP_WORDS[i]}}" in
    {known}) subcommand+=" ${{COMP_WORDS[i]}}" ;;
    esac
  done
  COMPREPLY=()
  case "$subcommand" in
{chr(10).join(cases)}
  esac
  case "$subcommand $before" in
{chr(10).join(values)}
  esac
  if [[ $word == -* ]]; then words=$options; fi
  COMPREPLY=($(compgen -W "$words" -- "$word"))
}}
# Where nothing fits, the names of files.
complete -o default -F _nanocarbon nanocarbon
"""


def main():
    page, readme, version, folder = sys.argv[1:]
    sections, codes, folder = parse(pathlib.Path(page)), exit_codes(pathlib.Path(readme)), pathlib.Path(folder)
    pages = {}
    for section in sections:
        name = " ".join(section.name.split()[:2])
        if name not in SUMMARIES:
            sys.exit(f"{page}: '{name}' is a new subcommand: give it a summary in {sys.argv[0]}")
        pages.setdefault(name, []).append(section)
    (folder / "man1").mkdir(parents=True, exist_ok=True)
    for name, parts in pages.items():
        text = man_page(name, parts, codes, version)
        with open(folder / "man1" / f"{name.replace(' ', '-')}.1.gz", "wb") as file:
            with gzip.GzipFile(filename="", fileobj=file, mode="wb", mtime=0) as packed:  # the same bytes every time
                packed.write(text.encode())
    (folder / "nanocarbon.bash").write_text(completion(sections))


if __name__ == "__main__":
    main()
