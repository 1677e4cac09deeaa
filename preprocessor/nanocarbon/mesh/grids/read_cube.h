// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/grids/scalar_field.h"

namespace nanocarbon::mesh {

//! \brief Reads a cube file (Gaussian): a field on a grid that may be skewed, in Bohr or Angstrom as it says. Atoms are
//! passed over.
//! \param array of several orbitals or values the one to take: its number in the file, or the orbital's
//! \throw UserError (malformed) with the line, (usage) where there are several and none is chosen
ScalarField read_cube(std::string_view text, const std::string& file, const std::string& array);

//! Whether lines 3 to 6 are those of a cube file: a count and a vector each.
bool begins_like_cube(std::string_view text);

}  // namespace nanocarbon::mesh
