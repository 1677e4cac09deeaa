// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/match_images.h"

#include <array>
#include <cstdint>

#include "nanocarbon/core/neighbours_within.h"

namespace nanocarbon::mesh {

Partners match_images(const TriangleMesh& mesh, const Cell& cell, std::span<const VertexIndex> boundary,
                      double reach) {
  std::vector<Vec3> points;
  for (const VertexIndex v : boundary) points.push_back(mesh.points[v]);
  const NeighbourList near = neighbours_within(points, &cell, reach);
  Partners partners(mesh.points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i)
    for (const Neighbour& n : near.of(i))
      if (n.image != std::array<std::int32_t, 3>{0, 0, 0} && n.atom != i)
        partners[boundary[i]].push_back(boundary[n.atom]);
  return partners;
}

}  // namespace nanocarbon::mesh
