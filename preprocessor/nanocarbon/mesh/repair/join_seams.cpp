// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/repair/join_seams.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <vector>

#include "nanocarbon/mesh/drop_faces.h"
#include "nanocarbon/mesh/edge_table.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/mesh_topology.h"

namespace nanocarbon::mesh {
namespace {

struct Boundaries {
  std::size_t edges = 0;
  bool manifold = true;
  std::vector<bool> has_vertex;
  double median_length = 0.0;  // of boundary edges, mesh units
};

Boundaries boundaries_of(const PolygonSoup& soup) {
  const EdgeTable edges = edge_table(soup);
  Boundaries boundaries;
  boundaries.manifold = mesh_topology(soup, edges).manifold();
  boundaries.has_vertex.resize(soup.points.size(), false);
  std::vector<double> lengths;
  for (std::size_t e = 0; e < edges.size(); ++e) {
    if (edges.uses_of(e).size() != 1) continue;
    boundaries.has_vertex[edges.low[e]] = boundaries.has_vertex[edges.high[e]] = true;
    lengths.push_back((soup.points[edges.high[e]] - soup.points[edges.low[e]]).norm());
  }
  boundaries.edges = lengths.size();
  if (lengths.empty()) return boundaries;
  const auto middle = lengths.begin() + static_cast<std::ptrdiff_t>(lengths.size() / 2);
  std::nth_element(lengths.begin(), middle, lengths.end());
  boundaries.median_length = *middle;
  return boundaries;
}

// Only vertices on boundaries may join, and only with each other.
template <typename Find>
CoincidentPoints among_boundary_vertices(const PolygonSoup& soup, const Boundaries& boundaries,
                                         const Find& find) {
  std::vector<VertexIndex> on_boundary;
  std::vector<Vec3> points;
  for (VertexIndex v = 0; v < soup.points.size(); ++v)
    if (boundaries.has_vertex[v]) {
      on_boundary.push_back(v);
      points.push_back(soup.points[v]);
    }
  const CoincidentPoints found = find(points);
  CoincidentPoints result;
  result.duplicates = found.duplicates;
  result.representative.resize(soup.points.size());
  for (VertexIndex v = 0; v < soup.points.size(); ++v) result.representative[v] = v;
  for (std::size_t i = 0; i < on_boundary.size(); ++i)
    result.representative[on_boundary[i]] = on_boundary[found.representative[i]];
  return result;
}

bool is_better(const PolygonSoup& joined, const Boundaries& before) {
  PolygonSoup faces = joined;
  if (drop_repeated_vertices(faces) > 0) return false;
  const Boundaries after = boundaries_of(joined);
  return after.edges < before.edges && after.manifold;
}

// Joins, and returns how many vertices, if the result is accepted; 0 otherwise.
std::size_t try_to_join(PolygonSoup& soup, const CoincidentPoints& coincident, const Boundaries& before,
                        bool always) {
  if (coincident.duplicates == 0) return 0;
  PolygonSoup joined = soup;
  join(joined, coincident);
  if (!always && !is_better(joined, before)) return 0;
  soup = std::move(joined);
  return coincident.duplicates;
}

bool shares_nothing(const PolygonSoup& soup) {
  return soup.faces() > 1 && soup.corners.size() <= soup.points.size() &&
         mesh_topology(soup, edge_table(soup)).components == soup.faces();
}

}  // namespace

std::optional<std::string> join_seams(PolygonSoup& soup) {
  Boundaries boundaries = boundaries_of(soup);
  if (boundaries.edges == 0) return std::nullopt;
  const auto exactly = [](const std::vector<Vec3>& points) { return coincident_points(points); };
  std::size_t joined =
      try_to_join(soup, among_boundary_vertices(soup, boundaries, exactly), boundaries, shares_nothing(soup));
  std::string within = "the same place";
  if (!soup.has_vertex_numbers) {
    if (joined > 0) boundaries = boundaries_of(soup);
    const double tolerance =
        std::min(1e-6 * bounding_box(soup.points).diagonal(), 0.01 * boundaries.median_length);
    const auto nearly = [&](const std::vector<Vec3>& points) { return points_within(points, tolerance); };
    if (tolerance > 0.0)
      if (const std::size_t more =
              try_to_join(soup, among_boundary_vertices(soup, boundaries, nearly), boundaries, false)) {
        joined += more;
        within = fmt::format("a place within {:.3g} mesh units", tolerance);
      }
  }
  if (joined == 0) return std::nullopt;
  return fmt::format("joined {} boundary vertices to others at {}", joined, within);
}

}  // namespace nanocarbon::mesh
