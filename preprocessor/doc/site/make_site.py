#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Makes one site of the project's pages: Markdown, the LAMMPS pages, the library's reference and the gallery.

    make_site.py SOURCE FOLDER [--reference HTML] [--gallery FOLDER]

Pages keep their places: preprocessor/doc/tour.md becomes preprocessor/doc/tour.html, a README.md its folder's index.html.
Files that pages link to are copied. Needs markdown-it and docutils (Debian: python3-markdown-it, python3-docutils).
"""

import argparse
import html
import json
import os
import pathlib
import re
import shutil
import sys

from markdown_it import MarkdownIt

import lammps_page

HERE = pathlib.Path(__file__).resolve().parent
FOLDERS = ["examples", "lammps-plugin", "preprocessor"]
FRAME = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{root}site.css">
</head>
<body>
<nav><a class="name" href="{root}index.html">nanocarbon</a>
{navigation}
</nav>
<main>
{body}
</main>
</body>
</html>
"""


def slug(text, taken):
    """What GitHub makes of a heading's text."""
    name = re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")
    number = taken.get(name, -1) + 1
    taken[name] = number
    return f"{name}-{number}" if number else name


def place(page):
    """Where a page of the source goes, relative to the site."""
    return page.with_name("index.html") if page.name == "README.md" else page.with_suffix(".html")


class Site:
    def __init__(self, source, folder):
        self.source, self.folder = source, folder
        self.pages = [p.relative_to(source) for p in sorted(source.glob("*.md"))]
        for name in FOLDERS:
            self.pages += [p.relative_to(source) for ending in ("md", "rst") for p in sorted((source / name).rglob(f"*.{ending}"))]
        self.complaints, self.navigation, self.written = [], [], []

    def target(self, page, link):
        """A link of a page, as it is in the site; files that it leads to come along."""
        if re.match(r"[a-z]+:", link) or link.startswith("#"):
            return link
        path, _, anchor = link.partition("#")
        file = pathlib.Path(os.path.normpath(page.parent / path))
        if (self.source / file).is_dir():
            file = file / "README.md"
        if not (self.source / file).is_file():
            self.complaints.append(f"{page}: {link} leads nowhere")
            return link
        if file in self.pages:
            file = place(file)
        else:
            (self.folder / file).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(self.source / file, self.folder / file)
        return os.path.relpath(file, page.parent) + (f"#{anchor}" if anchor else "")

    def markdown(self, page):
        parser = MarkdownIt("commonmark", {"html": True}).enable("table")
        tokens = parser.parse((self.source / page).read_text(encoding="utf-8"))
        taken, title = {}, ""
        for token, after in zip(tokens, [*tokens[1:], None]):
            if token.type == "heading_open":
                text = "".join(part.content for part in after.children if part.type in ("text", "code_inline"))
                title = title or text
                token.attrSet("id", slug(text, taken))
            for part in token.children or []:
                for name in ("href", "src"):
                    if name in part.attrs:
                        part.attrSet(name, self.target(page, str(part.attrs[name])))
        return title or page.stem, parser.renderer.render(tokens, parser.options, {})

    def add(self, at, title, body):
        root = os.path.relpath(".", at.parent) + "/"
        links = [f'<a href="{html.escape(root + str(to))}"{" class=here" if to == at else ""}>{html.escape(name)}</a>'
                 if to else f"<span>{html.escape(name)}</span>" for name, to in self.navigation]
        (self.folder / at).parent.mkdir(parents=True, exist_ok=True)
        (self.folder / at).write_text(FRAME.format(title=html.escape(title), root=root, navigation="\n".join(links), body=body),
                                      encoding="utf-8")
        self.written.append(at)

    def start(self, reference, gallery):
        """What the side of every page leads to: the README's table of pages, and what else there is."""
        table = re.search(r"^## Where to start\n(.*?)^In short", (self.source / "README.md").read_text(encoding="utf-8"), re.M | re.S)
        if not table:
            sys.exit("make_site: README.md has no table under 'Where to start'")
        for name, link in re.findall(r"^\| \[([^]]*)\]\(([^)#]*)", table[1], re.M):
            self.navigation.append((name, place(pathlib.Path(link))))
        if gallery:
            self.navigation.append(("Gallery", pathlib.Path("gallery/index.html")))
        if reference:
            self.navigation.append(("The library's reference", pathlib.Path("reference/index.html")))
        self.navigation += [("Contributing", place(pathlib.Path("CONTRIBUTING.md"))), ("Changes", place(pathlib.Path("CHANGELOG.md"))),
                            ("In LAMMPS", None)]
        self.navigation += [(p.stem, place(p)) for p in self.pages if p.suffix == ".rst"]

    def add_gallery(self, gallery):
        shutil.copytree(gallery, self.folder / "gallery", dirs_exist_ok=True)
        cards = []
        for item in json.loads((gallery / "gallery.json").read_text(encoding="utf-8")):
            picture = f'<img src="{item["picture"]}" alt="{html.escape(item["title"])}" loading="lazy">' if item["picture"] else ""
            cards.append(f'<figure><a href="{item["page"]}">{picture}<figcaption>{html.escape(item["title"])}</figcaption></a>'
                         f'<code>{html.escape(item["command"])}</code></figure>')
        self.add(pathlib.Path("gallery/index.html"), "Gallery",
                 "<h1>Gallery</h1><p>What <code>examples/gallery/make.py</code> makes. Each picture leads to a page of the molecule in "
                 "3D, as <code>--page</code> writes it.</p><div class=gallery>" + "\n".join(cards) + "</div>")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--reference", type=pathlib.Path, help="Doxygen's folder html")
    parser.add_argument("--gallery", type=pathlib.Path, help="what examples/gallery/make.py made")
    args = parser.parse_args()
    shutil.rmtree(args.folder, ignore_errors=True)
    args.folder.mkdir(parents=True)
    shutil.copyfile(HERE / "site.css", args.folder / "site.css")
    site = Site(args.source.resolve(), args.folder)
    site.start(args.reference, args.gallery)
    for page in site.pages:
        if page.suffix == ".md":
            title, body = site.markdown(page)
        else:
            title, body, complaints = lammps_page.convert(site.source / page, {p.stem for p in site.pages if p.suffix == ".rst"})
            site.complaints += [f"{page}: {complaint}" for complaint in complaints]
        site.add(place(page), title, body)
    if args.gallery:
        site.add_gallery(args.gallery)
    if args.reference:
        shutil.copytree(args.reference, args.folder / "reference")
    if site.complaints:
        sys.exit("\n".join(site.complaints))
    print(f"{len(site.written)} pages: {args.folder / 'index.html'}")


if __name__ == "__main__":
    main()
