#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Compares `nanocarbon analyse` with ASE: structures that ASE makes and writes, neighbours that ASE counts.

    analyse_with_ase.py PROGRAM FOLDER
"""

import json
import pathlib
import subprocess
import sys

import ase.build
import ase.io
import ase.neighborlist
import numpy

CUTOFFS = {("C", "C"): 1.7, ("C", "H"): 1.3, ("H", "H"): 1.1}


def structures():
    random = numpy.random.default_rng(1)
    yield "c60", ase.build.molecule("C60")
    yield "benzene", ase.build.molecule("C6H6")
    tube = ase.build.nanotube(8, 4, length=2)
    tube.center(vacuum=6.0, axis=(0, 1))
    yield "tube", tube
    for name, rattle in [("diamond", 0.05), ("hot-diamond", 0.2)]:
        crystal = ase.build.bulk("C", "diamond", a=3.567, cubic=True).repeat(3)
        crystal.positions += random.normal(scale=rattle, size=crystal.positions.shape)
        yield name, crystal
    yield "skewed-cell", ase.build.bulk("C", "diamond", a=3.567)  # two atoms, rhombohedral
    ribbon = ase.build.graphene_nanoribbon(4, 3, type="zigzag", saturated=True, vacuum=6.0)
    yield "ribbon", ribbon
    # Carbon strewn about at the density of amorphous carbon, no two atoms nearer than 1.2 Angstrom.
    cloud = ase.Atoms(cell=[13.0] * 3, pbc=True)
    while len(cloud) < 220:
        trial = ase.Atoms("C", positions=[random.random(3) * 13.0])
        both = cloud + trial
        if len(cloud) == 0 or both.get_distances(-1, range(len(cloud)), mic=True).min() > 1.2:
            cloud = both
    yield "cloud", cloud


def neighbours(atoms):
    first, _ = ase.neighborlist.neighbor_list("ij", atoms, CUTOFFS)
    return numpy.bincount(first, minlength=len(atoms))


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for name, atoms in structures():
        file, columns = folder / f"{name}.xyz", folder / f"{name}-columns.xyz"
        ase.io.write(file, atoms, format="extxyz")
        done = subprocess.run([program, "analyse", file, "--json", "--xyz", columns], capture_output=True, text=True)
        assert done.returncode == 0, (name, done.stderr)
        found, expected = json.loads(done.stdout), neighbours(atoms)
        carbon = atoms.numbers == 6
        counts = {str(n): int(c) for n, c in enumerate(numpy.bincount(expected[carbon])) if c}
        assert found["coordination"] == counts, (name, found["coordination"], counts)
        back = ase.io.read(columns)
        assert len(back) == len(atoms) and numpy.allclose(back.positions, atoms.positions), name
        assert (back.arrays["coordination"] == expected).all(), name
        assert numpy.isfinite(back.arrays["atom_energy"]).all(), name
        assert abs(back.arrays["atom_energy"].sum() - found["energy"]["total"]) < 1e-4, name
        print(f"{name}: {len(atoms)} atoms, {counts}, rings {found['rings']['by_size']}")
    assert json.loads(subprocess.run([program, "analyse", folder / "c60.xyz", "--json"], capture_output=True, text=True,
                                     check=True).stdout)["rings"]["by_size"] == {"5": 12, "6": 20}


if __name__ == "__main__":
    main()
