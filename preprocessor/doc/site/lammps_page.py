# SPDX-License-Identifier: GPL-2.0-or-later
"""Pages written as LAMMPS's own are: its roles lead to LAMMPS's manual, or to our page where there is one."""

import io
import re

from docutils import core, nodes
from docutils.parsers.rst import Directive, directives, roles

MANUAL = "https://docs.lammps.org/"


class Index(Directive):
    """An entry of Sphinx's index, which a single page has none of."""

    required_arguments, final_argument_whitespace = 1, True

    def run(self):
        return []


def parts_of(text):
    match = re.fullmatch(r"(.*?)\s*<(.*)>", text, re.S)
    return (match[1], match[2]) if match else (text, text)


def convert(file, own):
    """Title, HTML and what docutils complains of. `own`: names of our pages."""

    def doc(_name, rawtext, text, _line, _inliner, _options=None, _content=None):
        label, page = parts_of(text)
        return [nodes.reference(rawtext, label, refuri=f"{page}.html" if page in own else f"{MANUAL}{page}.html")], []

    def ref(_name, rawtext, text, _line, _inliner, _options=None, _content=None):
        label, name = parts_of(text)
        return [nodes.reference(rawtext, label, refid=nodes.make_id(name))], []

    roles.register_local_role("doc", doc)
    roles.register_local_role("ref", ref)
    directives.register_directive("index", Index)
    complaints = io.StringIO()
    parts = core.publish_parts(file.read_text(encoding="utf-8"), writer_name="html5", settings_overrides={
        "syntax_highlight": "none", "warning_stream": complaints, "halt_level": 5, "embed_stylesheet": False,
        "stylesheet_path": "", "math_output": "MathML", "initial_header_level": 2, "file_insertion_enabled": False,
        "raw_enabled": False})
    return parts["title"] or file.stem, parts["html_body"], complaints.getvalue().splitlines()
