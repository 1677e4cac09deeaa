# SPDX-License-Identifier: GPL-2.0-or-later
"""The tables of README.md, from the rows of the experiments."""

import re

# What the thesis reports of a setting: whether remeshing converged, whether atoms were repelled (None: not said), and
# where it says so.
THESIS = {
    ("egea", (0, 2)): (False, True, "Fig. 5.1"),
    ("egea", (0, 5)): (True, None, "ch. 5"),
    ("egea", (10, 2)): (False, None, "ch. 5"),
    ("egea", (10, 5)): (True, False, "Fig. 5.2"),
    ("egea", (25, 5)): (True, None, "ch. 5"),
    ("bunny", (25, 5)): (None, False, "Fig. 5.4a"),
    ("fertility", (10, 5)): (None, False, "Fig. 5.4b"),
    ("rocker-arm", (25, 5)): (None, False, "Fig. 5.4c"),
}


def verdict_of(row):
    run = row.get("run")
    return run["verdict"] if run else ""


def converged(row):
    return row["report"]["remeshing"]["stopped"].startswith("converged")


def told_by_the_thesis(row):
    """What the thesis says of this row, and whether this row says the same."""
    told = THESIS.get((row["model"], row["setting"]))
    if told is None or row["short"]:  # fewer steps, and of smaller meshes
        return "", ""
    converges, repels, where = told
    words = [{True: "converged", False: "not converged"}.get(converges),
             {True: "atoms repelled", False: "no atom repelled"}.get(repels)]
    same = converges in (None, converged(row)) and repels in (None, row["run"]["repelled"] > 0)
    return ", ".join(w for w in words if w) + f" ({where})", "yes" if same else "**no**"


def markdown(columns, rows):
    lines = ["| " + " | ".join(columns) + " |", "|" + "---|" * len(columns)]
    return "\n".join(lines + ["| " + " | ".join(str(row.get(c, "")) for c in columns) + " |" for row in rows]) + "\n"


def percent(fraction):
    return f"{100 * fraction:.2f}" if fraction else "0"


def common(row):
    """The columns that most tables share."""
    cells = {"model": row["model"]}
    if "setting" in row:
        cells |= dict(zip(("p", "s"), row["setting"]))
    if "report" in row:
        report = row["report"]
        bonds, edges = report["bond_lengths"], report["triangulation_edges"]
        cells |= {"atoms": report["molecule"]["atoms"], "edges outside, %": percent(edges["fraction_outside"]),
                  "bonds short, %": percent(bonds["fraction_short"]), "long, %": percent(bonds["fraction_long"]),
                  "build s": f"{report['cpu']:.1f}"}
        if "remeshing" in report:
            cells["converged"] = (f"in {report['remeshing']['iterations']}" if converged(row) else "no")
        if "annealing" in report:
            cells["meV above graphene"] = f"{1000 * report['annealing']['above_graphene']:.0f}"
    if "run" in row:
        run = row["run"]
        since = f" (from step {run['first repelled']})" if run["repelled"] else ""
        cells |= {"verdict": run["verdict"], "broken": run["broken"], "formed": run["formed"],
                  "repelled": f"{run['repelled']}{since}",
                  "mean bond": f"{row['before']:.3f}", "after": f"{row['after']:.3f}", "MD s": f"{run['cpu']:.0f}"}
    if "failed" in row:
        cells["verdict"] = row["failed"]
    return cells


MAIN = ["atoms", "converged", "edges outside, %", "bonds short, %", "long, %", "mean bond", "after", "verdict",
        "repelled", "broken", "formed", "build s", "MD s"]


def remeshing(rows):
    cells = []
    for row in rows:
        cells.append(common(row))
        if "run" in row:
            cells[-1]["the thesis"], cells[-1]["as here"] = told_by_the_thesis(row)
    return markdown(["model", "p", "s", *MAIN, "the thesis", "as here"], cells)


def plain(rows):
    return markdown(["model", "p", "s", *MAIN], map(common, rows))


def hot(row):
    """The shared columns, and the temperature at the end of the run."""
    return common(row) | {"K": f"{row['run']['temperature']:.0f}" if "run" in row else ""}


def airebo(rows):
    return markdown(["model", "p", "s", *MAIN, "K"], map(hot, rows))


def long(rows):
    cells = [hot(row) | {"minimised after MD": told(row.get("cg after"))} for row in rows]
    return markdown(["model", "p", "s", *MAIN, "K", "minimised after MD"], cells)


def earlier(rows):
    return markdown(["model", "recipe", *MAIN], [common(row) | {"recipe": row.get("recipe", "")} for row in rows])


def by_pair(rows):
    cells = [common(row) | {"pair style": row["pair"]} for row in rows]
    return markdown(["model", "p", "s", "pair style", *MAIN], cells)


def told(result):
    """A minimisation in one cell."""
    if result is None:
        return ""
    if "failed" in result:
        return result["failed"]
    return (f"{result['verdict']}, {result['repelled']} repelled, {result['broken']} broken, "
            f"{result['formed']} formed; {result['energy']:.3f} eV/atom, mean bond {result['mean bond']:.3f}; "
            f"{result['iterations']} iterations, force {result['force']:.2g}")


def cg(rows):
    names = {"the model as it is": "cg raw", "remeshed": "cg remeshed", "remeshed, after MD": "cg after"}
    cells = [common(row) | {column: told(row.get(name)) for column, name in names.items()} for row in rows]
    return markdown(["model", "p", "s", *names], cells)


def default(rows):
    columns = ["atoms", "meV above graphene", "bonds short, %", "long, %", "mean bond", "after", "verdict", "repelled",
               "broken", "formed", "build s", "MD s", "minimised after MD"]
    cells = [common(row) | {"minimised after MD": told(row.get("cg after"))} for row in rows]
    return markdown(["model", *columns], cells)


TABLES = {"remeshing": remeshing, "visited": plain, "interval": plain, "long": long, "cg": cg, "earlier": earlier,
          "default": default, "rebo": by_pair, "airebo": airebo}


def put_into(page, tables):
    """Replaces what stands between <!-- NAME --> and <!-- end of NAME --> by the table of that name."""
    text = page.read_text()
    for name, table in tables.items():
        text, count = re.subn(f"(<!-- {name} -->\n).*?(<!-- end of {name} -->)", lambda m: m[1] + table + m[2], text,
                              flags=re.S)
        if count != 1:
            raise SystemExit(f"thesis: {page}: no place for the table {name}")
    page.write_text(text)
