// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/drop_faces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/same_faces.h"

namespace nanocarbon::mesh {

bool repeats_a_vertex(std::span<const VertexIndex> face) {
  if (face.size() == 3) return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  std::vector<VertexIndex> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

namespace {

// Takes out of a cycle what repeats the corner before it or goes to a vertex and straight back.
void take_out_repeats(std::span<const VertexIndex> face, std::vector<VertexIndex>& cycle) {
  cycle.clear();
  for (const VertexIndex v : face) {
    if (!cycle.empty() && cycle.back() == v) continue;
    if (cycle.size() >= 2 && cycle[cycle.size() - 2] == v)
      cycle.pop_back();
    else
      cycle.push_back(v);
  }
  auto begin = cycle.begin();
  while (cycle.end() - begin >= 2) {  // the same where the cycle closes
    if (*begin == cycle.back() || *begin == *(cycle.end() - 2))
      cycle.pop_back();
    else if (*(begin + 1) == cycle.back())
      ++begin;
    else
      break;
  }
  cycle.erase(cycle.begin(), begin);
}

}  // namespace

std::size_t drop_repeated_vertices(PolygonSoup& soup) {
  PolygonSoup kept;
  kept.corners.reserve(soup.corners.size());
  kept.offsets.reserve(soup.offsets.size());
  std::size_t changed = 0;
  std::vector<VertexIndex> cycle;
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    take_out_repeats(soup.face(face), cycle);
    if (cycle.size() != soup.face(face).size()) ++changed;
    if (cycle.size() < 3) continue;
    kept.corners.insert(kept.corners.end(), cycle.begin(), cycle.end());
    kept.close_face();
  }
  soup.corners = std::move(kept.corners);
  soup.offsets = std::move(kept.offsets);
  return changed;
}

std::size_t drop_copied_faces(PolygonSoup& soup) {
  const std::vector<SameFace> same = same_faces(soup);
  auto next = same.begin();
  PolygonSoup kept;
  std::size_t dropped = 0;
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    if (next != same.end() && next->face == face && (next++)->same_winding) {
      ++dropped;
      continue;
    }
    kept.corners.insert(kept.corners.end(), soup.face(face).begin(), soup.face(face).end());
    kept.close_face();
  }
  if (dropped == 0) return 0;
  soup.corners = std::move(kept.corners);
  soup.offsets = std::move(kept.offsets);
  return dropped;
}

}  // namespace nanocarbon::mesh
