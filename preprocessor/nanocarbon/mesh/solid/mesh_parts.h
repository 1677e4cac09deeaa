// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "nanocarbon/mesh/polygon_soup.h"
#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Some faces of a mesh, in the order given, with the points that they use.
TriangleMesh part_of(const TriangleMesh& mesh, const std::vector<FaceIndex>& faces);

//! Adds the points and faces of another mesh after a mesh's own.
void append(TriangleMesh& mesh, const TriangleMesh& part);

}  // namespace nanocarbon::mesh
