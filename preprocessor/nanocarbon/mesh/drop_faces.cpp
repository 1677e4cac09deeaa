#include "nanocarbon/mesh/drop_faces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/same_faces.h"

namespace nanocarbon {

bool repeats_a_vertex(std::span<const VertexIndex> face) {
  if (face.size() == 3) return face[0] == face[1] || face[1] == face[2] || face[2] == face[0];
  std::vector<VertexIndex> sorted(face.begin(), face.end());
  std::sort(sorted.begin(), sorted.end());
  return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
}

std::size_t drop_faces_repeating_a_vertex(PolygonSoup& soup) {
  // Repeated corners are overwritten first, and faces shrink in place.
  std::vector<std::uint32_t> size(soup.faces());
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    VertexIndex* const begin = soup.corners.data() + soup.offsets[face];
    VertexIndex* end = std::unique(begin, soup.corners.data() + soup.offsets[face + 1]);
    while (end - begin > 1 && *begin == *(end - 1)) --end;
    size[face] = static_cast<std::uint32_t>(end - begin);
  }
  PolygonSoup kept;
  kept.corners.reserve(soup.corners.size());
  kept.offsets.reserve(soup.offsets.size());
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    if (size[face] < 3) continue;
    const auto corners = soup.face(face).first(size[face]);
    kept.corners.insert(kept.corners.end(), corners.begin(), corners.end());
    kept.close_face();
  }
  const std::size_t dropped = soup.faces() - kept.faces();
  soup.corners = std::move(kept.corners);
  soup.offsets = std::move(kept.offsets);
  return dropped;
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

}  // namespace nanocarbon
