#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""King's and primitive rings of periodic structures, counted once more by their definitions: a second program, in another
language, that shares nothing with the first but the words of the papers. Then copies of each structure: as many times the rings.

    rings_by_definition.py NANOCARBON FOLDER FILE.xyz...

Files are extended XYZ of carbon with a Lattice, cubic cells wider than the longest ring.
"""

import collections
import itertools
import json
import pathlib
import re
import subprocess
import sys

MAX_RING, BOND = 9, 1.7


def read(file):
    lines = pathlib.Path(file).read_text().splitlines()
    lattice = [float(x) for x in re.search(r'Lattice="([^"]*)"', lines[1])[1].split()]
    edges = lattice[0], lattice[4], lattice[8]
    return edges, [tuple(map(float, line.split()[1:4])) for line in lines[2:2 + int(lines[0])]]


def neighbours_of(edges, atoms):
    """Of each atom: (atom, image) of all within a bond."""
    def near(a, b):
        wrap = [round((b[d] - a[d]) / edges[d]) for d in range(3)]
        return tuple(-w for w in wrap), sum((b[d] - a[d] - wrap[d] * edges[d]) ** 2 for d in range(3))

    rows = [[] for _ in atoms]
    for i, j in itertools.combinations(range(len(atoms)), 2):
        image, squared = near(atoms[i], atoms[j])
        if squared < BOND ** 2:
            rows[i].append((j, image))
            rows[j].append((i, tuple(-k for k in image)))
    return rows


class Network:
    """The crystal that a cell stands for: a node is an atom and the image that it is in."""

    def __init__(self, rows):
        self.rows = rows

    def around(self, node):
        atom, image = node
        return [(other, tuple(a + b for a, b in zip(image, shift))) for other, shift in self.rows[atom]]

    def distances(self, start, farthest, avoided=None):
        found, queue = {start: 0}, collections.deque([start])
        while queue:
            node = queue.popleft()
            if found[node] == farthest:
                continue
            for other in self.around(node):
                if other != avoided and other not in found:
                    found[other] = found[node] + 1
                    queue.append(other)
        return found

    def shortest_paths(self, start, end, farthest, avoided):
        distance = self.distances(end, farthest, avoided)
        if start not in distance:
            return
        paths = [[start]]
        for _ in range(distance[start]):
            paths = [[*path, node] for path in paths for node in self.around(path[-1])
                     if node != avoided and distance.get(node, -1) == distance[path[-1]] - 1]
        yield from paths


def in_the_cell(ring):
    """The same for all images of a ring, wherever it starts and whichever way it runs."""
    candidates = []
    for way in (list(ring), list(reversed(ring))):
        for k in range(len(way)):
            turned = way[k:] + way[:k]
            origin = turned[0][1]
            candidates.append(tuple((atom, tuple(a - b for a, b in zip(image, origin))) for atom, image in turned))
    return min(candidates)


def king(network):
    """For each atom and each two of its neighbours the shortest ways around."""
    rings = set()
    for atom in range(len(network.rows)):
        node = (atom, (0, 0, 0))
        for one, other in itertools.combinations(network.around(node), 2):
            for path in network.shortest_paths(one, other, MAX_RING - 2, node):
                rings.add(in_the_cell([node, *path]))
    return rings


def primitive(network):
    """Cycles of which any two atoms are as far apart in the network as along the cycle. Such a cycle goes from each of its
    atoms along a shortest path to the middle of its other side: it is two shortest paths, or two and a bond."""
    rings, half = set(), MAX_RING // 2
    known = {}

    def distance(a, b):
        if a[0] not in known:
            known[a[0]] = network.distances((a[0], (0, 0, 0)), half)
        return known[a[0]].get((b[0], tuple(p - q for p, q in zip(b[1], a[1]))), half + 1)

    def is_primitive(ring):
        n = len(ring)
        return all(distance(ring[i], ring[j]) == min(j - i, n - j + i) for i, j in itertools.combinations(range(n), 2))

    def ways(start, end, length):
        if length == 0:
            return [[start]]
        return [[*way, end] for node in network.around(end) if distance(start, node) == length - 1
                for way in ways(start, node, length - 1)]

    for atom in range(len(network.rows)):
        node = (atom, (0, 0, 0))
        for end, length in network.distances(node, half).items():
            to_end = ways(node, end, length)
            pairs = [(a, b) for a, b in itertools.combinations(to_end, 2) if 2 * length <= MAX_RING]
            rings |= {in_the_cell(r) for r in ([*a, *reversed(b[1:-1])] for a, b in pairs) if len(set(r)) == len(r) > 2 and is_primitive(r)}
            if 2 * length + 1 > MAX_RING or length == 0:
                continue
            for other in network.around(end):
                if distance(node, other) == length and other > end:
                    for a, b in itertools.product(to_end, ways(node, other, length)):
                        ring = [*a, *reversed(b[1:])]
                        if len(set(ring)) == len(ring) and is_primitive(ring):
                            rings.add(in_the_cell(ring))
    return rings


def by_size(rings):
    return {str(size): count for size, count in sorted(collections.Counter(map(len, rings)).items())}


def analysed(program, file):
    done = subprocess.run([program, "analyse", file, "--json", "--potential", "none", "--max-ring", str(MAX_RING), "--form", str(BOND)],
                          capture_output=True, text=True, check=True)
    rings = json.loads(done.stdout)["rings"]
    return rings["king"]["by_size"], rings["primitive"]["by_size"]


def copies(file, edges, atoms, times, folder):
    out = folder / f"{pathlib.Path(file).stem}-copies.xyz"
    lengths = [t * e for t, e in zip(times, edges)]
    lines = [f"C {' '.join(str(x + k * e) for x, k, e in zip(atom, shift, edges))}"
             for shift in itertools.product(*map(range, times)) for atom in atoms]
    out.write_text(f"{len(lines)}\nLattice=\"{lengths[0]} 0 0 0 {lengths[1]} 0 0 0 {lengths[2]}\" pbc=\"T T T\"\n" +
                   "\n".join(lines) + "\n")
    return out


def main():
    program, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    folder.mkdir(parents=True, exist_ok=True)
    for file in sys.argv[3:]:
        edges, atoms = read(file)
        network = Network(neighbours_of(edges, atoms))
        found, expected = analysed(program, file), (by_size(king(network)), by_size(primitive(network)))
        if found != expected:
            sys.exit(f"{file}: King's and primitive rings are {found}, by their definitions {expected}")
        for times in ((2, 2, 2), (3, 1, 1)):
            several = analysed(program, copies(file, edges, atoms, times, folder))
            count = times[0] * times[1] * times[2]
            if several != tuple({size: n * count for size, n in one.items()} for one in found):
                sys.exit(f"{file}: {count} copies have {several}, one has {found}")
        print(f"{file}: {len(atoms)} atoms, King's {found[0]}, primitive {found[1]}; by definition the same")


if __name__ == "__main__":
    main()
