// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/grids/grid_contents.h"

namespace nanocarbon::mesh {

//! \brief Reads VTK's files of XML, as ParaView writes them: PolyData (.vtp) and UnstructuredGrid (.vtu) as a surface,
//! of all pieces, ImageData (.vti) as a field.
//! \param array which of an image's arrays is the field; empty: the active or only one
//! \throw UserError (malformed) with the line, (usage) where an array has to be named
GridContents read_vtk_xml(std::string_view contents, const std::string& file, const std::string& array);

//! Whether contents begin with XML whose first element is VTKFile.
bool begins_like_vtk_xml(std::string_view contents);

}  // namespace nanocarbon::mesh
