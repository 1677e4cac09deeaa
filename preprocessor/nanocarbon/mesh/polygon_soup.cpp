// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/polygon_soup.h"

namespace nanocarbon::mesh {

PolygonSoup soup_of(const TriangleMesh& mesh) {
  PolygonSoup soup;
  soup.points = mesh.points;
  soup.corners.reserve(3 * mesh.triangles.size());
  soup.offsets.reserve(mesh.triangles.size() + 1);
  for (const Triangle& triangle : mesh.triangles) {
    soup.corners.insert(soup.corners.end(), triangle.begin(), triangle.end());
    soup.close_face();
  }
  return soup;
}

}  // namespace nanocarbon::mesh
