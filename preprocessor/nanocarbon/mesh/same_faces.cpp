// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/same_faces.h"

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

namespace nanocarbon::mesh {
namespace {

// The same for every rotation and reflection of a face.
std::uint64_t hash(std::span<const VertexIndex> face) {
  std::uint64_t sum = 0;
  for (const VertexIndex v : face) {
    std::uint64_t h = (v + 1) * 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 31)) * 0xff51afd7ed558ccdull;
    sum += h ^ (h >> 33);
  }
  return sum;
}

// Whether b is a rotation of a, read forwards (step 1) or backwards (step -1).
bool is_rotation(std::span<const VertexIndex> a, std::span<const VertexIndex> b, bool forwards) {
  const std::size_t n = a.size();
  if (b.size() != n) return false;
  const auto start = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
  if (start == n) return false;
  for (std::size_t i = 0; i < n; ++i)
    if (a[i] != b[(start + (forwards ? i : n - i)) % n]) return false;
  return true;
}

}  // namespace

std::vector<SameFace> same_faces(const PolygonSoup& soup) {
  std::vector<std::pair<std::uint64_t, FaceIndex>> by_hash;
  by_hash.reserve(soup.faces());
  for (FaceIndex face = 0; face < soup.faces(); ++face) by_hash.emplace_back(hash(soup.face(face)), face);
  std::sort(by_hash.begin(), by_hash.end());
  std::vector<SameFace> same;
  std::size_t first = 0;  // of the faces with this hash; others with it by chance are not worth the search
  for (std::size_t i = 1; i < by_hash.size(); ++i) {
    if (by_hash[i].first != by_hash[first].first) {
      first = i;
      continue;
    }
    const FaceIndex face = by_hash[i].second;
    const FaceIndex earlier = by_hash[first].second;
    if (is_rotation(soup.face(earlier), soup.face(face), true))
      same.push_back({face, earlier, true});
    else if (is_rotation(soup.face(earlier), soup.face(face), false))
      same.push_back({face, earlier, false});
  }
  std::sort(same.begin(), same.end(), [](const SameFace& a, const SameFace& b) { return a.face < b.face; });
  return same;
}

}  // namespace nanocarbon::mesh
