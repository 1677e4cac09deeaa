# SPDX-License-Identifier: GPL-2.0-or-later
"""Calculators for ASE: energy, forces, stress and the energies of atoms."""

from __future__ import annotations

from typing import Any

import numpy as np
from ase.calculators.calculator import Calculator, all_changes
from ase.geometry import complete_cell

from ._core import Potential

__all__ = ["AIREBO", "AIREBOM", "REBO2"]


class _Calculator(Calculator):
    implemented_properties = ["energy", "free_energy", "forces", "energies", "stress"]
    potential_name = ""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.potential = Potential(self.potential_name)

    def calculate(self, atoms: Any = None, properties: Any = ("energy",), system_changes: Any = all_changes) -> None:
        super().calculate(atoms, properties, system_changes)
        periodic = [bool(p) for p in self.atoms.pbc]
        cell = complete_cell(self.atoms.cell) if any(periodic) else None
        found = self.potential.evaluate(self.atoms.positions, self.atoms.numbers, cell, periodic)
        self.results = {"energy": found["energy"], "free_energy": found["energy"], "forces": found["forces"],
                        "energies": found["energies"]}
        if self.atoms.cell.rank == 3:
            # The virial is the sum of r (x) f: minus the derivative by strain.
            stress = -0.5 * (found["virial"] + found["virial"].T) / self.atoms.get_volume()
            self.results["stress"] = stress.flat[[0, 4, 8, 5, 2, 1]]
        elif "stress" in properties:
            raise ValueError("there is no stress without a cell")


class REBO2(_Calculator):
    """REBO2 (Brenner et al. 2002): what LAMMPS's pair_style rebo computes.

    >>> import nanocarbon_sp2 as nc
    >>> sheet = nc.to_ase(nc.make.graphene(1, 1))
    >>> sheet.calc = nc.REBO2()
    >>> round(sheet.get_potential_energy() / len(sheet), 4)
    -7.395
    """

    potential_name = "rebo2"


class AIREBO(_Calculator):
    """AIREBO (Stuart et al. 2000): with Lennard-Jones and torsion terms."""

    potential_name = "airebo"


class AIREBOM(_Calculator):
    """AIREBO-M (O'Connor et al. 2015): with Morse terms instead of Lennard-Jones ones."""

    potential_name = "airebo-m"
