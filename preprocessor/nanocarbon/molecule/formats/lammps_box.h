// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

//! A simulation box in LAMMPS's form: a along x, b in the xy plane, c with a positive z component.
struct LammpsBox {
  Cell cell;      //!< in that form; its origin is (xlo, ylo, zlo), Angstrom
  Mat3 rotation;  //!< turns the molecule's coordinates into those of the box
  bool triclinic() const {
    return cell.vectors(0, 1) != 0.0 || cell.vectors(0, 2) != 0.0 || cell.vectors(1, 2) != 0.0;
  }
};

//! \brief The box LAMMPS needs for a molecule.
//! \details Periodic directions keep the cell's vectors; tilts of more than half a box length, which LAMMPS
//! refuses, are reduced by whole lattice vectors, so that images count along different vectors than before.
//! Directions that are not periodic are made perpendicular to the others, where LAMMPS allows no tilt, and
//! leave the margin (Angstrom) on both sides of the atoms. Without atoms the box is as large as two margins
//! (at least 1).
LammpsBox lammps_box(const Molecule& molecule, double margin);

}  // namespace nanocarbon::molecule
