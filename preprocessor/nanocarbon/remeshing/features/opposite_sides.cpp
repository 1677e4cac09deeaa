// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/opposite_sides.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "nanocarbon/core/disjoint_sets.h"
#include "nanocarbon/mesh/nearest_point.h"

namespace nanocarbon::features {
namespace {

// Sides lie along each other where the cosine between their normals is beyond this: wedges below 32 degrees.
constexpr double along = 0.85;
// The place opposite is sought within 45 degrees of the normal.
constexpr double within_cone = 0.7;

}  // namespace

double squared_distance(const mesh::BoundingBox& box, const Vec3& p) {
  return (p - p.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm();
}

Facets::Facets(const crystal::SurfaceGuide& guide) : mesh(guide.mesh()), tree(mesh::triangle_tree(mesh)) {
  const std::size_t n = mesh.triangles.size();
  DisjointSets sets(n);
  for (crystal::HalfEdgeIndex h = 0; h < 3 * n; ++h)
    if (const crystal::HalfEdgeIndex o = guide.table().twin(h); o != crystal::no_half_edge)
      sets.join(h / 3, o / 3);
  for (auto* of_all : {&centres, &normals}) of_all->reserve(n);
  areas.reserve(n);
  components.reserve(n);
  for (std::uint32_t t = 0; t < n; ++t) {
    const auto [a, b, c] = corners_in_cell(mesh, mesh.triangles[t]);
    centres.push_back((a + b + c) / 3);
    areas.push_back(0.5 * (b - a).cross(c - a).norm());
    components.push_back(sets.find(t));
    normals.push_back(guide.normal({centres.back(), {1.0 / 3, 1.0 / 3, 1.0 / 3}, t}));
  }
}

std::optional<Opposite> opposite(const Facets& facets, std::uint32_t from, double side, double reach) {
  Vec3 p = facets.centres[from];
  const Vec3 n = side * facets.normals[from];
  double best = reach * reach;
  Opposite found;
  // Of all boxes near by, those that reach into the cone: few of the sheet that the place itself is of. Of
  // others infinity.
  const auto distance_to = [&](const mesh::BoundingBox& box) {
    const double d2 = squared_distance(box, p);
    const double deepest =
        (0.5 * (box.low + box.high) - p).dot(n) + 0.5 * n.cwiseAbs().dot(box.high - box.low);
    const bool in_cone = deepest > 0 && deepest * deepest > within_cone * within_cone * d2;
    return in_cone ? d2 : std::numeric_limits<double>::infinity();
  };
  const auto look_at = [&](std::uint32_t t) {
    const double cosine = side * facets.normals[t].dot(n);
    if (cosine > -along && (cosine < along || facets.components[t] == facets.components[from])) return;
    const auto [a, b, c] = corners_in_cell(facets.mesh, facets.mesh.triangles[t]);
    const Vec3 q = mesh::nearest_on_triangle(p, a, b, c);
    const double d2 = (q - p).squaredNorm();
    if (d2 >= best || (q - p).dot(n) <= within_cone * std::sqrt(d2)) return;
    best = d2;
    found = {q - (p - facets.centres[from]), 0, cosine > 0};
  };
  // The nearer of two boxes first.
  const auto& nodes = facets.tree.nodes;
  std::array<std::pair<double, std::uint32_t>, mesh::TriangleTree::deepest + 1> waiting;
  facets.mesh.space.for_images([&](const Vec3& shift) {
    p = facets.centres[from] + shift;
    std::size_t height = 0;
    if (!nodes.empty()) waiting[height++] = {distance_to(nodes[0].box), 0};
    while (height > 0) {
      const auto [distance, at] = waiting[--height];
      if (!(distance < best)) continue;
      const auto& node = nodes[at];
      if (node.leaf()) {
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
          look_at(facets.tree.triangles[i]);
        continue;
      }
      std::pair<double, std::uint32_t> near{distance_to(nodes[node.first].box), node.first},
          far{distance_to(nodes[node.first + 1].box), node.first + 1};
      if (far.first < near.first) std::swap(near, far);
      if (far.first < best) waiting[height++] = far;
      if (near.first < best) waiting[height++] = near;
    }
  });
  if (best >= reach * reach) return std::nullopt;
  found.distance = std::sqrt(best);
  return found;
}

}  // namespace nanocarbon::features
