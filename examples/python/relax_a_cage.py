#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""From a mesh to a molecule that ASE relaxes, and what it is made of.

    PYTHONPATH=build/release/python python3 examples/python/relax_a_cage.py
"""

import numpy as np
from ase.optimize import BFGS

import nanocarbon_sp2 as nc

# C60, relaxed by ASE with REBO2.
c60 = nc.make.fullerene(1, 1).to_ase()
c60.calc = nc.REBO2()
BFGS(c60, logfile=None).run(fmax=1e-4)
print(f"C60: {c60.get_potential_energy() / len(c60):.6f} eV an atom")
assert abs(c60.get_potential_energy() / len(c60) + 6.842065) < 1e-5

# A molecule on a mesh (any file that read_mesh reads, or a shape), its rings, and where it is bent most.
built = nc.build(nc.make.sphere(), atoms=240, quality="draft")
found = nc.analyse(built.molecule)
print(f"{len(built.molecule)} atoms, rings {found.report['rings']['by_size']}")
assert found.report["euler_characteristic"] == 2
angles = found.columns["pyramidalisation"]
print(f"pyramidalisation {np.nanmin(angles):.1f} to {np.nanmax(angles):.1f} degrees")

# Atoms in pentagons, as ASE's tags, ready to be written or shown.
atoms = built.molecule.to_ase()
atoms.set_tags(np.where(found.columns["smallest_ring"] == 5, 1, 0))
print(f"{int(atoms.get_tags().sum())} atoms in pentagons")
