// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <iosfwd>
#include <string>

#include "nanocarbon/molecule/formats/atom_style.h"
#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::molecule {

struct LammpsDataOptions {
  AtomStyle atom_style = AtomStyle::atomic;
  double margin = 10.0;  //!< Angstrom of empty box around the atoms in each direction that is not periodic
  std::string comment = {};  //!< put on the first line (command and version); must be a single line
};

//! \brief Writes a molecule as a LAMMPS data file.
//! \details Always two atom types, 1 = C and 2 = H, also where there is no hydrogen, so that one script
//! serves every file: `pair_coeff * * CH.rebo C H`. Masses carry the element as a comment. Atom-IDs are
//! indices plus one. Where the style has molecule-IDs, each connected component is a molecule; charges are
//! zero. Where the style has bonds (see has_bonds) there is a Bonds section, and a script must say
//! `special_bonds lj/coul 1 1 1`, because LAMMPS's default drops bonded neighbours that REBO needs; the file
//! says so in a comment. The comment "# boundary p p f" tells which directions are periodic, which LAMMPS
//! itself takes from the script.
//!
//! In periodic directions the box is the cell, atoms are wrapped into it, and image flags keep what they
//! were. A molecule whose cell is not in LAMMPS's form (a along x, b in the xy plane) is rotated into it. In
//! the other directions the box leaves the margin around the atoms. Numbers are the shortest text that reads
//! back exactly.
//! \throw UserError (unsuitable) naming the first atom that is not at finite coordinates
void write_lammps_data(std::ostream& out, const Molecule& molecule, const LammpsDataOptions& options = {});

//! The same, whole or not at all, to a file.
void write_lammps_data(const std::filesystem::path& path, const Molecule& molecule,
                       const LammpsDataOptions& options = {});

}  // namespace nanocarbon::molecule
