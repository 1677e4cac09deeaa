// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "nanocarbon/mesh/triangle_mesh.h"

namespace nanocarbon::python {

//! A surface that is fit for use, with what was done to get there.
struct Mesh {
  TriangleMesh mesh;
  std::vector<std::string> repairs, warnings;
};

}  // namespace nanocarbon::python
