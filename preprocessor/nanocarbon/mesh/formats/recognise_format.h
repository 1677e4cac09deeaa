// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/formats/mesh_format.h"

namespace nanocarbon::mesh {

//! \brief The format of a file: by what it contains, and only where that does not tell, by its extension.
//! \throw UserError (malformed) where neither tells, saying what the file is, if it is something well known
MeshFormat recognised_format(std::string_view contents, const std::string& file);

//! Whether contents are text in UTF-16, of either byte order, with or without a mark.
bool is_utf16(std::string_view contents);

}  // namespace nanocarbon::mesh
