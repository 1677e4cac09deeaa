#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""The suite on a folder of two shapes, one of them too thin at first: run_test.py NANOCARBON BUILD_FOLDER"""

import csv
import pathlib
import re
import subprocess
import sys
import tempfile
import types
import unittest

import measure

HERE = pathlib.Path(__file__).resolve().parent
PROGRAM, BUILD = (pathlib.Path(word) for word in sys.argv[1:3])


class Suite(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        folder = pathlib.Path(cls.folder.name)
        (folder / "meshes").mkdir()
        for shape, sizes in (("sphere", []), ("torus", ["--major", "3", "--minor", "0.4"])):
            subprocess.run([PROGRAM, "make", "mesh", shape, *sizes, "-o", folder / "meshes" / f"{shape}.off"],
                           check=True, capture_output=True)
        cls.add_specks(folder / "meshes")
        command = [sys.executable, HERE / "run.py", folder / "meshes", "--build", BUILD, "--out", folder / "out",
                   "--atoms", "200", "--steps", "20", "--jobs", "2", "--follow-advice", "--lammps-energy", "--resume",
                   "--", "--quality", "draft"]
        cls.first = subprocess.run(command, capture_output=True, text=True, check=True)
        made = (folder / "out/sphere.data").stat().st_mtime_ns
        cls.second = subprocess.run(command, capture_output=True, text=True, check=True)
        cls.made_again = (folder / "out/sphere.data").stat().st_mtime_ns != made
        with open(folder / "out/suite.tsv", encoding="utf-8") as table:
            cls.rows = {row["mesh"]: row for row in csv.DictReader(table, delimiter="\t")}

    @classmethod
    def add_specks(cls, folder):
        """The sphere with three tetrahedra beside it that have no room for a molecule."""
        words = (folder / "sphere.off").read_text().split("\n")
        vertices, faces = (int(word) for word in words[1].split()[:2])
        points, triangles = words[2:2 + vertices], words[2 + vertices:2 + vertices + faces]
        for k in range(3):
            first = len(points)
            points += [f"{3 + k + 0.01 * x} {0.01 * y} {0.01 * z}"
                       for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
            triangles += [f"3 {first + a} {first + b} {first + c}"
                          for a, b, c in ((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2))]
        lines = ["OFF", f"{len(points)} {len(triangles)} 0", *points, *triangles]
        (folder / "specks.off").write_text("\n".join(lines) + "\n")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_every_mesh_has_a_row_and_a_molecule_that_holds(self):
        self.assertEqual(set(self.rows), {"sphere", "specks", "torus"})
        for row in self.rows.values():
            self.assertEqual(row["failure"], "")
            self.assertEqual((row["from_rest"], row["at_600K"]), ("intact", "intact"))

    def test_topology_shows_in_the_rings(self):
        for mesh, euler in (("sphere", 2), ("specks", 2), ("torus", 0)):
            row = self.rows[mesh]
            self.assertEqual(int(row["pentagons"]) - int(row["heptagons"]), 6 * euler)

    def test_energies_are_those_of_lammps(self):
        for row in self.rows.values():
            self.assertLess(abs(float(row["lammps_minus_own_meV"])), 0.1)
            self.assertEqual(row["lammps_intact"], "3-3 bonds")

    def test_a_refused_shape_is_built_at_the_size_named(self):
        self.assertIn("thin part", self.rows["torus"]["refusal"])
        self.assertGreater(int(self.rows["torus"]["atoms"]), 200)
        self.assertEqual(self.rows["sphere"]["refusal"], "")

    def test_an_option_that_a_refusal_names_is_given(self):
        self.assertIn("3 of 4 pieces are specks", self.rows["specks"]["refusal"])
        self.assertEqual(self.rows["specks"]["meV_above_graphene"], self.rows["sphere"]["meV_above_graphene"])

    def test_every_molecule_has_a_page_that_the_index_leads_to(self):
        out = pathlib.Path(self.folder.name) / "out"
        index = (out / "index.html").read_text(encoding="utf-8")
        if "<a " not in index:
            self.assertIn("three.js", self.first.stderr)
            self.skipTest("the program was built without three.js")
        self.assertEqual(set(re.findall(r'<a href="[^"]*">([^<]*)</a>', index)), set(self.rows))
        for page in re.findall(r'<a href="([^"]*)">', index):
            text = (out / page).read_text(encoding="utf-8")
            self.assertIn("nanocarbon build", text)
            self.assertIn('id="contents"', text)

    def test_what_is_done_is_not_done_again(self):
        self.assertFalse(self.made_again)
        self.assertEqual(self.first.stdout, self.second.stdout)


class Advice(unittest.TestCase):
    """What is made of a refusal's last line."""

    def follow(self, reason, code=5, options=()):
        return measure.advised(types.SimpleNamespace(follow_advice=True, largest=40000), code, reason, 400, list(options))

    def test_the_options_it_names_are_taken_with_their_values(self):
        for options in (["--unite"], ["--wrap", "0.5"], ["--wrap", "1e+02,25"], ["--close-holes", "0.011", "--unite"],
                        ["--untangle", "--unite"]):
            reason = f"the mesh cannot be used: 2 edges\nIt can be used with {' '.join(options)} (wrapped, size 0.5)"
            self.assertEqual(self.follow(reason), (400, options))

    def test_an_option_is_not_given_twice(self):
        self.assertIsNone(self.follow("It can be used with --unite (united)", options=["--unite"]))

    def test_a_size_too_large_to_follow_gives_way_to_an_option(self):
        reason = "a small hole of 0.31 A (--close-holes 0.019 would close it); the next size is --atoms {}; ask for that"
        self.assertEqual(self.follow(reason.format(1400), code=6), (1400, []))
        self.assertEqual(self.follow(reason.format(140000), code=6), (400, ["--close-holes", "0.019"]))

    def test_a_size_that_is_only_a_word_is_none(self):
        self.assertIsNone(self.follow("--wrap SIZE puts a closed surface around anything"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
