// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/self_intersections.h"

#include <algorithm>

#include "nanocarbon/mesh/triangle_intersection.h"
#include "nanocarbon/mesh/triangle_tree.h"

namespace nanocarbon::mesh {
namespace {

constexpr std::size_t most_pairs = 100'000;
constexpr std::size_t most_tries_per_triangle = 64;  // a surface of even triangles needs about 10
constexpr std::size_t tries_always_allowed = 20'000'000;

// Images of one vertex differ by rounding; others are farther apart. Share of the cell's least width.
constexpr double same_vertex = 1e-9;

// Of two triangles in a cell, each in a place of its own: what they share is told by place.
bool intersect_in_place(const std::array<Vec3, 3>& first, const std::array<Vec3, 3>& second, double same) {
  TriangleMesh pair{{first[0], first[1], first[2]}, {}};
  Triangle other;
  for (std::size_t k = 0; k < 3; ++k) {
    other[k] = static_cast<VertexIndex>(pair.points.size());
    for (VertexIndex v = 0; v < 3; ++v)
      if ((first[v] - second[k]).squaredNorm() < same * same) other[k] = v;
    if (other[k] == pair.points.size()) pair.points.push_back(second[k]);
  }
  return intersect(pair, {0, 1, 2}, other);
}

// The pairs of triangles of a mesh whose boxes overlap are tried; in a cell in every image.
class Search {
 public:
  explicit Search(const TriangleMesh& mesh)
      : mesh_(mesh),
        tree_(triangle_tree(mesh)),
        boxes_(mesh.triangles.size()),
        same_(mesh.space.periodic() ? same_vertex * mesh.space.least_width() : 0.0) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
      for (const Vec3& corner : corners_in_cell(mesh, mesh.triangles[t])) boxes_[t].include(corner);
  }

  SelfIntersections run() {
    const std::size_t most_tries = tries_always_allowed + most_tries_per_triangle * mesh_.triangles.size();
    for (const std::uint32_t first : tree_.triangles) {
      mesh_.space.for_images([&](const Vec3& shift) { visit(first, shift); });
      if (tries_ > most_tries || result_.pairs.size() > most_pairs) {
        result_.complete = false;
        break;
      }
    }
    std::sort(result_.pairs.begin(), result_.pairs.end());
    result_.pairs.erase(std::unique(result_.pairs.begin(), result_.pairs.end()), result_.pairs.end());
    return std::move(result_);
  }

 private:
  // The first triangle, moved by a translation of the cell, against those that come after it.
  void visit(std::uint32_t first, const Vec3& shift) {
    const BoundingBox box{boxes_[first].low + shift, boxes_[first].high + shift};
    visit_triangles(
        tree_, [&](const BoundingBox& other) { return overlap(box, other); },
        [&](std::uint32_t second) {
          if (second <= first || !overlap(box, boxes_[second])) return;
          ++tries_;
          if (meet(first, second, shift)) result_.pairs.push_back({first, second});
        });
  }

  bool meet(std::uint32_t first, std::uint32_t second, const Vec3& shift) const {
    const Triangle &one = mesh_.triangles[first], &other = mesh_.triangles[second];
    if (!mesh_.space.periodic()) return intersect(mesh_, one, other);
    std::array<Vec3, 3> moved = corners_in_cell(mesh_, one);
    for (Vec3& corner : moved) corner += shift;
    return intersect_in_place(moved, corners_in_cell(mesh_, other), same_);
  }

  const TriangleMesh& mesh_;
  const TriangleTree tree_;
  std::vector<BoundingBox> boxes_;
  const double same_;
  std::size_t tries_ = 0;
  SelfIntersections result_;
};

}  // namespace

SelfIntersections self_intersections(const TriangleMesh& mesh) { return Search(mesh).run(); }

}  // namespace nanocarbon::mesh
