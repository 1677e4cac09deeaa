// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "nanocarbon/core/cell.h"

namespace nanocarbon::mesh {

//! \brief A periodic cell in a comment of a mesh file, in the words of extended XYZ: Lattice="nine numbers"
//! Origin="three numbers" pbc="T T T".
//! \details Formats of meshes have no place for a cell. Edges a, b and c come one after the other; without an
//! origin it is at zero, without pbc all directions are periodic.
std::string cell_comment(const Cell& cell);

//! The cell in a comment ("#", or "comment" in the header of a PLY file) of a file; nothing where there is none.
//! \details Names in any case, as elsewhere, with either kind of quotes.
//! \throw UserError (malformed) naming the file where there is one, but not a cell
std::optional<Cell> cell_in_comment(std::string_view contents, const std::string& file);

}  // namespace nanocarbon::mesh
