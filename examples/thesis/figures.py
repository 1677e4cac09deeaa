# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures like 5.1 to 5.5 of the thesis, drawn by LAMMPS from the runs that were made."""

import sys

from molecule_files import last_frame
from runs import HERE

sys.path.insert(0, str(HERE.parent / "pictures"))
from draw import draw  # noqa: E402

# How each model is looked at: theta and phi of dump image, what is up, and how near.
VIEWS = {
    "egea": {"theta": "8", "phi": "90", "up": "0 1 0", "zoom": "1.9"},
    "bunny": {"theta": "20", "phi": "90", "up": "0 1 0", "zoom": "2.0"},
    "fertility": {"theta": "12", "phi": "70", "up": "0 1 0", "zoom": "2.2"},
    "rocker-arm": {"theta": "75", "phi": "20", "up": "0 0 1", "zoom": "1.9"},
}


def at_end(data, frames):
    """The atoms of a data file where the last frame of a trajectory has them."""
    return data, {"frames": frames, "step": str(last_frame(frames)[0])}


def draw_all(experiments, folder):
    """Every figure that the models at hand allow."""
    models = {model.name: model for model in experiments.models}

    def figure(name, model, scenes, pixels):
        print("  ", name, flush=True)
        draw(folder / f"{name}.png", scenes, VIEWS.get(model.name, {}), pixels)

    def after(model, setting):
        row = experiments.one(model, setting)
        return at_end(row["data"], row["run"]["frames"])

    def before_and_after(name, model, setting):
        row = experiments.one(model, setting)
        if "run" in row:
            figure(name, model, [(row["data"], {}), at_end(row["data"], row["run"]["frames"])], 420)

    if "egea" in models:
        egea = models["egea"]
        before_and_after("figure-5.1", egea, (0, 2))
        before_and_after("figure-5.2", egea, (10, 5))
        figure("figure-5.3", egea, [after(egea, s) for s in experiments.settings], 260)
    for name, letter in (("bunny", "a"), ("fertility", "b"), ("rocker-arm", "c")):
        if name in models:
            before_and_after(f"figure-5.4{letter}", models[name], models[name].stable)
    last = experiments.models[-1]
    row = experiments.one(last, last.stable)
    minimised = experiments.minimised_after(last, row)["cg after"] if "run" in row else {"failed": row["failed"]}
    if "failed" not in minimised:
        figure("figure-5.5", last, [at_end(row["data"], row["run"]["frames"]), at_end(row["data"], minimised["frames"])],
               420)
    row = experiments.by_default(last)
    if "run" in row:
        figure("figure-default", last, [(row["data"], {}), at_end(row["data"], row["run"]["frames"])], 420)
