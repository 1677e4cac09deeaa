// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/sew_boundaries.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {
namespace {

struct Boundaries {
  std::vector<EdgeUse> sides;
  std::vector<VertexIndex> vertices;
  std::size_t not_manifold = 0;  // edges and vertices
  double median_length = 0.0;    // mesh units
};

Boundaries boundaries_of(const PolygonSoup& soup) {
  const EdgeTable edges = edge_table(soup);
  Boundaries boundaries;
  const auto begin = edges.offsets.begin(), end = edges.offsets.end();
  if (std::adjacent_find(begin, end, [](auto a, auto b) { return b == a + 1; }) == end) return boundaries;
  const MeshTopology topology = mesh_topology(soup, edges);
  boundaries.not_manifold = topology.non_manifold_edges.size() + topology.non_manifold_vertices.size();
  std::vector<double> lengths;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.uses_of(e).size() != 1) continue;
    boundaries.sides.push_back(edges.uses_of(e)[0]);
    boundaries.vertices.insert(boundaries.vertices.end(), {edges.low[e], edges.high[e]});
    lengths.push_back((soup.points[edges.high[e]] - soup.points[edges.low[e]]).norm());
  }
  std::sort(boundaries.vertices.begin(), boundaries.vertices.end());
  boundaries.vertices.erase(std::unique(boundaries.vertices.begin(), boundaries.vertices.end()),
                            boundaries.vertices.end());
  if (lengths.empty()) return boundaries;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  boundaries.median_length = *middle;
  return boundaries;
}

// Only vertices on boundaries may join, and only with each other.
std::size_t join_near(PolygonSoup& soup, const Boundaries& boundaries, double tolerance) {
  std::vector<Vec3> points;
  for (const VertexIndex v : boundaries.vertices) points.push_back(soup.points[v]);
  const CoincidentPoints found = points_within(points, tolerance);
  if (found.duplicates == 0) return 0;
  for (VertexIndex& corner : soup.corners) {
    const auto at = std::lower_bound(boundaries.vertices.begin(), boundaries.vertices.end(), corner);
    if (at != boundaries.vertices.end() && *at == corner)
      corner =
          boundaries
              .vertices[found.representative[static_cast<std::size_t>(at - boundaries.vertices.begin())]];
  }
  return found.duplicates;
}

struct Insertion {
  std::uint32_t corner;  // behind which the vertex comes
  double place;          // on the side from it, 0 to 1
  VertexIndex vertex;
};

// \param to_join vertices this near to a side's end are left to join it, at a wider tolerance: otherwise a slit would remain
// between the two, which nothing closes
std::vector<Insertion> junctions(const PolygonSoup& soup, const Boundaries& boundaries, double tolerance,
                                 double to_join) {
  TriangleMesh sides;  // without area, for the search only
  for (const EdgeUse& side : boundaries.sides) {
    const auto at = static_cast<VertexIndex>(sides.points.size());
    sides.points.push_back(soup.points[soup.corners[side.corner]]);
    sides.points.push_back(soup.points[soup.corners[next_corner(soup, side.face, side.corner)]]);
    sides.triangles.push_back({at, at + 1, at + 1});
  }
  const TriangleTree tree = triangle_tree(sides);
  std::vector<Insertion> found;
  for (const VertexIndex v : boundaries.vertices) {
    const Vec3& p = soup.points[v];
    const BoundingBox near{p - Vec3::Constant(tolerance), p + Vec3::Constant(tolerance)};
    visit_triangles(
        tree, [&](const BoundingBox& box) { return overlap(box, near); },
        [&](std::uint32_t side) {
          const Vec3 &a = sides.points[2 * side], &b = sides.points[2 * side + 1];
          const Vec3 along = b - a;
          const double place = (p - a).dot(along) / std::max(along.squaredNorm(), 1e-300);
          if (!(place > 0.0 && place < 1.0) || (a + place * along - p).norm() >= tolerance) return;
          if ((p - a).norm() <= to_join || (p - b).norm() <= to_join) return;
          found.push_back({boundaries.sides[side].corner, place, v});
        });
  }
  std::sort(found.begin(), found.end(), [](const Insertion& a, const Insertion& b) {
    return std::pair(a.corner, a.place) < std::pair(b.corner, b.place);
  });
  return found;
}

void insert(PolygonSoup& soup, const std::vector<Insertion>& insertions) {
  PolygonSoup result;
  auto next = insertions.begin();
  for (FaceIndex face = 0; face < soup.faces(); ++face) {
    for (std::uint32_t corner = soup.offsets[face]; corner < soup.offsets[face + 1]; ++corner) {
      result.corners.push_back(soup.corners[corner]);
      for (; next != insertions.end() && next->corner == corner; ++next)
        result.corners.push_back(next->vertex);
    }
    result.close_face();
  }
  soup.corners = std::move(result.corners);
  soup.offsets = std::move(result.offsets);
}

}  // namespace

std::optional<std::string> sew_boundaries(PolygonSoup& soup) {
  Boundaries before = boundaries_of(soup);
  std::size_t joined = 0, inserted = 0;
  double widest = 0.0;
  const double diagonal = bounding_box(soup.points).diagonal();
  for (const double share : {1e-6, 1e-5, 1e-4}) {
    const double most = 0.01 * before.median_length, tolerance = std::min(share * diagonal, most);
    if (before.sides.empty() || !(tolerance > widest)) break;
    PolygonSoup sewn = soup;
    const std::size_t vertices = join_near(sewn, before, tolerance);
    PolygonSoup unrepeated = sewn;
    if (vertices > 0 && drop_repeated_vertices(unrepeated) > 0) break;
    const std::vector<Insertion> on_sides = junctions(sewn, vertices > 0 ? boundaries_of(sewn) : before,
                                                      tolerance, std::min(1e-4 * diagonal, most));
    if (vertices + on_sides.size() == 0) continue;
    insert(sewn, on_sides);
    Boundaries after = boundaries_of(sewn);
    if (after.sides.size() >= before.sides.size() || after.not_manifold > before.not_manifold) continue;
    soup = std::move(sewn);
    before = std::move(after);
    joined += vertices;
    inserted += on_sides.size();
    widest = tolerance;
  }
  if (joined + inserted == 0) return std::nullopt;
  drop_unused_points(soup);
  std::string what;
  if (joined > 0) what = fmt::format("joined {} boundary vertices to others", joined);
  if (inserted > 0)
    what += fmt::format("{}made {} boundary vertices corners of the faces whose sides they lie on",
                        joined > 0 ? " and " : "", inserted);
  return fmt::format("sewed boundaries: {} within {:.3g} mesh units", what, widest);
}

}  // namespace nanocarbon::mesh
