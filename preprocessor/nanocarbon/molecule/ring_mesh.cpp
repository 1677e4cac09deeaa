// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/ring_mesh.h"

#include <algorithm>
#include <limits>

namespace nanocarbon::molecule {

TriangleMesh ring_mesh(const Molecule& molecule) {
  double longest = std::numeric_limits<double>::infinity();
  if (molecule.cell) {
    const Vec3 heights = face_distances(*molecule.cell);
    for (int d = 0; d < 3; ++d)
      if (molecule.cell->periodic[d]) longest = std::min(longest, 0.5 * heights[d]);
  }
  TriangleMesh mesh{molecule.positions, {}};
  mesh.triangles.reserve(molecule.rings.atoms.size());
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    Vec3 sum = Vec3::Zero();
    bool whole = true;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Vec3 &a = molecule.positions[ring[k]], &b = molecule.positions[ring[(k + 1) % ring.size()]];
      whole = whole && (b - a).norm() < longest;
      sum += a;
    }
    if (!whole) continue;
    const auto centre = static_cast<VertexIndex>(mesh.points.size());
    mesh.points.push_back(sum / static_cast<double>(ring.size()));
    for (std::size_t k = 0; k < ring.size(); ++k)
      mesh.triangles.push_back({centre, ring[k], ring[(k + 1) % ring.size()]});
  }
  return mesh;
}

}  // namespace nanocarbon::molecule
