#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Writes the crystals of rebo_opt_general.sh as LAMMPS data files: general_structures.py FOLDER

Diamond, and diamond pressed to a lattice constant of 3.45 Angstrom; polyethylene by C. W. Bunn, Trans. Faraday Soc. 35, 482
(1939); benzene by G. E. Bacon, N. A. Curry and S. A. Wilson, Proc. R. Soc. Lond. A 279, 98 (1964).
"""
import pathlib
import sys


def write(path, name, edges, basis, repeats):
    """A crystal; basis has (element, x, y, z) in fractions of the cell's edges."""
    atoms = [
        (element, *((x + n) * a for x, n, a in zip(place, cell, edges)))
        for cell in ((i, j, k) for i in range(repeats[0]) for j in range(repeats[1]) for k in range(repeats[2]))
        for element, *place in basis
    ]
    with open(path / f"{name}.data", "w") as out:
        out.write(f"{name}\n\n{len(atoms)} atoms\n2 atom types\n\n")
        for edge, n, axis in zip(edges, repeats, "xyz"):
            out.write(f"0 {edge * n!r} {axis}lo {axis}hi\n")
        out.write("\nMasses\n\n1 12.011\n2 1.008\n\nAtoms # atomic\n\n")
        for number, (element, *position) in enumerate(atoms, 1):
            out.write(f"{number} {'CH'.index(element) + 1} " + " ".join(f"{x:.6f}" for x in position) + "\n")


def main():
    path = pathlib.Path(sys.argv[1])
    corners = [(0, 0, 0), (0, 0.5, 0.5), (0.5, 0, 0.5), (0.5, 0.5, 0)]
    diamond = [("C", x + d, y + d, z + d) for x, y, z in corners for d in (0, 0.25)]
    write(path, "diamond", (3.566,) * 3, diamond, (10, 10, 10))
    write(path, "pressed", (3.45,) * 3, diamond, (10, 10, 10))

    # Pnam, in the mirror plane.
    polyethylene = []
    for element, x, y in (("C", 0.038, 0.065), ("H", 0.186, 0.011), ("H", 0.011, 0.269)):
        for place in ((x, y, 0.25), (-x, -y, 0.75), (0.5 - x, 0.5 + y, 0.75), (0.5 + x, 0.5 - y, 0.25)):
            polyethylene.append((element, *place))
    write(path, "polyethylene", (7.40, 4.93, 2.534), polyethylene, (7, 10, 12))

    # Pbca, molecules on inversion centres.
    benzene = []
    for element, x, y, z in (
        ("C", -0.0569, 0.1387, -0.0054), ("C", -0.1335, 0.0460, 0.1264), ("C", -0.0774, -0.0925, 0.1295),
        ("H", -0.0976, 0.2447, -0.0177), ("H", -0.2409, 0.0794, 0.2218), ("H", -0.1371, -0.1631, 0.2312),
    ):  # fmt: skip
        for s in (1, -1):
            benzene += [
                (element, s * x, s * y, s * z),
                (element, 0.5 - s * x, -s * y, 0.5 + s * z),
                (element, -s * x, 0.5 + s * y, 0.5 - s * z),
                (element, 0.5 + s * x, 0.5 - s * y, -s * z),
            ]
    write(path, "benzene", (7.44, 9.55, 6.92), benzene, (6, 6, 6))


if __name__ == "__main__":
    main()
