#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Graphite under AIREBO by ASE's equation of state: its bond, the distance of its sheets, what holds them together.

    PYTHONPATH=build/release/python python3 examples/python/graphite_equation_of_state.py
"""

import numpy as np
from ase.eos import EquationOfState
from ase.lattice.hexagonal import Graphite

import nanocarbon_sp2 as nc


def graphite(a, distance):
    """AB graphite, 3 by 3 by 2 cells."""
    atoms = Graphite("C", latticeconstant={"a": a, "c": 2.0 * distance}, size=(3, 3, 2))
    atoms.calc = nc.AIREBO()
    return atoms


def minimum(make, low, high):
    """Where the energy is least along one length, by ASE's fit to seven volumes, and the energy an atom there."""
    lengths = np.linspace(low, high, 7)
    structures = [make(length) for length in lengths]
    energies = [atoms.get_potential_energy() / len(atoms) for atoms in structures]
    volumes = [atoms.get_volume() / len(atoms) for atoms in structures]
    volume, energy, modulus = EquationOfState(volumes, energies, eos="birchmurnaghan").fit()
    return float(np.interp(volume, volumes, lengths)), energy, modulus


a, _, _ = minimum(lambda length: graphite(length, 3.36), 2.40, 2.44)
distance, energy, _ = minimum(lambda length: graphite(a, length), 3.30, 3.42)
sheet = nc.make.graphene(3, 2).to_ase()
sheet.set_cell(sheet.cell.array * [[a / 2.46], [a / 2.46], [1.0]], scale_atoms=True)
sheet.calc = nc.AIREBO()
binding = sheet.get_potential_energy() / len(sheet) - energy
print(f"a = {a:.4f} A, sheets {distance:.4f} A apart, held by {1000 * binding:.1f} meV an atom, {energy:.5f} eV an atom")

# What LAMMPS finds with pair_style airebo 3.0, relaxing the same crystal.
assert abs(distance - 3.358) < 0.01 and abs(1000 * binding - 50.5) < 1.0
