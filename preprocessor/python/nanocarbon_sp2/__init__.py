# SPDX-License-Identifier: GPL-2.0-or-later
"""Carbon molecules from triangle meshes, what carbon structures are made of, and REBO2 and AIREBO for ASE.

>>> import nanocarbon_sp2 as nc
>>> c60 = nc.make.fullerene(1, 1)
>>> len(c60), c60.positions.shape
(60, (60, 3))
>>> nc.analyse(c60).report["rings"]["by_size"]
{'5': 12, '6': 20}

Lengths are in Angstrom, energies in eV. Structures are `Molecule` here and `ase.Atoms` there: `to_ase`, `from_ase`.
What a user can mend raises `NanocarbonError`, a `ValueError`.
"""

from __future__ import annotations

import json
import os
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any, Callable, Literal

import numpy as np

from . import _core
from ._core import Mesh, Molecule, NanocarbonError, Potential, __version__, make, read_mesh

if TYPE_CHECKING:
    import ase

__all__ = ["AIREBO", "AIREBOM", "Analysis", "Build", "Mesh", "Molecule", "NanocarbonError", "Potential", "REBO2",
           "__version__", "analyse", "build", "from_ase", "make", "read_mesh", "to_ase"]


def _threads(threads: int | None) -> int:
    return threads or len(os.sched_getaffinity(0))


@dataclass(frozen=True)
class Build:
    """What `build` made: the molecule, the triangulation that it is the dual of, and everything known about it."""

    molecule: Molecule
    triangulation: Mesh
    report: dict[str, Any]


def build(mesh: Mesh | str | os.PathLike[str], atoms: int | None = None, *, length: float | None = None,
          scale: float | None = None, quality: Literal["draft", "good", "best"] = "good",
          potential: Literal["rebo2", "airebo", "airebo-m"] = "rebo2", tether: float | None = None,
          boundary: Literal["hydrogen", "bare"] = "hydrogen", force: bool = False, threads: int | None = None,
          seed: int = 1, progress: Callable[[str, float], None] | None = None) -> Build:
    """Makes a carbon molecule from a mesh, as `nanocarbon build` does.

    How large: a number of `atoms`, the `length` of the longest side, or a `scale` (both Angstrom); without any, an atom
    for each triangle. Carbon at a `boundary` of the mesh binds hydrogen, or is left bare. `progress` is called with what is being done and how much of it, 0 to 1. The interpreter is free
    for other threads meanwhile, and Ctrl-C ends it.

    >>> built = build(make.sphere(1.0, 3), atoms=180, quality="draft")
    >>> built.report["molecule"]["genus"], len(built.molecule.rings) == len(built.molecule) // 2 + 2
    (0, True)
    """
    if not isinstance(mesh, Mesh):
        mesh = read_mesh(mesh)
    built = _core.build(mesh, atoms, length, scale, quality, potential, tether, boundary, force,
                        _threads(threads), seed, progress)
    return Build(built.molecule, built.triangulation, json.loads(built.report))


@dataclass(frozen=True)
class Analysis:
    """What `analyse` found.

    `report` is the JSON of `nanocarbon analyse` (its page explains the keys), with atoms by index from 0; `columns`
    holds an array for each thing known of an atom, not-a-number where it is not defined; `molecule` has the bonds and
    the rings.
    """

    report: dict[str, Any]
    columns: dict[str, np.ndarray]
    molecule: Molecule


def analyse(structure: Molecule | ase.Atoms, *, form: float = 1.7, rings: Literal["auto", "king", "primitive"] = "auto",
            max_ring: int = 12, potential: Literal["rebo2", "airebo", "airebo-m", "none"] = "rebo2",
            threads: int | None = None) -> Analysis:
    """Tells bonds, rings, topology, defects, curvature and energies of a structure.

    >>> diamond = analyse(make.diamond(2, 2, 2))
    >>> diamond.report["rings"]["king"]["per_atom"], float(diamond.columns["coordination"].mean())
    ({'6': 2.0}, 4.0)
    """
    if not isinstance(structure, Molecule):
        structure = from_ase(structure)
    found = _core.analyse(structure, form, rings, max_ring, potential, _threads(threads))
    return Analysis(json.loads(found.report), found.columns, found.molecule)


def to_ase(molecule: Molecule) -> ase.Atoms:
    """The atoms of a molecule for ASE.

    >>> to_ase(make.graphene(2, 1)).get_pbc()
    array([ True,  True, False])
    """
    import ase

    return ase.Atoms(numbers=molecule.numbers, positions=molecule.positions,
                     cell=None if molecule.cell is None else molecule.cell, pbc=molecule.pbc)


def from_ase(atoms: ase.Atoms) -> Molecule:
    """A molecule of ASE's atoms, without bonds (`analyse` finds them)."""
    from ase.geometry import complete_cell

    periodic = [bool(p) for p in atoms.pbc]
    cell = complete_cell(atoms.cell) if any(periodic) else None
    return Molecule(atoms.positions, atoms.numbers, cell, periodic)


Molecule.to_ase = to_ase


def __getattr__(name: str) -> Any:
    # The calculators need ASE, which the rest does not.
    if name in ("REBO2", "AIREBO", "AIREBOM"):
        from . import calculators

        return getattr(calculators, name)
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
