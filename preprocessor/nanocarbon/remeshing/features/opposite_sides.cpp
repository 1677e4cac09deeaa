// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/opposite_sides.h"

#include <Eigen/Geometry>
#include <cmath>

#include "nanocarbon/mesh/mesh_topology.h"
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
  const mesh::MeshTopology topology = mesh::mesh_topology(mesh);
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const Triangle& f = mesh.triangles[t];
    const Vec3 &a = mesh.points[f[0]], &b = mesh.points[f[1]], &c = mesh.points[f[2]];
    centres.push_back((a + b + c) / 3);
    areas.push_back(0.5 * (b - a).cross(c - a).norm());
    components.push_back(topology.component_of_face[t]);
    normals.push_back(guide.normal({centres.back(), {1.0 / 3, 1.0 / 3, 1.0 / 3}, t}));
  }
}

std::optional<Opposite> opposite(const Facets& facets, std::uint32_t from, double side, double reach) {
  const Vec3& p = facets.centres[from];
  const Vec3& n = facets.normals[from];
  double best = reach * reach;
  Opposite found;
  // Of all boxes near by, those that reach into the cone: few of the sheet that the place itself is of.
  const auto may_hold = [&](const mesh::BoundingBox& box) {
    const double d2 = squared_distance(box, p);
    const double deepest =
        side * (0.5 * (box.low + box.high) - p).dot(n) + 0.5 * n.cwiseAbs().dot(box.extent());
    return d2 < best && deepest > 0 && deepest * deepest > within_cone * within_cone * d2;
  };
  mesh::visit_triangles(facets.tree, may_hold, [&](std::uint32_t t) {
    const double cosine = facets.normals[t].dot(n);
    if (cosine > -along && (cosine < along || facets.components[t] == facets.components[from])) return;
    const Triangle& f = facets.mesh.triangles[t];
    const Vec3 q = mesh::nearest_on_triangle(p, facets.mesh.points[f[0]], facets.mesh.points[f[1]],
                                             facets.mesh.points[f[2]]);
    const double d2 = (q - p).squaredNorm();
    if (d2 >= best || side * (q - p).dot(n) <= within_cone * std::sqrt(d2)) return;
    best = d2;
    found = {q, 0, cosine > 0};
  });
  if (best >= reach * reach) return std::nullopt;
  found.distance = std::sqrt(best);
  return found;
}

}  // namespace nanocarbon::features
