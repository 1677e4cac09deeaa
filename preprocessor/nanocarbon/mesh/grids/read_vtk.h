// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/grids/grid_contents.h"

namespace nanocarbon::mesh {

//! \brief Reads VTK's older files (.vtk, versions 1 to 5.1), text or binary: POLYDATA and UNSTRUCTURED_GRID as a surface,
//! STRUCTURED_POINTS as a field.
//! \param array which of an image's arrays is the field; empty: the only one
//! \throw UserError (malformed) with the line, or the byte where data is binary; (usage) where an array has to be named
GridContents read_vtk(std::string_view contents, const std::string& file, const std::string& array);

bool begins_like_vtk(std::string_view contents);

}  // namespace nanocarbon::mesh
