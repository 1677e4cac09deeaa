# SPDX-License-Identifier: GPL-2.0-or-later
"""One row of the suite: a molecule built from a mesh and run in LAMMPS."""

import json
import os
import pathlib
import re
import subprocess

MOST_ADVICE = 4  # pieces of advice that are followed for a mesh
# What a pair style is called without /opt, the potential's name in nanocarbon, and its file.
STYLES = {"rebo": ("rebo", "rebo2", "CH.rebo"), "airebo": ("airebo 3.0", "airebo", "CH.airebo"),
          "airebo/morse": ("airebo/morse 3.0", "airebo-m", "CH.airebo-m")}

TOO_FEW_ATOMS = (6, 8)  # exit codes: the size does not fit the shape; no good result was reached

# Minimised as fully as LAMMPS can: conjugate gradients, then FIRE.
MINIMISATION = """
units metal
atom_style molecular
boundary f f f
read_data {data}
special_bonds lj/coul 1.0 1.0 1.0
mass 1 12.011
{hydrogen}
pair_style {style}
pair_coeff * * {potential} {elements}
compute coordination all coord/atom cutoff 2.0
compute fewest all reduce min c_coordination
compute most all reduce max c_coordination
thermo_style custom step pe fmax c_fewest c_most
thermo 1000000
minimize 0 1e-4 100 1000
min_style fire
minimize 0 1e-4 100 1000
print "suite: $(pe:%.10f) $(atoms) $(c_fewest:%.0f) $(c_most:%.0f)"
"""


def style_of(args):
    return STYLES[args.pair.removesuffix("/opt")]


def potential_of(args):
    """The option of nanocarbon build that goes with the pair style, where it is not the default and none was given."""
    name = style_of(args)[1]
    return [] if name == "rebo2" or "--potential" in args.options else ["--potential", name]


def run(args, command, screen):
    """Runs a program with its output in a file. Returns its exit code and CPU seconds."""
    with open(screen, "w") as out:
        process = subprocess.Popen([*args.launcher.split(), *map(str, command)], stdout=out,
                                   stderr=subprocess.STDOUT)
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime


def verdict_of_run(args, data, prefix, temperature):
    """The verdict of fix bond/topology, or what LAMMPS said instead."""
    plugin, screen = args.build / "lammps-plugin", f"{prefix}.screen"
    run(args, [plugin / "lmp-nanocarbon", "-in", args.root / "examples/validate.in", "-log", f"{prefix}.log",
               "-var", "data", data, "-var", "steps", args.steps, "-var", "temperature", temperature, "-var", "pixels", 0, "-var", "every",
               1000, "-var", "plugin", plugin / "nanocarbonplugin.so", "-var", "pair", args.pair, "-var", "out",
               prefix], screen)
    text = pathlib.Path(screen).read_text(errors="replace")
    verdict = re.search(r"^verdict: ([a-z ]+), (\d+) atoms repelled", text, re.M)
    if not verdict:
        error = re.search(r"^ERROR.*", text, re.M)
        return error.group(0) if error else "no verdict"
    return verdict.group(1) + (f", {verdict.group(2)} repelled" if verdict.group(2) != "0" else "")


def lammps_energy(args, data, prefix, row, energy_per_atom):
    """Adds how far LAMMPS's minimum lies from the program's."""
    style, _, file = style_of(args)
    potential = pathlib.Path("/usr/share/lammps/potentials") / file
    hydrogen = re.search(r"^\s*2 atom types", data.read_text(), re.M)
    script = MINIMISATION.format(data=data, style=style, potential=potential if potential.exists() else file,
                                 hydrogen="mass 2 1.008" if hydrogen else "", elements="C H" if hydrogen else "C")
    source, screen = pathlib.Path(f"{prefix}-minimum.in"), pathlib.Path(f"{prefix}-minimum.screen")
    source.write_text(script)
    run(args, [args.build / "lammps-plugin/lmp-nanocarbon", "-in", source, "-log", "none"], screen)
    found = re.search(r"^suite: (\S+) (\d+) (\d+) (\d+)", screen.read_text(errors="replace"), re.M)
    if not found:
        row["failure"] = "LAMMPS did not minimise it"
        return
    row["lammps_minus_own_meV"] = 1000 * (float(found.group(1)) / int(found.group(2)) - energy_per_atom)
    row["lammps_intact"] = f"{found.group(3)}-{found.group(4)} bonds"


def facts_of(report):
    molecule, bonds = report["molecule"], report["bond_lengths"]
    rings = {int(size): count for size, count in molecule["rings_by_size"].items()}
    distance = report["distance"]["atoms_to_surface"]
    facts = {
        "atoms": molecule["atoms"],
        "pentagons": rings.get(5, 0),
        "heptagons": rings.get(7, 0),
        "other_rings": sum(count for size, count in rings.items() if not 5 <= size <= 7),
        "percent_defects": 100 * (1 - rings.get(6, 0) / sum(rings.values())),
        "bond_min": bonds["min"],
        "bond_max": bonds["max"],
        "bond_cv": bonds["standard_deviation"] / bonds["mean"],
        "angle_sd": report["bond_angles"]["standard_deviation"],
        "distance_mean": distance["mean"],
        "distance_max": distance["max"],
    }
    if "annealing" in report:
        facts["meV_above_graphene"] = 1000 * report["annealing"]["above_graphene"]
    return facts


def build(args, mesh, prefix, atoms, options):
    """On one core: exit code, CPU seconds, and what the program said."""
    screen = pathlib.Path(f"{prefix}.build")
    code, seconds = run(args, [args.build / "preprocessor/cli/nanocarbon", "build", mesh, "-o", f"{prefix}.data",
                               "--quiet", "--threads", "1", "--report", f"{prefix}.json", "--atoms", atoms,
                               *(["--page", f"{prefix}.html"] if args.pages else []), *potential_of(args), *options],
                        screen)
    said = screen.read_text(errors="replace").strip()
    begin = max(0, ("\n" + said).find("\nnanocarbon: "))
    reason = said[begin:].replace("\n  - ", " ") or "no message"
    return code, seconds, reason.replace("nanocarbon: ", "").replace(f"{mesh}: ", "")


def advised(args, code, reason, atoms, options):
    """The number of atoms and the options that a refusal asks for; nothing where it asks for none that are new."""
    larger = re.search(r"--atoms (\d+)", reason)
    if code in TOO_FEW_ATOMS and larger and int(larger.group(1)) > atoms:
        if int(larger.group(1)) <= args.largest or not args.follow_advice:
            return int(larger.group(1)), options
    number = r"[0-9.]+(?:e[+-]?[0-9]+)?"
    option = rf"--(?:drop-specks|untangle|unite)\b|--(?:wrap|close-holes) {number}(?:,{number})?"
    named = re.search(rf"(?:{option})(?: (?:{option}))*", reason)  # "It can be used with --close-holes 0.1 --unite"
    if not args.follow_advice or not named:
        return None
    new = named.group(0).rstrip(".,").split()
    return None if new[0] in options else (atoms, options + new)


def row_of(args, mesh):
    prefix, atoms, options = args.out / mesh.stem, args.atoms, args.options
    row = {"mesh": mesh.stem, "atoms_asked": atoms}
    code, seconds, reason = build(args, mesh, prefix, atoms, options)
    for step in range(MOST_ADVICE if args.follow_advice else 1 if args.follow_refusals else 0):
        advice = advised(args, code, reason, atoms, options) if code != 0 else None
        if advice is None or (advice[0] > args.largest and advice[0] != atoms):
            break
        row["refusal"] = row.get("refusal", "") + f"refused at {atoms}: {reason} "
        atoms, options = advice
        row["atoms_asked"] = atoms
        prefix = args.out / f"{mesh.stem}-{atoms}-{step}"
        code, seconds, reason = build(args, mesh, prefix, atoms, options)
        if code != 0:
            reason = f"though advised: {reason}"
    if code != 0:
        row["failure"] = f"exit {code}: {reason}"
        return row
    report = json.loads(pathlib.Path(f"{prefix}.json").read_text())
    row.update(facts_of(report), cpu_seconds=seconds)
    if args.pages:
        row["page"] = f"{prefix.name}.html"
    data = pathlib.Path(f"{prefix}.data")
    if args.lammps_energy and "annealing" in report:
        lammps_energy(args, data, prefix, row, report["annealing"]["energy_per_atom"])
    if args.steps > 0:
        row["from_rest"] = verdict_of_run(args, data, f"{prefix}-rest", 0)
        # As it was after the run from rest.
        row["at_600K"] = verdict_of_run(args, f"{prefix}-rest-after.data", f"{prefix}-hot", 600)
    return row
