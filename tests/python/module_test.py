#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Tests of the module nanocarbon_sp2: what ASE computes with its own means, known energies, doctests, Ctrl-C.

    module_test.py
"""

import _thread
import doctest
import pathlib
import sys
import tempfile
import threading
import time
import unittest

import ase
import ase.build
import ase.io.cube
import ase.neighborlist
import numpy as np
from ase.optimize import BFGS

import nanocarbon_sp2 as nc
import nanocarbon_sp2.calculators


def rattled(atoms, amount=0.05, seed=1):
    atoms = atoms.copy()
    atoms.positions += np.random.default_rng(seed).normal(scale=amount, size=atoms.positions.shape)
    return atoms


def derivative(energy, x, step):
    """Central differences of an energy by each element of an array."""
    result = np.zeros_like(x)
    for index in np.ndindex(x.shape):
        for sign in (1, -1):
            moved = x.copy()
            moved[index] += sign * step
            result[index] += sign * energy(moved) / (2 * step)
    return result


def ases_own(calculator, atoms, what, step):
    """ASE's numerical forces or stress, wherever this ASE has them."""
    name = f"calculate_numerical_{what}"
    try:
        from ase.calculators import fd
        return getattr(fd, name)(atoms, step)
    except ImportError:  # before ASE 3.23 every calculator has them
        return getattr(calculator, name)(atoms, step)


class Calculators(unittest.TestCase):
    def test_ases_own_tests_of_calculators_pass(self):
        structures = [rattled(ase.build.molecule("C6H6")), rattled(ase.build.bulk("C", "diamond", a=3.6, cubic=True)),
                      rattled(nc.make.tube(5, 0).to_ase()), rattled(nc.make.graphene(2, 1).to_ase())]
        for calculator in [nc.REBO2(), nc.AIREBO(), nc.AIREBOM()]:
            for atoms in structures:
                atoms.calc = calculator
                with self.subTest(potential=calculator.potential_name, atoms=str(atoms.symbols)):
                    np.testing.assert_allclose(atoms.get_forces(), ases_own(calculator, atoms, "forces", 1e-4), atol=5e-5)
                    if atoms.cell.rank == 3:
                        np.testing.assert_allclose(atoms.get_stress(), ases_own(calculator, atoms, "stress", 1e-5), atol=2e-6)

    def test_forces_are_the_derivative_of_the_energy(self):
        for calculator in [nc.REBO2(), nc.AIREBO()]:
            atoms = rattled(ase.build.molecule("C2H4"))
            atoms.calc = calculator

            def energy(positions):
                atoms.positions = positions
                return atoms.get_potential_energy()

            start = atoms.positions.copy()
            numeric = -derivative(energy, start, 1e-4)
            atoms.positions = start
            np.testing.assert_allclose(atoms.get_forces(), numeric, atol=2e-5)

    def test_stress_is_the_derivative_by_strain(self):
        for calculator in [nc.REBO2(), nc.AIREBO()]:
            atoms = rattled(ase.build.bulk("C", "diamond", a=3.6, cubic=True))
            cell = atoms.cell.array.copy()
            atoms.calc = calculator
            stress = atoms.get_stress(voigt=False)

            def energy(strain):
                strained = atoms.copy()
                strained.set_cell(cell @ (np.eye(3) + 0.5 * (strain + strain.T)), scale_atoms=True)
                strained.calc = calculator
                return strained.get_potential_energy()

            numeric = derivative(energy, np.zeros((3, 3)), 1e-5) / atoms.get_volume()
            np.testing.assert_allclose(stress, numeric, atol=1e-6)

    def test_energies_of_atoms_add_up(self):
        atoms = rattled(ase.build.bulk("C", "diamond", a=3.567, cubic=True))
        atoms.calc = nc.REBO2()
        self.assertAlmostEqual(atoms.get_potential_energies().sum(), atoms.get_potential_energy(), places=9)

    def test_c60_relaxes_to_its_known_energy(self):
        c60 = nc.make.fullerene(1, 1).to_ase()
        c60.calc = nc.REBO2()
        BFGS(c60, logfile=None).run(fmax=1e-4, steps=200)
        self.assertAlmostEqual(c60.get_potential_energy() / 60, -6.842065, places=5)

    def test_graphite_has_airebos_distance_between_sheets(self):
        # Stuart et al. 2000: 3.354 Angstrom. Two sheets, AB.
        def energy(c):
            sheet = nc.make.graphene(3, 2).to_ase()
            upper = sheet.copy()
            upper.positions += [0.0, 1.42, 0.0]
            pair = sheet + upper
            pair.positions[len(sheet):, 2] += c
            pair.set_cell([pair.cell[0], pair.cell[1], [0, 0, 2 * c]])
            pair.pbc = True
            pair.calc = nc.AIREBO()
            return pair.get_potential_energy()

        distances = np.linspace(3.25, 3.5, 6)
        fit = np.polyfit(distances, [energy(c) for c in distances], 3)
        best = [r.real for r in np.roots(np.polyder(fit)) if 3.2 < r.real < 3.6]
        self.assertAlmostEqual(best[0], 3.36, delta=0.03)

    def test_a_left_handed_cell_is_the_same_crystal(self):
        crystal = rattled(ase.build.bulk("C", "diamond", a=3.567, cubic=True))
        mirror = crystal.copy()
        mirror.set_cell(crystal.cell[[1, 0, 2]])
        energies = []
        for atoms in (crystal, mirror):
            atoms.calc = nc.REBO2()
            energies.append((atoms.get_potential_energy(), atoms.get_stress()))
        self.assertAlmostEqual(energies[0][0], energies[1][0], places=9)
        np.testing.assert_allclose(energies[0][1], energies[1][1], atol=1e-9)

    def test_other_elements_are_refused(self):
        water = ase.build.molecule("H2O")
        water.calc = nc.REBO2()
        with self.assertRaisesRegex(ValueError, "atomic number 8"):
            water.get_potential_energy()


class Molecules(unittest.TestCase):
    def test_views_share_memory_and_keep_it(self):
        molecule = nc.make.fullerene(1, 1)
        positions = molecule.positions
        positions[0] = [1.0, 2.0, 3.0]
        np.testing.assert_array_equal(molecule.positions[0], [1.0, 2.0, 3.0])
        bonds = molecule.bonds
        self.assertEqual(bonds.shape, (90, 2))
        with self.assertRaises(ValueError):
            bonds[0] = 1
        del molecule
        self.assertTrue((bonds[:, 0] <= bonds[:, 1]).all() and bonds.max() == 59)

    def test_there_and_back(self):
        tube = nc.make.tube(6, 3)
        atoms = tube.to_ase()
        again = nc.from_ase(atoms)
        np.testing.assert_array_equal(again.positions, tube.positions)
        np.testing.assert_allclose(again.cell, tube.cell)
        self.assertEqual(again.pbc, tube.pbc)

    def test_analysis_counts_what_ase_counts(self):
        atoms = rattled(ase.build.bulk("C", "diamond", a=3.567, cubic=True).repeat(2), 0.15)
        first = ase.neighborlist.neighbor_list("i", atoms, 1.7)
        found = nc.analyse(atoms)
        np.testing.assert_array_equal(found.columns["coordination"], np.bincount(first, minlength=len(atoms)))
        self.assertEqual(len(found.molecule.rings), sum(found.report["rings"]["by_size"].values()))

    def test_a_molecules_triangulation_has_a_triangle_for_each_atom(self):
        c240 = nc.make.fullerene(2, 2)
        mesh = c240.triangulation()
        self.assertEqual((len(mesh.points), len(mesh.triangles)), (122, 240))


class Building(unittest.TestCase):
    def test_from_a_file_or_a_shape(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "torus.off"
            nc.make.torus(2.0, 0.8, 0.2).write(file)
            stages = []
            built = nc.build(file, atoms=300, quality="draft", progress=lambda stage, share: stages.append(stage))
            self.assertTrue(stages)
            self.assertEqual(built.report["molecule"]["genus"], 1)
            built.molecule.write(pathlib.Path(folder) / "torus.data")
            self.assertAlmostEqual(len(built.molecule), 300, delta=30)

    def test_a_field_that_ase_wrote_is_a_surface(self):
        grid = np.mgrid[0:20, 0:20, 0:20] * 2 * np.pi / 20
        atoms = ase.Atoms(cell=[8.0] * 3, pbc=True)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "p.cube"
            with open(path, "w") as file:
                ase.io.cube.write_cube(file, atoms, np.cos(grid).sum(axis=0))
            with self.assertRaisesRegex(nc.NanocarbonError, "between -3 and 3"):
                nc.read_mesh(path)
            mesh = nc.read_mesh(path, level=0.0, periodic=(True, True, True))
        # Schwarz's P surface, whose cell ASE writes in Bohr.
        edges = len(mesh.triangles) * 3 // 2
        self.assertEqual(len(mesh.points) - edges + len(mesh.triangles), -4)  # genus 3
        # What goes on through the faces of the cell may stand out by an edge.
        self.assertTrue((mesh.points.max(axis=0) - mesh.points.min(axis=0) < 1.1 * 8.0 / 0.529177).all())

    def test_what_cannot_be_is_said(self):
        with self.assertRaisesRegex(nc.NanocarbonError, "nowhere.off"):
            nc.read_mesh("nowhere.off")
        with self.assertRaisesRegex(ValueError, "one of atoms"):
            nc.build(nc.make.sphere(), atoms=200, scale=1.0)

    def test_other_threads_run_meanwhile_and_ctrl_c_ends_it(self):
        ticks = []
        used = []  # CPU seconds, which other work on the machine leaves alone
        interrupt = threading.Timer(1.0, lambda: (used.append(time.process_time()), _thread.interrupt_main()))
        ticker = threading.Thread(target=lambda: [ticks.append(time.sleep(0.02)) for _ in range(40)])
        ticker.start()
        interrupt.start()
        with self.assertRaises(KeyboardInterrupt):
            nc.build(nc.make.torus(), atoms=4000, quality="best", threads=1)
        self.assertGreater(len(ticks), 5)
        self.assertLess(time.process_time() - used[0], 3.0)


class Pages(unittest.TestCase):
    def test_doctests(self):
        for module in (nc, nanocarbon_sp2.calculators):
            failures, tests = doctest.testmod(module)
            self.assertGreater(tests, 0)
            self.assertEqual(failures, 0)


if __name__ == "__main__":
    unittest.main(verbosity=2)
