#pragma once

#include <cstddef>
#include <span>

#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon {

//! Whether a face passes through a vertex more than once.
bool repeats_a_vertex(std::span<const VertexIndex> face);

//! \brief Takes corners out that repeat the corner before them, and drops faces that have fewer than three
//! left. \return how many faces were dropped. Faces that pass through a vertex twice at different places
//! stay.
std::size_t drop_faces_repeating_a_vertex(PolygonSoup& soup);

//! \brief Drops faces that have the same vertices in the same cyclic order as an earlier face.
//! \return how many were dropped
std::size_t drop_copied_faces(PolygonSoup& soup);

}  // namespace nanocarbon
