// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/join_points.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace nanocarbon::mesh {
namespace {

constexpr VertexIndex none = std::numeric_limits<VertexIndex>::max();

std::uint64_t hash(const Vec3& point) {
  std::uint64_t h = 0x9e3779b97f4a7c15ull;
  for (int d = 0; d < 3; ++d) {
    h ^= std::bit_cast<std::uint64_t>(point[d] + 0.0);  // -0 becomes 0
    h *= 0xff51afd7ed558ccdull;
    h ^= h >> 32;
  }
  return h;
}

}  // namespace

CoincidentPoints coincident_points(std::span<const Vec3> points) {
  CoincidentPoints result;
  result.representative.resize(points.size());
  const std::size_t slots = std::bit_ceil(2 * points.size() + 1);
  std::vector<VertexIndex> table(slots, none);
  for (VertexIndex i = 0; i < points.size(); ++i) {
    std::size_t slot = static_cast<std::size_t>(hash(points[i])) & (slots - 1);
    while (table[slot] != none && points[table[slot]] != points[i]) slot = (slot + 1) & (slots - 1);
    if (table[slot] == none)
      table[slot] = i;
    else
      ++result.duplicates;
    result.representative[i] = table[slot];
  }
  return result;
}

CoincidentPoints points_within(std::span<const Vec3> points, double tolerance) {
  CoincidentPoints result;
  result.representative.resize(points.size());
  // Representatives by the cell they are in; they keep a distance, so that a cell holds only a few. Cells are
  // counted in double, where no extent can overflow.
  const auto cell_of = [&](const Vec3& point) { return Vec3((point / tolerance).array().floor()); };
  const auto by_hash = [](const Vec3& cell) { return static_cast<std::size_t>(hash(cell)); };
  std::unordered_multimap<Vec3, VertexIndex, decltype(by_hash)> cells(2 * points.size(), by_hash);
  for (VertexIndex i = 0; i < points.size(); ++i) {
    VertexIndex nearest = i;
    for (int n = 0; n < 27; ++n) {
      const Vec3 offset(n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
      const auto [begin, end] = cells.equal_range(cell_of(points[i]) + offset);
      for (auto at = begin; at != end; ++at)
        if ((points[at->second] - points[i]).norm() < tolerance) nearest = std::min(nearest, at->second);
    }
    result.representative[i] = nearest;
    if (nearest == i)
      cells.emplace(cell_of(points[i]), i);
    else
      ++result.duplicates;
  }
  return result;
}

CoincidentPoints ends_of_short_edges(const PolygonSoup& soup, double tolerance) {
  CoincidentPoints result;
  std::vector<VertexIndex>& first = result.representative;
  first.resize(soup.points.size());
  std::iota(first.begin(), first.end(), VertexIndex{0});
  const auto root = [&](VertexIndex v) {
    while (first[v] != v) v = first[v] = first[first[v]];
    return v;
  };
  for (std::size_t face = 0; face < soup.faces(); ++face) {
    const auto corners = soup.face(face);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexIndex a = corners[k], b = corners[(k + 1) % corners.size()];
      if (a == b || (soup.points[a] - soup.points[b]).squaredNorm() >= tolerance * tolerance) continue;
      const VertexIndex of_a = root(a), of_b = root(b);
      if (of_a == of_b) continue;
      first[std::max(of_a, of_b)] = std::min(of_a, of_b);
      ++result.duplicates;
    }
  }
  for (VertexIndex v = 0; v < first.size(); ++v) first[v] = root(v);
  return result;
}

void join(PolygonSoup& soup, const CoincidentPoints& coincident) {
  for (VertexIndex& corner : soup.corners) corner = coincident.representative[corner];
  std::vector<VertexIndex> renamed(soup.points.size(), none);
  VertexIndex kept = 0;
  for (VertexIndex i = 0; i < soup.points.size(); ++i)
    if (coincident.representative[i] == i) {
      soup.points[kept] = soup.points[i];
      renamed[i] = kept++;
    }
  soup.points.resize(kept);
  for (VertexIndex& corner : soup.corners) corner = renamed[corner];
}

std::size_t drop_unused_points(PolygonSoup& soup) {
  std::vector<VertexIndex> renamed(soup.points.size(), none);
  for (const VertexIndex corner : soup.corners) renamed[corner] = 0;
  VertexIndex kept = 0;
  for (std::size_t i = 0; i < renamed.size(); ++i)
    if (renamed[i] != none) {
      soup.points[kept] = soup.points[i];
      renamed[i] = kept++;
    }
  const std::size_t dropped = soup.points.size() - kept;
  if (dropped == 0) return 0;
  soup.points.resize(kept);
  for (VertexIndex& corner : soup.corners) corner = renamed[corner];
  return dropped;
}

std::size_t drop_unused_points(TriangleMesh& mesh) {
  PolygonSoup soup = soup_of(mesh);
  const std::size_t dropped = drop_unused_points(soup);
  mesh.points = std::move(soup.points);
  for (std::size_t corner = 0; corner < soup.corners.size(); ++corner)
    mesh.triangles[corner / 3][corner % 3] = soup.corners[corner];
  return dropped;
}

}  // namespace nanocarbon::mesh
