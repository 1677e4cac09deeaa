#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Euler's formula on surfaces: atoms, bonds and rings counted here, against the topology that `nanocarbon analyse` reports
and what the shape is known to be.

    euler_by_counting.py NANOCARBON FOLDER MESHES

Bonds are those that the data file lists. Rings must run along them; bonds that lie in one ring only are the rims.
"""

import collections
import json
import pathlib
import subprocess
import sys

# Commands, and for each piece of what they make its genus (handles) and number of rims.
KNOWN = [
    (["make", "fullerene", "1", "1"], [(0, 0)]),
    (["make", "fullerene", "4", "2"], [(0, 0)]),
    (["make", "onion", "--shells", "3"], [(0, 0)] * 3),
    (["make", "tube", "6", "4", "--length", "30"], [(0, 2)]),
    (["make", "tube", "5", "5", "--length", "30", "--ends", "open"], [(0, 2)]),
    (["make", "tube", "9", "0", "--length", "20", "--ends", "capped"], [(0, 0)]),
    (["make", "tube", "8", "2", "--periodic", "--length", "60"], [(1, 0)]),
    (["make", "tube", "6", "6", "--length", "20", "--bundle", "7"], [(0, 2)] * 7),
    (["make", "graphene", "--cells", "5", "4"], [(1, 0)]),
    (["make", "graphene", "--flake", "12", "--hydrogen"], [(0, 1)]),
    (["make", "schwarzite", "p688", "--cells", "2"], [(17, 0)]),  # chi -4 in each of 8 cells
    (["make", "schwarzite", "d688", "--cells", "2"], [(9, 0)]),  # chi -2
    (["build", "sphere.off", "--atoms", "300", "--quality", "draft"], [(0, 0)]),
    (["build", "torus.off", "--atoms", "500", "--quality", "draft"], [(1, 0)]),
    (["build", "genus-two.off", "--atoms", "1600", "--quality", "draft"], [(2, 0)]),
    (["build", "gyroid-shell.off", "--atoms", "2400", "--quality", "draft"], [(4, 0)]),
    (["build", "hemisphere.off", "--atoms", "600", "--quality", "draft"], [(0, 1)]),
    (["build", "t-junction.off", "--atoms", "1200", "--quality", "draft", "--force"], [(0, 0)]),
]


def bonds_of(data):
    """Pairs of atom IDs of a data file's Bonds section."""
    lines = iter(data.read_text().splitlines())
    for line in lines:
        if line.split("#")[0].strip() == "Bonds":
            break
    next(lines)
    bonds = []
    for line in lines:
        words = line.split()
        if not words:
            break
        bonds.append(frozenset(map(int, words[2:4])))
    return bonds


def pieces_of(atoms, bonds):
    """The lowest atom ID of each connected piece, for each atom."""
    parent = {a: a for a in atoms}

    def root(a):
        while parent[a] != a:
            parent[a] = a = parent[parent[a]]
        return a

    for a, b in map(tuple, bonds):
        first, second = sorted((root(a), root(b)))
        parent[second] = first
    return {a: root(a) for a in atoms}


def rims_of(edges):
    """Of how many closed loops these edges consist: every vertex must have two."""
    neighbours = collections.defaultdict(list)
    for a, b in map(tuple, edges):
        neighbours[a].append(b)
        neighbours[b].append(a)
    assert all(len(n) == 2 for n in neighbours.values()), "a rim touches itself"
    return len(set(pieces_of(neighbours, edges).values()))


def check(program, folder, meshes, number, command, known):
    data = folder / f"{number}.data"
    command = [str(meshes / word) if word.endswith(".off") else word for word in command]
    subprocess.run([program, *command, "-q", "-o", data], check=True)
    found = json.loads(subprocess.run([program, "analyse", data, "--json", "--potential", "none"], check=True,
                                      capture_output=True, text=True).stdout)
    bonds = bonds_of(data)
    assert len(set(bonds)) == len(bonds) and len(bonds) > 0, "two bonds between the same atoms: take a larger cell"
    piece = pieces_of(range(1, found["atoms"] + 1), bonds)
    degree = collections.Counter(a for bond in bonds for a in bond)
    told = {p["first_atom"]: p for p in found["pieces"]}
    assert set(told) == set(piece.values()), command
    seen = []
    for first, its in told.items():
        assert its["surface"], (command, its)
        # Hydrogen, or what else hangs on one bond, leaves the characteristic as it is.
        edges = [b for b in bonds if piece[min(b)] == first and min(degree[a] for a in b) > 1]
        corners = {a for b in edges for a in b}
        rings = [r for r in found["rings"]["atoms"] if piece[r[0]] == first]
        sides = collections.Counter(frozenset((r[k - 1], r[k])) for r in rings for k in range(len(r)))
        assert set(sides) <= set(edges) and max(sides.values()) <= 2, command
        single = [b for b in edges if sides[b] == 1]
        assert all(sides[b] > 0 for b in edges), command
        rims = rims_of(single)
        chi = len(corners) - len(edges) + len(rings)
        assert its["euler_characteristic"] == chi and its["boundary_loops"] == rims, (command, its, chi, rims)
        assert its["orientable"] and 2 - 2 * its["genus"] - rims == chi, (command, its, chi)
        seen.append((its["genus"], rims))
    assert sorted(seen) == sorted(known), (command, seen, known)
    print(f"{' '.join(command)}: {found['atoms']} atoms, genus and rims of its pieces {sorted(set(seen))}")


def main():
    program, folder, meshes = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    folder.mkdir(parents=True, exist_ok=True)
    for number, (command, known) in enumerate(KNOWN):
        check(program, folder, meshes, number, command, known)


if __name__ == "__main__":
    main()
