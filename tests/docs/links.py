#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Follows every link within the project: files that it leads to exist, and so do headings and other anchors.

    links.py REPOSITORY       Markdown pages, as GitHub shows them
    links.py --site FOLDER    the pages of the site

Links to other sites are not followed: tests need no network.
"""

import html.parser
import os
import pathlib
import re
import sys
import urllib.parse


def is_elsewhere(link):
    return re.match(r"[a-zA-Z][a-zA-Z+.-]*:", link) is not None


# ---- Markdown ----

def without_code(text):
    """Code is shown as it is, so links in it are none. Lines stay lines."""
    lines, fence = [], None
    for line in text.split("\n"):
        mark = re.match(r" {0,3}(```+|~~~+)", line)
        if mark and fence is None:
            fence = mark[1]
            line = ""
        elif fence is not None:
            if mark and mark[1].startswith(fence):
                fence = None
            line = ""
        elif re.match(r"( {4}|\t)", line) and (not lines or not lines[-1].strip() or lines[-1] == "\0"):
            line = "\0"  # an indented block goes on as long as lines are indented
        lines.append(line)
    return re.sub(r"(`+)(?!`).*?(?<!`)\1(?!`)", "", "\n".join(lines).replace("\0", ""), flags=re.S)


def headings(text):
    """The anchors that GitHub gives a page's headings."""
    taken, result, fence = {}, set(), False
    for line in text.split("\n"):
        if line.startswith(("```", "~~~")):
            fence = not fence
        heading = re.match(r"#{1,6} +(.*?) *#*$", line)
        if fence or not heading:
            continue
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading[1]).replace("`", "").replace("*", "")
        name = re.sub(r"[^\w\- ]", "", words.lower()).replace(" ", "-")
        number = taken.get(name, -1) + 1
        taken[name] = number
        result.add(f"{name}-{number}" if number else name)
    return result


def pages_of(repository):
    folders = [repository, *(repository / name for name in ("examples", "lammps-plugin", "preprocessor", "tests", "scripts"))]
    return [page for folder in folders for page in
            (folder.glob("*.md") if folder == repository else folder.rglob("*.md"))]


def markdown_complaints(repository):
    complaints, followed = [], 0
    for page in pages_of(repository):
        text = page.read_text(encoding="utf-8")
        for link in re.findall(r"\]\(\s*<?([^)\s>]+)[^)]*\)", without_code(text)):
            if is_elsewhere(link):
                continue
            followed += 1
            path, _, anchor = link.partition("#")
            target = (page.parent / urllib.parse.unquote(path)).resolve() if path else page
            if repository not in [target, *target.parents]:
                complaints.append(f"{page}: {link} leads out of the repository")
            elif not target.exists():
                complaints.append(f"{page}: {link} leads nowhere")
            elif anchor and (target.suffix != ".md" or anchor not in headings(target.read_text(encoding="utf-8"))):
                complaints.append(f"{page}: {link}: there is no such heading")
    return complaints, followed


# ---- HTML ----

class Page(html.parser.HTMLParser):
    def __init__(self, text):
        super().__init__()
        self.links, self.anchors, self.by_doxygen = [], set(), False
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        said = dict(attributes)
        if tag == "meta" and said.get("name") == "generator":
            self.by_doxygen = "Doxygen" in (said.get("content") or "")
        for name, value in attributes:
            if name in ("href", "src") and value:
                self.links.append(value)
            elif name in ("id", "name") and value:
                self.anchors.add(value)


def site_complaints(folder):
    root = os.path.abspath(folder)
    files = {os.path.join(at, name) for at, _, names in os.walk(root) for name in names}
    pages = {}
    for path in files:
        if path.endswith(".html"):
            with open(path, encoding="utf-8", errors="replace") as text:
                pages[path] = Page(text.read())
    complaints, followed = [], 0
    for path, page in pages.items():
        for link in page.links:
            if is_elsewhere(link) or link.startswith("//"):
                continue
            followed += 1
            file, _, anchor = urllib.parse.unquote(link).partition("#")
            file = file.partition("?")[0]
            target = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if target not in files and os.path.join(target, "index.html") in files:
                target = os.path.join(target, "index.html")
            if target not in files:
                complaints.append(f"{path}: {link} leads nowhere")
            elif target == path and page.by_doxygen:
                pass  # its summary leads to private classes, which the page leaves out
            elif anchor and target in pages and anchor not in pages[target].anchors:
                complaints.append(f"{path}: {link}: there is no such anchor")
    if os.path.join(root, "index.html") not in pages:
        complaints.append(f"{folder}: there is no index.html")
    return complaints, followed


def main():
    if sys.argv[1] == "--site":
        complaints, followed = site_complaints(sys.argv[2])
    else:
        complaints, followed = markdown_complaints(pathlib.Path(sys.argv[1]).resolve())
    if complaints:
        sys.exit("\n".join(complaints))
    if followed == 0:
        sys.exit("no link was found")
    print(f"{followed} links lead somewhere")


if __name__ == "__main__":
    main()
