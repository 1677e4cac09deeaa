// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <span>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

//! Whether a face passes through a vertex more than once.
bool repeats_a_vertex(std::span<const VertexIndex> face);

//! \brief Removes corners that repeat the previous corner, or that a face only goes to and back from; drops
//! faces that have fewer than three left.
//! \return how many faces were changed or dropped. Faces that pass through a vertex twice in other ways
//! stay.
std::size_t drop_repeated_vertices(PolygonSoup& soup);

//! \brief Drops faces that have the same vertices in the same cyclic order as an earlier face.
//! \return how many were dropped
std::size_t drop_copied_faces(PolygonSoup& soup);

}  // namespace nanocarbon::mesh
