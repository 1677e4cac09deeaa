# SPDX-License-Identifier: GPL-2.0-or-later
"""Reads files with ASE and prints what it saw, for ase_reads_test.cpp.

Usage: read_with_ase.py xyz FILE | data FILE STYLE | convert FILE.xyz OUT.data
Prints: number of atoms, symbols joined, pbc, the cell's nine numbers, then one position a line, all as repr, and
the bonded atoms where the file names them.
"""
import sys
import warnings

from ase.io import read, write

kind, path = sys.argv[1:3]
if kind == "convert":
    write(sys.argv[3], read(path), format="lammps-data")
    sys.exit()
if kind == "xyz":
    atoms = read(path, format="extxyz")
else:
    # Newer versions warn of `style`, older ones do not know `atom_style`.
    warnings.simplefilter("ignore", FutureWarning)
    atoms = read(path, format="lammps-data", Z_of_type={1: 6, 2: 1}, style=sys.argv[3], sort_by_id=True)
print(len(atoms))
print("".join(atoms.get_chemical_symbols()))
print(*(int(p) for p in atoms.pbc))
print(*(repr(float(x)) for x in atoms.cell.array.flatten()))
for position in atoms.positions:
    print(*(repr(float(x)) for x in position))
for bonded in atoms.arrays.get("bonded", []):
    print(*(int(other) for other in bonded))
