// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/formats/write_molecule.h"

#include <fmt/format.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/molecule/formats/xyz.h"

namespace nanocarbon::molecule {

void write_molecule(const std::filesystem::path& path, const Molecule& molecule,
                    const LammpsDataOptions& options) {
  const std::string extension = path.extension().string();
  if (extension == ".data")
    write_lammps_data(path, molecule, options);
  else if (extension == ".xyz" || extension == ".extxyz")
    write_xyz(path, molecule, options.comment);
  else
    throw UserError(Failure::usage,
                    fmt::format("{}: name the file .data (LAMMPS) or .xyz (extended XYZ)", path.string()));
}

}  // namespace nanocarbon::molecule
