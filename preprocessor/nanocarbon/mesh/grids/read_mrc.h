// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/grids/scalar_field.h"

namespace nanocarbon::mesh {

//! \brief Reads a map of electron microscopy or crystallography (MRC 2014, CCP4): modes 0, 1, 2, 6 and 12, either byte
//! order, any order of axes, skewed cells; in Angstrom.
//! \throw UserError (malformed) with the byte
ScalarField read_mrc(std::string_view bytes, const std::string& file);

//! Whether the header is that of a map: "MAP" at byte 208.
bool begins_like_mrc(std::string_view bytes);

}  // namespace nanocarbon::mesh
