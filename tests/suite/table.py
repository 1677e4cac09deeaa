# SPDX-License-Identifier: GPL-2.0-or-later
"""The rows of the suite as TSV, a number a column, as Markdown, short enough to read, and as a page with links."""

import html

# Keys of a row, in the order of the TSV's columns.
COLUMNS = ["mesh", "atoms_asked", "atoms", "meV_above_graphene", "pentagons", "heptagons", "other_rings",
           "percent_defects", "bond_min", "bond_max", "bond_cv", "angle_sd", "distance_mean", "distance_max",
           "cpu_seconds", "lammps_minus_own_meV", "lammps_intact", "from_rest", "at_600K", "refusal", "failure", "page"]


def number(row, key, digits):
    return f"{row[key]:.{digits}f}" if key in row else ""


def both(row, first, second, digits=0, between="/"):
    return number(row, first, digits) + between + number(row, second, digits) if first in row else ""


def verdict(row):
    said = [row[key] for key in ("from_rest", "at_600K") if key in row]
    if said and all(word == said[0] for word in said):
        said = said[:1]
    said += [row[key] for key in ("refusal", "failure") if key in row]
    return "; ".join(said)


MARKDOWN = {
    "mesh": lambda row: row["mesh"],
    "atoms": lambda row: str(row.get("atoms", "")),
    "meV above graphene": lambda row: number(row, "meV_above_graphene", 1),
    "5/7 rings": lambda row: both(row, "pentagons", "heptagons"),
    "other": lambda row: number(row, "other_rings", 0),
    "defects, %": lambda row: number(row, "percent_defects", 1),
    "bonds, Å": lambda row: both(row, "bond_min", "bond_max", 3, "–"),
    "bond cv": lambda row: number(row, "bond_cv", 4),
    "angle sd, °": lambda row: number(row, "angle_sd", 2),
    "distance, Å": lambda row: number(row, "distance_mean", 2),
    "CPU s": lambda row: number(row, "cpu_seconds", 0),
    "LAMMPS − own, meV": lambda row: number(row, "lammps_minus_own_meV", 4),
    "verdict, from rest; at 600 K": verdict,
}


STYLE = """body { font: 14px/1.45 system-ui, sans-serif; color: #1c2430; margin: 24px; }
table { border-collapse: collapse; } th, td { padding: 3px 10px; border-bottom: 1px solid #d8dee6; text-align: left; }
td { vertical-align: top; } .bad { color: #7c1d13; background: #fde4e1; } .good { color: #145523; } code { color: #5d6b7c; }"""


def write_index(folder, rows, command):
    """A page with the table, where each mesh leads to the page of its molecule."""
    titles = list(MARKDOWN)
    lines = ["<!DOCTYPE html>", '<html lang="en"><head><meta charset="utf-8"><title>Suite</title>',
             f"<style>{STYLE}</style></head><body><h1>Suite</h1>",
             f"<p><code>tests/suite/run.py {html.escape(command)}</code></p><table>",
             "<tr>" + "".join(f"<th>{html.escape(title)}</th>" for title in titles) + "</tr>"]
    for row in rows:
        cells = [html.escape(cell(row)) for cell in MARKDOWN.values()]
        if "page" in row:
            cells[0] = f'<a href="{html.escape(row["page"])}">{cells[0]}</a>'
        said = [row[key] for key in ("from_rest", "at_600K") if key in row]
        good = "failure" not in row and all(word == "intact" for word in said)
        lines.append("<tr>" + "".join(f"<td>{cell}</td>" for cell in cells[:-1]) +
                     f'<td class="{"good" if good else "bad"}">{cells[-1]}</td></tr>')
    (folder / "index.html").write_text("\n".join([*lines, "</table></body></html>"]) + "\n", encoding="utf-8")


def write_tables(folder, rows, command):
    write_index(folder, rows, command)
    tsv = ["\t".join(COLUMNS)] + ["\t".join(str(row.get(key, "")) for key in COLUMNS) for row in rows]
    (folder / "suite.tsv").write_text("\n".join(tsv) + "\n")
    shown = {title: [cell(row) for row in rows] for title, cell in MARKDOWN.items()}
    shown = {title: cells for title, cells in shown.items() if any(cells)}
    lines = ["| " + " | ".join(shown) + " |", "|" + "---|" * len(shown)]
    lines += ["| " + " | ".join(cells) + " |" for cells in zip(*shown.values())]
    (folder / "suite.md").write_text("\n".join(lines) + "\n")
