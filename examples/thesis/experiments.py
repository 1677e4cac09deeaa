#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Chapter 5 of the thesis, run again: see README.md and run.sh beside this file."""

import argparse
import concurrent.futures
import os
import pathlib
import sys

import figures
import tables
from molecule_files import data_file, last_frame, mean_bond, without_lost_bonds
from runs import HERE, Failed, build, dynamics, mean_edge, minimisation

# (p, s): iterations between replacements of the projection mesh, and the percentage of edges outside the interval at
# which optimisation becomes local.
SETTINGS = [(0, 2), (0, 5), (10, 2), (10, 5), (25, 5)]
MESH_ENDINGS = (".off", ".obj", ".ply", ".stl")


class Model:
    def __init__(self, name, files, steps, stable):
        self.name, self.files, self.steps = name, files, steps
        self.stable = stable  # (p, s) for which the thesis shows the molecule whole
        self.mesh = None

    def find(self, folder):
        candidates = [folder / (stem + ending) for stem in self.files for ending in MESH_ENDINGS]
        self.mesh = next((c for c in candidates if c.exists()), None)
        return self.mesh is not None


# The first file of a row that the folder holds is taken.
MODELS = [
    Model("egea", ["egea"], 5000, (10, 5)),
    Model("bunny", ["bunny-7k", "bunny"], 3000, (25, 5)),
    Model("fertility", ["fertility-9k", "fertility"], 3000, (10, 5)),
    Model("rocker-arm", ["rocker-arm-20k", "rocker-arm", "rockerarm"], 3000, (25, 5)),
]
LONG_STEPS = 200000  # of the rocker-arm
# For --short: what is small among the models, or the shapes that come with the project.
SHORT = [Model("rocker-arm", ["rocker-arm-5k"], 300, (25, 5)), Model("torus", ["torus"], 300, (25, 5)),
         Model("genus-two", ["genus-two"], 300, (25, 5))]


def thesis_options(setting, recipe="thesis"):
    p, s = setting
    options = ["--recipe", recipe]
    if recipe in ("thesis", "hauck2015"):
        options += ["--projection-interval", p, "--local-threshold", s]
    return options


class Experiments:
    settings = SETTINGS

    def __init__(self, args, models):
        self.args, self.models = args, models
        self.failures = 0

    def prefix(self, part, *words):
        folder = self.args.out / part
        folder.mkdir(parents=True, exist_ok=True)
        return folder / "-".join(str(word) for word in words)

    def whole(self, model, prefix, options, *, mean=1.5, steps=None, pair="rebo/opt", sized=()):
        """Remeshing and dynamics of one molecule: a row of the tables."""
        row = {"model": model.name, "short": self.args.short}
        try:
            # "All the models were scaled, putting the average edge length to the desirable value": that of the bonds,
            # and edges of the triangulation are sqrt(3) times as long.
            size = sized or ["--scale", repr(3**0.5 * mean / mean_edge(model.mesh))]
            report = build(prefix, model.mesh, [*size, *options])
            row |= {"report": report, "data": f"{prefix}.data"}
            row["run"] = dynamics(prefix, row["data"], steps or model.steps, pair)
            positions, bonds = data_file(row["data"])
            row["before"] = mean_bond(positions, bonds)
            row["after"] = mean_bond(last_frame(row["run"]["frames"])[1], bonds)
        except Failed as failure:
            row["failed"] = str(failure)
        return row

    def one(self, model, setting, part="remeshing", options=(), **how):
        p, s = setting
        row = self.whole(model, self.prefix(part, model.name, f"p{p}", f"s{s}"), [*thesis_options(setting), *options],
                         **how)
        return row | {"setting": setting}

    # --- the parts; each returns the rows of its table -------------------------------------------------------------

    def remeshing(self):
        return self.each((self.one, m, s) for m in self.models for s in SETTINGS)

    def visited(self):
        return self.each((lambda m: self.one(m, m.stable, "visited", ["--visited", "both"]), m) for m in self.models)

    def interval(self):
        narrow = ["--min-bond", 1.1, "--max-bond", 1.7]
        return self.each((lambda m: self.one(m, m.stable, "interval", narrow, mean=1.4), m) for m in self.models)

    def long(self):
        def row(model):
            row = self.one(model, model.stable, "long", steps=1000 if self.args.short else LONG_STEPS)
            return row | self.minimised_after(model, row, "long") if "run" in row else row
        return self.each((row, m) for m in self.models if m.name == "rocker-arm" or self.args.short)

    def rebo(self):
        model = self.models[min(1, len(self.models) - 1)]
        return self.each((lambda pair: self.one(model, model.stable, "pair-" + pair.replace("/", "-"), pair=pair)
                          | {"pair": pair}, pair) for pair in ("rebo/opt", "rebo"))

    def airebo(self):
        """Every setting under AIREBO; the molecules are the same, since remeshing knows no potential."""
        return self.each((lambda m, s: self.one(m, s, "airebo", pair="airebo/opt"), m, s)
                         for m in self.models for s in SETTINGS)

    def earlier(self):
        def row(model, recipe):
            if recipe == "thesis":
                return self.one(model, (10, 5)) | {"recipe": recipe}  # done already by the first part
            return self.whole(model, self.prefix("earlier", model.name, recipe),
                              thesis_options((10, 5), recipe)) | {"recipe": recipe}
        recipes = ("pecanha2013", "hauck2014", "hauck2015", "thesis")
        return self.each((row, m, r) for m in self.models for r in recipes)

    def default(self):
        def row(model):
            row = self.by_default(model)
            return row | self.minimised_after(model, row, "default") if "run" in row else row
        return self.each((row, m) for m in self.models)

    def by_default(self, model):
        """Today's default recipe, with as many atoms as the thinnest parts of all four models ask for."""
        options = ["--quality", "draft"] if self.args.short else []
        return self.whole(model, self.prefix("default", model.name), options,
                          sized=["--atoms", 2000 if self.args.short else 10000])

    def cg(self):
        """Conjugate gradients of the model as it is, of the remeshed one, and of that after dynamics."""
        def row(model):
            prefix = self.prefix("cg", model.name)
            row = self.one(model, model.stable)  # done already by the first part
            raw = [*thesis_options((0, 0), "pecanha2013"), "--iterations", 0]
            try:
                scale = 3**0.5 * 1.5 / mean_edge(model.mesh)
                build(f"{prefix}-raw", model.mesh, ["--scale", repr(scale), *raw])
            except Failed as failure:
                return row | {"failed": str(failure)}
            row |= self.minimised("raw", f"{prefix}-raw.data", f"{prefix}-raw", iterations=200)
            if "run" in row:
                row |= self.minimised("remeshed", row["data"], f"{prefix}-remeshed")
                row |= self.minimised_after(model, row)
            return row
        return self.each((row, m) for m in self.models)

    # ---------------------------------------------------------------------------------------------------------------

    def minimised_after(self, model, row, part="cg"):
        """Conjugate gradients from where a run has ended."""
        prefix = self.prefix(part, model.name, "after")
        end, kept = f"{pathlib.Path(row['data']).with_suffix('')}-after.data", pathlib.Path(f"{prefix}-kept.data")
        if not (kept.exists() and kept.stat().st_mtime > os.stat(end).st_mtime):
            without_lost_bonds(end, kept)
        return self.minimised("after", kept, prefix)

    def minimised(self, name, data, prefix, iterations=5000):
        try:
            result = minimisation(prefix, data, "rebo/opt", 200 if self.args.short else iterations)
        except Failed as failure:
            return {"cg " + name: {"failed": str(failure)}}
        result["mean bond"] = mean_bond(last_frame(result["frames"])[1], data_file(data)[1])
        return {"cg " + name: result}

    def each(self, calls):
        with concurrent.futures.ThreadPoolExecutor(self.args.jobs) as pool:
            waiting = [pool.submit(call[0], *call[1:]) for call in calls]
            return [self.told(w.result()) for w in waiting]

    def told(self, row):
        self.failures += "failed" in row or any("failed" in cell for cell in row.values() if isinstance(cell, dict))
        what = row.get("failed") or tables.verdict_of(row)
        print("  ", row["model"], row.get("setting", ""), row.get("recipe", ""), what, flush=True)
        return row


PARTS = ["remeshing", "visited", "interval", "long", "cg", "earlier", "default", "rebo", "airebo"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--short", action="store_true")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("out/thesis"))
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--only", default="", choices=[*PARTS, "figures"], metavar="PART")
    parser.add_argument("--page", action="store_true")
    args = parser.parse_args()
    if args.jobs < 1:
        parser.error("--jobs: at least 1")
    args.out = args.out.resolve()
    if not args.folder.is_dir():
        sys.exit(f"thesis: {args.folder}: no such folder")
    if spaced := next((path for path in (args.out, HERE) if " " in str(path)), None):
        sys.exit(f"thesis: {spaced}: LAMMPS's scripts cannot name files with spaces in them; take another folder")
    return args


def main():
    args = arguments()
    wanted = SHORT if args.short else MODELS
    models = [m for m in wanted if m.find(args.folder)]
    if not models:
        sys.exit(f"thesis: {args.folder} holds none of " + ", ".join(n for m in wanted for n in m.files))
    for model in MODELS:
        if not args.short and model not in models:
            print(f"thesis: note: no {model.name} in {args.folder}", file=sys.stderr)
    args.out.mkdir(parents=True, exist_ok=True)
    experiments = Experiments(args, models[:1] if args.short else models)

    pages = {}
    for part in PARTS:
        if args.only in ("", part):
            print(part, flush=True)
            pages[part] = tables.TABLES[part](getattr(experiments, part)())
            (args.out / f"{part}.md").write_text(pages[part])
    if args.only in ("", "figures"):
        print("figures", flush=True)
        folder = HERE if args.page else args.out
        figures.draw_all(experiments, folder)
    if args.page:
        tables.put_into(HERE / "README.md", pages)
    if args.short:
        print("\n".join(pages.values()))
    print(f"Tables are in {args.out}/*.md.")
    if experiments.failures:
        sys.exit(f"thesis: {experiments.failures} rows have no result; what went wrong is in the table")


if __name__ == "__main__":
    main()
