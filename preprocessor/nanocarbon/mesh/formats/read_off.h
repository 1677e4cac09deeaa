// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads an OFF file (Geomview), with COFF, NOFF, STOFF and their combinations: one vertex or face
//! on a line; a face's corners may go on on the next ones.
//! \details Colours, normals and texture coordinates are passed over. Counts may stand on the header's
//! line, the header may be missing. "OFF BINARY" is read as well. Points in four or more dimensions are refused.
//! \throw UserError (malformed)
PolygonSoup read_off(std::string_view text, const std::string& file);

//! Whether a file's first line begins with the header of an OFF file, plain or a variant ("OFF", "STCNOFF",
//! "4OFF").
bool begins_like_off(std::string_view line);

}  // namespace nanocarbon::mesh
