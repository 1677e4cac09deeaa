# SPDX-License-Identifier: GPL-2.0-or-later
"""What the experiments read from LAMMPS's files: bonds of a data file, the last frame of a trajectory."""

import math


def data_file(path):
    """Positions by atom, and bonds, of a data file of atom style molecular."""
    positions, bonds, section = {}, [], None
    with open(path) as lines:
        for line in lines:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0].isalpha():
                section = words[0]
            elif section == "Atoms":
                positions[int(words[0])] = tuple(map(float, words[3:6]))
            elif section == "Bonds":
                bonds.append((int(words[2]), int(words[3])))
    return positions, bonds


def without_lost_bonds(path, copy):
    """Copies a data file that a run wrote, less the bonds to atoms that it lost: LAMMPS crashes at reading those."""
    positions, bonds = data_file(path)
    kept = sum(a in positions and b in positions for a, b in bonds)
    section, number = None, 0
    with open(path) as lines, open(copy, "w") as out:
        for line in lines:
            words = line.split("#")[0].split()
            if words[1:] == ["bonds"]:
                line = f"{kept} bonds\n"
            elif words and words[0].isalpha():
                section = words[0]
            elif section == "Bonds" and words:
                if not (int(words[2]) in positions and int(words[3]) in positions):
                    continue
                number += 1
                line = f"{number} {' '.join(words[1:])}\n"
            out.write(line)


def last_frame(path):
    """The step, and the positions by atom, of the last frame of a custom dump with columns id type x y z."""
    step, positions, reading = 0, {}, None
    with open(path) as lines:
        for line in lines:
            if line.startswith("ITEM:"):
                reading = line[6:].split()[0]
                if reading == "TIMESTEP":
                    positions = {}
            elif reading == "TIMESTEP":
                step = int(line)
            elif reading == "ATOMS":
                words = line.split()
                positions[int(words[0])] = tuple(map(float, words[2:5]))
    return step, positions


def mean_bond(positions, bonds, longest=2.0):
    """Mean length of the bonds that are there and hold, Angstrom: REBO2's carbon bonds end at 2."""
    lengths = [math.dist(positions[a], positions[b]) for a, b in bonds if a in positions and b in positions]
    lengths = [length for length in lengths if length < longest]
    return sum(lengths) / len(lengths) if lengths else math.nan
