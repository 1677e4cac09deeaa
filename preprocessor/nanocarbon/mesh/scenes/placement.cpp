// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/scenes/placement.h"

#include <Eigen/LU>
#include <algorithm>

#include "nanocarbon/mesh/parsing/text_scanner.h"

namespace nanocarbon::mesh {

bool add_placed(PolygonSoup& to, const PolygonSoup& object, const Placement& placement) {
  const auto first = static_cast<VertexIndex>(to.points.size());
  for (const Vec3& point : object.points) {
    const Vec3 placed = placement * point;
    for (const double x : placed)
      if (coordinate_fault(x)) return false;
    to.points.push_back(placed);
  }
  const bool turned = placement.linear().determinant() < 0.0;
  for (std::size_t face = 0; face < object.faces(); ++face) {
    const auto begin = static_cast<std::ptrdiff_t>(to.corners.size());
    for (const VertexIndex v : object.face(face)) to.corners.push_back(first + v);
    if (turned) std::reverse(to.corners.begin() + begin, to.corners.end());
    to.close_face();
  }
  return true;
}

}  // namespace nanocarbon::mesh
