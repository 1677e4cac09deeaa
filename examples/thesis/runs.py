# SPDX-License-Identifier: GPL-2.0-or-later
"""The programs that the experiments call, each call made once: what is up to date is not made again."""

import json
import os
import pathlib
import re
import subprocess

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM = os.environ.get("NANOCARBON", "nanocarbon")
LAMMPS = os.environ.get("LAMMPS", "lmp-nanocarbon")
PLUGIN = os.environ.get("PLUGIN", "nanocarbonplugin.so")


class Failed(Exception):
    """A program ended with an error; the text is its last line."""


def call(record, command, inputs=()):
    """Runs a command unless RECORD.json says that it was run, and is newer than its inputs and the program.

    Returns the record: the command, its exit code, its output and its CPU seconds.
    """
    command = [str(word) for word in command]
    file = pathlib.Path(f"{record}.json")
    sources = [pathlib.Path(p) for p in (command[0], *inputs) if os.path.exists(p)]
    if file.exists() and all(file.stat().st_mtime > s.stat().st_mtime for s in sources):
        known = json.loads(file.read_text())
        if known["command"] == command:
            return known
    file.unlink(missing_ok=True)
    with open(f"{record}.screen", "w+", errors="replace") as screen:
        process = subprocess.Popen(command, stdout=screen, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        screen.seek(0)
        text = screen.read()
    known = {"command": command, "exit": process.returncode, "seconds": usage.ru_utime + usage.ru_stime,
             "text": text[-8000:]}
    if process.returncode == 0:  # what failed, for want of a program perhaps, is tried again
        file.write_text(json.dumps(known, indent=1))
    return known


def mean_edge(mesh):
    """Of a mesh file, in its own units."""
    done = subprocess.run([PROGRAM, "inspect", str(mesh), "--json"], capture_output=True, text=True, check=False)
    if done.returncode != 0:
        raise Failed(done.stderr.strip())
    return json.loads(done.stdout)["edge_lengths"]["mean"]


def build(prefix, mesh, options):
    """nanocarbon build on one core: its report, with the CPU seconds under "cpu". Raises Failed."""
    done = call(f"{prefix}-build", [PROGRAM, "build", mesh, "-o", f"{prefix}.data", "--report", f"{prefix}.report",
                                    "--quiet", "--threads", "1", *options], [mesh])
    if done["exit"] != 0:
        raise Failed(f"exit {done['exit']}: " + done["text"].strip().split("error: ")[-1])
    report = json.loads(pathlib.Path(f"{prefix}.report").read_text())
    report["cpu"] = done["seconds"]
    return report


def lammps(record, script, variables, inputs):
    words = [LAMMPS, "-in", HERE / script, "-log", "none"]
    for name, value in variables.items():
        words += ["-var", name, value]
    return call(record, words, [*inputs, HERE / script, HERE / "../validate.in", PLUGIN])


def watch(every):
    """What fix bond/topology is told: the steps between looks, and which atoms are bonded.

    The thesis starts from bonds of up to 1.8 Angstrom, and by default the fix takes atoms for bonded that are nearer than
    1.7. With 1.9 the bonds of the start are those of the remeshed model.
    """
    return f"{every} form 1.9"


def dynamics(prefix, data, steps, pair):
    """STEPS steps of 1 fs from rest. What fix bond/topology says at the end, and the temperature there, K."""
    done = lammps(f"{prefix}-run", "../validate.in",
                  {"data": data, "steps": steps, "every": max(1, steps // 10), "pair": pair, "plugin": PLUGIN,
                   "out": prefix, "pixels": 0, "watch": watch(10 if steps <= 5000 else 100)}, [data])
    said = re.search(r"^verdict: (.*?), (\d+) atoms repelled, (\d+) bonds broken, (\d+) formed", done["text"], re.M)
    if not said:
        raise Failed(last_error(done["text"]))
    thermo = re.search(rf"^ +{steps} +(\S+)", done["text"], re.M)
    first = None
    with open(f"{prefix}.topology.jsonl") as changes:
        for line in changes:
            if (event := json.loads(line)).get("repelled"):
                first = event["step"]
                break
    return {"verdict": said[1], "repelled": int(said[2]), "broken": int(said[3]), "formed": int(said[4]),
            "first repelled": first, "temperature": float(thermo[1]), "frames": f"{prefix}.lammpstrj",
            "cpu": done["seconds"]}


def minimisation(prefix, data, pair, iterations):
    """Conjugate gradients from the positions of a data file, with at most so many iterations."""
    done = lammps(f"{prefix}-minimise", "minimise.in",
                  {"data": data, "pair": pair, "plugin": PLUGIN, "out": f"{prefix}-cg", "pixels": 0,
                   "watch": watch(10), "iterations": iterations,
                   "validate": HERE / "../validate.in"}, [data])
    energy = re.search(r"^minimised: (\S+) eV for each atom, largest force (\S+)", done["text"], re.M)
    steps = re.search(r"^ +Iterations, force evaluations = (\d+)", done["text"], re.M)
    said = re.search(r"^verdict of the minimisation: (\S+), (\d+) atoms repelled, (\d+) bonds broken, (\d+) formed",
                     done["text"], re.M)
    if not said:
        raise Failed(last_error(done["text"]))
    verdicts = ["intact", "homeomorphic", "broken", "not a surface"]
    return {"verdict": verdicts[int(said[1])], "repelled": int(said[2]), "broken": int(said[3]),
            "formed": int(said[4]), "energy": float(energy[1]), "force": float(energy[2]),
            "iterations": int(steps[1]), "frames": f"{prefix}-cg-minimised.lammpstrj", "cpu": done["seconds"]}


def last_error(text):
    errors = re.findall(r"^(?:ERROR|nanocarbon: error).*", text, re.M)
    return errors[-1] if errors else "LAMMPS gave no verdict"
