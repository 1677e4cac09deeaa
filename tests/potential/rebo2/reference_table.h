// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "nanocarbon/molecule/molecule.h"

namespace nanocarbon::test {

//! A structure and what LAMMPS's `pair_style rebo` says of it.
struct ReferenceEntry {
  std::string name;
  Molecule molecule;  //!< without bonds
  double energy;      //!< eV
  std::vector<Vec3> forces;
  Mat3 virial;
  std::vector<double> atom_energies;
};

std::vector<ReferenceEntry> read_reference_table(const std::filesystem::path& path);
void write_reference_table(const std::filesystem::path& path, const std::vector<ReferenceEntry>& entries);

}  // namespace nanocarbon::test
