#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The energies under AIREBO in examples/structures/README.md, by LAMMPS: made_energies.py README NANOCARBON LMP CH.AIREBO

Every row whose first cell is a command of `nanocarbon make` is made; LAMMPS's pair_style airebo must find the energy of
the second cell there, in eV for each atom, and gain next to nothing by minimising.
"""

import pathlib
import re
import subprocess
import sys
import tempfile

PAGE, PROGRAM, LMP, POTENTIAL = sys.argv[1:5]
SCRIPT = """
units metal
atom_style molecular
boundary {boundary}
read_data {data}
special_bonds lj/coul 1.0 1.0 1.0
pair_style airebo 3.0
pair_coeff * * {potential} C H
neighbor 1.0 bin
thermo_style custom step pe fmax
run 0
print "made: $(pe/atoms:%.9f) $(fmax:%.9f)"
min_style cg
minimize 0 1e-5 20 40
print "minimised: $(pe/atoms:%.9f)"
"""


def checked(folder, command, told):
    data, source = folder / "made.data", folder / "in.script"
    subprocess.run([PROGRAM, *command.split()[1:], "-q", "-o", data], check=True)
    boundary = re.search(r"^# boundary ([pf] [pf] [pf])", data.read_text(), re.M)[1]
    source.write_text(SCRIPT.format(boundary=boundary, data=data, potential=POTENTIAL))
    said = subprocess.run([LMP, "-in", source, "-log", "none"], capture_output=True, text=True, check=False).stdout
    made = re.search(r"^made: (\S+) (\S+)", said, re.M)
    least = re.search(r"^minimised: (\S+)", said, re.M)
    if not (made and least):
        print(said[-2000:])
        return False
    energy, force, least = float(made[1]), float(made[2]), float(least[1])
    print(f"{command}: {energy:.7f} eV/atom ({told}), largest force {force:.1e}, minimised {least:.7f}")
    return abs(energy - told) < 6e-6 and force < 2e-4 and energy - least < 1e-6


def main():
    rows = re.findall(r"^\| `(nanocarbon make [^`]*)` \| (-\d+\.\d+) \|", pathlib.Path(PAGE).read_text(), re.M)
    if len(rows) < 5:
        sys.exit(f"{PAGE}: a table of energies was expected")
    with tempfile.TemporaryDirectory() as folder:
        wrong = [command for command, told in rows if not checked(pathlib.Path(folder), command, float(told))]
    if wrong:
        sys.exit("not as the page says: " + "; ".join(wrong))


if __name__ == "__main__":
    main()
