// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::shapes {

//! The regular icosahedron centred on the origin, oriented outward, its edges of the given length.
TriangleMesh icosahedron(double edge);

}  // namespace nanocarbon::shapes
