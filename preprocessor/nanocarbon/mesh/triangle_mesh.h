// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "nanocarbon/core/vec3.h"

namespace nanocarbon {

using VertexIndex = std::uint32_t;
using Triangle = std::array<VertexIndex, 3>;

//! An indexed triangle mesh as plain data: the user's surface, a triangulation at rest, an example shape.
//! Triangles are wound counter-clockwise seen from outside. What is wrong with a mesh: mesh/diagnosis.h.
struct TriangleMesh {
  std::vector<Vec3> points;  //!< mesh units, or Angstrom once scaled
  std::vector<Triangle> triangles;
};

}  // namespace nanocarbon
