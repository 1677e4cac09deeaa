// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/edge_table.h"

#include <algorithm>

namespace nanocarbon::mesh {
namespace {

struct Side {
  VertexIndex high;
  EdgeUse use;
};

}  // namespace

EdgeTable edge_table(const PolygonSoup& soup) {
  // Sides in buckets by their lower vertex, then sorted by the higher one within the (small) bucket.
  std::vector<std::uint32_t> bucket(soup.points.size() + 1, 0);
  const auto for_each_side = [&](const auto& visit) {
    for (FaceIndex face = 0; face < soup.faces(); ++face)
      for (std::uint32_t corner = soup.offsets[face]; corner < soup.offsets[face + 1]; ++corner) {
        const VertexIndex from = soup.corners[corner];
        const VertexIndex to = soup.corners[next_corner(soup, face, corner)];
        if (from != to) visit(std::min(from, to), Side{std::max(from, to), {face, corner, from < to}});
      }
  };
  for_each_side([&](VertexIndex low, const Side&) { ++bucket[low + 1]; });
  for (std::size_t v = 0; v < soup.points.size(); ++v) bucket[v + 1] += bucket[v];
  std::vector<Side> sides(bucket.back());
  std::vector<std::uint32_t> fill(bucket.begin(), bucket.end() - 1);
  for_each_side([&](VertexIndex low, const Side& side) { sides[fill[low]++] = side; });

  EdgeTable table;
  table.uses.reserve(sides.size());
  table.low.reserve(sides.size() / 2);
  table.high.reserve(sides.size() / 2);
  table.offsets.reserve(sides.size() / 2 + 1);
  for (VertexIndex low = 0; low < soup.points.size(); ++low) {
    const auto begin = sides.begin() + bucket[low];
    const auto end = sides.begin() + bucket[low + 1];
    std::sort(begin, end, [](const Side& a, const Side& b) {
      return a.high != b.high ? a.high < b.high : a.use.corner < b.use.corner;
    });
    for (auto side = begin; side != end; ++side) {
      if (side == begin || side->high != (side - 1)->high) {
        table.low.push_back(low);
        table.high.push_back(side->high);
        table.offsets.push_back(table.offsets.back());
      }
      table.uses.push_back(side->use);
      ++table.offsets.back();
    }
  }
  return table;
}

DisjointSets face_sides(std::size_t faces, const EdgeTable& edges) {
  DisjointSets sides(2 * faces);
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto uses = edges.uses_of(e);
    if (uses.size() != 2) continue;
    const std::uint32_t turned = uses[0].forward == uses[1].forward ? 1 : 0;
    sides.join(2 * uses[0].face, 2 * uses[1].face + turned);
    sides.join(2 * uses[0].face + 1, 2 * uses[1].face + 1 - turned);
  }
  return sides;
}

}  // namespace nanocarbon::mesh
