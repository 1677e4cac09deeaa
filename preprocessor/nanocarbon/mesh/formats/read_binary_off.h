// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>

#include "nanocarbon/mesh/parsing/value_cursor.h"
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! \brief Reads what follows the header's line of a binary OFF file (Geomview): the numbers of vertices, faces and edges,
//! the vertices, and each face with its corners and colour.
//! \details All numbers have 32 bits, coordinates are floats, the order is big-endian. Where the counts make sense in the
//! other order only, that is taken, and told in a note.
//! \param cursor where the counts begin
//! \param reals numbers of a vertex: coordinates first; a normal, a colour and a place in a texture are passed over
//! \throw UserError (malformed) naming the byte
PolygonSoup read_binary_off(ValueCursor cursor, std::size_t reals);

}  // namespace nanocarbon::mesh
