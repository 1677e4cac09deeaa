// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "nanocarbon/molecule/formats/atom_columns.h"
#include "nanocarbon/molecule/formats/read_settings.h"
#include "nanocarbon/molecule/formats/type_elements.h"

namespace nanocarbon::molecule {

// The inner parts of read_lammps_data: what the lines of a data file say, before it makes a molecule.

struct LammpsBond {
  std::int64_t first, second;  //!< atom-IDs
  std::size_t line;
};

struct LammpsFile {
  std::size_t atom_count = 0, type_count = 0, bond_count = 0;  //!< as the header says
  Cell box{Mat3::Zero(), Vec3::Zero(), {true, true, true}};
  std::optional<std::array<bool, 3>> boundary;
  LammpsTypes types;
  TypeLabels labels;
  std::vector<LammpsAtom> atoms;
  std::vector<LammpsBond> bonds;
};

//! Makes the molecule.
//! \throw UserError as read_lammps_data
MoleculeFrame assemble(const TextInput& input, LammpsFile file, ReadSettings& settings);

}  // namespace nanocarbon::molecule
