// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

using Rgb = std::array<std::uint8_t, 3>;

struct ColouredEdge {
  VertexIndex a, b;
  Rgb colour;
};

//! Colours to go with a mesh into a file.
struct MeshColours {
  std::vector<Rgb> vertices;  //!< one for each vertex, or none at all
  std::vector<ColouredEdge> edges;
};

//! \brief The colours of the thesis's Figure 4.1.
//! \details Edges: green when shorter than the interval, blue within it, red when longer. Inner vertices:
//! green for a valence below 6, blue for 6, red above; boundary vertices, whose valence says nothing, grey.
//! \param shortest, longest the interval for edges of this mesh, in its units
MeshColours colours_by_quality(const TriangleMesh& mesh, double shortest, double longest);

}  // namespace nanocarbon::mesh
