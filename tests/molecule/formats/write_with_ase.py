# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes a molecule in every format that ASE has for it, for energy_files_test.cpp.

Usage: write_with_ase.py FILE.xyz FOLDER/    (names may carry numbers: C1, C2, ...)
"""
import sys

from ase import Atoms
from ase.io import write

lines = open(sys.argv[1]).read().splitlines()[2:]
folder = sys.argv[2]
positions = [[float(x) for x in line.split()[1:4]] for line in lines]
atoms = Atoms("C" * len(positions), positions=positions)
write(folder + "plain.xyz", atoms, format="xyz")
write(folder + "extended.xyz", atoms, format="extxyz")
write(folder + "movie.xyz", [Atoms("C2", positions=[[0, 0, 0], [1.4, 0, 0]]), atoms], format="extxyz")
atoms.set_cell([25, 26, 27])
atoms.set_pbc(True)
for style in ("atomic", "charge", "full"):
    write(folder + style + ".data", atoms, format="lammps-data", atom_style=style)
write(folder + "c60.cif", atoms, format="cif")
write(folder + "POSCAR", atoms, format="vasp")
write(folder + "direct.vasp", atoms, format="vasp", direct=True, vasp5=True)
