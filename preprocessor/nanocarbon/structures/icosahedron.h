#pragma once

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon {

//! The regular icosahedron centred on the origin, oriented outward, its edges of the given length.
TriangleMesh icosahedron(double edge);

}  // namespace nanocarbon
