// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/core/vec3.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! \brief Whether two triangles of a mesh meet elsewhere than in the vertices or the edge they share.
//! \details Exact; touching counts. Triangles without area meet nothing.
bool intersect(const TriangleMesh& mesh, const Triangle& first, const Triangle& second);

//! How a segment goes through a triangle.
enum class Crossing { none, through, degenerate };

//! Whether the segment from p to q passes through the inside of a triangle; degenerate where it meets its
//! boundary, ends in it or lies in its plane. Exact.
Crossing crossing(const Vec3& p, const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace nanocarbon::mesh
