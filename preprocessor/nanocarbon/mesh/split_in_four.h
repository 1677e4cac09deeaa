// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::mesh {

//! Every triangle split into four by the middles of its edges: the same surface with edges half as long.
TriangleMesh split_in_four(const TriangleMesh& mesh);

}  // namespace nanocarbon::mesh
