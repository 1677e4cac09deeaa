// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/measures.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace nanocarbon::mesh {

void BoundingBox::include(const Vec3& point) {
  low = low.cwiseMin(point);
  high = high.cwiseMax(point);
}

bool meets_segment(const BoundingBox& box, const Vec3& p, const Vec3& q) {
  // Separating axes: the box's three, and those normal to the segment and one of them (Ericson, 5.3.3). The
  // margin covers rounding.
  const Vec3 half = 0.5 * (box.high - box.low);
  const Vec3 middle = 0.5 * (p + q) - 0.5 * (box.high + box.low);
  const Vec3 reach = 0.5 * (q - p);
  const double margin = 1e-12 * (middle.cwiseAbs().sum() + reach.cwiseAbs().sum() + half.sum());
  if ((middle.cwiseAbs().array() > half.array() + reach.cwiseAbs().array() + margin).any()) return false;
  const Vec3 across = middle.cross(reach).cwiseAbs();
  const Vec3 r = reach.cwiseAbs();
  const double wide = margin * r.sum();
  return across.x() <= half.y() * r.z() + half.z() * r.y() + wide &&
         across.y() <= half.x() * r.z() + half.z() * r.x() + wide &&
         across.z() <= half.x() * r.y() + half.y() * r.x() + wide;
}

BoundingBox bounding_box(std::span<const Vec3> points) {
  BoundingBox box;
  for (const Vec3& point : points) box.include(point);
  return box;
}

EdgeLengths edge_lengths(std::span<const Vec3> points, const EdgeTable& edges, const Space& space) {
  EdgeLengths result;
  result.edges = edges.size();
  if (edges.size() == 0) return result;
  result.min = 1e300;
  const auto length = [&](std::size_t e) {
    return space.displacement(points[edges.low[e]], points[edges.high[e]]).norm();
  };
  for (std::size_t e = 0; e < edges.size(); ++e) {
    result.min = std::min(result.min, length(e));
    result.max = std::max(result.max, length(e));
    result.mean += length(e);
  }
  const auto n = static_cast<double>(edges.size());
  result.mean /= n;
  double squares = 0.0;
  for (std::size_t e = 0; e < edges.size(); ++e) squares += std::pow(length(e) - result.mean, 2);
  result.standard_deviation = std::sqrt(squares / n);
  return result;
}

EdgeLengths edge_lengths(const TriangleMesh& mesh) {
  return edge_lengths(mesh.points, edge_table(soup_of(mesh)), mesh.space);
}

Vec3 area_normal(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Triangle& triangle : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, triangle);
    sum += 0.5 * area_normal(a, b, c).norm();
  }
  return sum;
}

Vec3 newell_normal(std::span<const Vec3> points, std::span<const VertexIndex> corners) {
  const Vec3 origin = points[corners[0]];
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    normal += (points[corners[i]] - origin).cross(points[corners[i + 1]] - origin);
  return normal;
}

bool has_no_area(std::span<const Vec3> points, std::span<const VertexIndex> corners) {
  double longest_squared = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3 side = points[corners[(i + 1) % corners.size()]] - points[corners[i]];
    longest_squared = std::max(longest_squared, side.squaredNorm());
  }
  return newell_normal(points, corners).norm() <= 1e-10 * longest_squared;
}

// Taken from a point of the mesh, so that a mesh far from the origin loses no digits.
double signed_volume(const PolygonSoup& soup) {
  if (soup.faces() == 0) return 0.0;
  const Vec3 origin = soup.points[soup.corners[0]];
  double sum = 0.0;
  for (std::size_t face = 0; face < soup.faces(); ++face)
    sum += (soup.points[soup.face(face)[0]] - origin).dot(newell_normal(soup.points, soup.face(face))) / 6.0;
  return sum;
}

double signed_volume(const TriangleMesh& mesh) { return signed_volume(soup_of(mesh)); }

}  // namespace nanocarbon::mesh
