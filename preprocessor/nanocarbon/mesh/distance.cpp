// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/distance.h"

#include <algorithm>
#include <cmath>

#include "nanocarbon/mesh/measures.h"

namespace nanocarbon::mesh {

DistanceStatistics distances_to_surface(std::span<const Vec3> points, const NearestPoint& surface) {
  DistanceStatistics result;
  result.points = points.size();
  if (points.empty()) return result;
  double sum = 0.0, squares = 0.0;
  std::uint32_t nearby = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint found = i == 0 ? surface.nearest(points[i]) : surface.nearest(points[i], nearby);
    nearby = found.triangle;
    sum += found.distance;
    squares += found.distance * found.distance;
    if (found.distance > result.max || i == 0) {
      result.max = found.distance;
      result.farthest = points[i];
    }
  }
  const auto n = static_cast<double>(points.size());
  result.mean = sum / n;
  result.rms = std::sqrt(squares / n);
  return result;
}

std::vector<Vec3> sample_by_area(const TriangleMesh& mesh, std::size_t samples) {
  std::vector<double> area_up_to;
  area_up_to.reserve(mesh.triangles.size());
  double sum = 0.0;
  for (const Triangle& corners : mesh.triangles) {
    const auto [a, b, c] = corners_of(mesh, corners);
    sum += area_normal(a, b, c).norm();
    area_up_to.push_back(sum);
  }
  std::vector<Vec3> points;
  if (!(sum > 0.0)) return points;
  points.reserve(samples);
  constexpr double plastic = 1.32471795724474602596;  // R2: multiples of 1/p and 1/p^2, modulo 1
  std::size_t triangle = 0;
  for (std::size_t i = 0; i < samples; ++i) {
    const double share = (static_cast<double>(i) + 0.5) / static_cast<double>(samples) * sum;
    while (triangle + 1 < area_up_to.size() && area_up_to[triangle] < share) ++triangle;
    const double k = static_cast<double>(i + 1);
    double u = std::fmod(k / plastic, 1.0);
    double v = std::fmod(k / (plastic * plastic), 1.0);
    if (u + v > 1.0) {
      u = 1.0 - u;
      v = 1.0 - v;
    }
    const auto [a, b, c] = corners_of(mesh, mesh.triangles[triangle]);
    points.push_back(a + u * (b - a) + v * (c - a));
  }
  return points;
}

namespace {

DistanceStatistics distances_of_area(const TriangleMesh& surface, const TriangleMesh& mesh,
                                     const NearestPoint& to_mesh, std::size_t samples) {
  if (samples == 0) samples = std::max(mesh.triangles.size(), surface.triangles.size());
  return distances_to_surface(sample_by_area(surface, samples), to_mesh);
}

}  // namespace

DistanceStatistics distances_of_area(const TriangleMesh& surface, const TriangleMesh& mesh,
                                     std::size_t samples) {
  return distances_of_area(surface, mesh, NearestPoint(mesh), samples);
}

SurfaceDistance distance_between(const TriangleMesh& mesh, const TriangleMesh& surface, std::size_t samples) {
  SurfaceDistance result;
  result.there = distances_to_surface(mesh.points, NearestPoint(surface));
  const NearestPoint to_mesh(mesh);
  result.back = distances_of_area(surface, mesh, to_mesh, samples);
  const DistanceStatistics vertices = distances_to_surface(surface.points, to_mesh);
  if (vertices.max > result.back.max || result.back.points == 0) {
    result.back.max = vertices.max;
    result.back.farthest = vertices.farthest;
  }
  return result;
}

}  // namespace nanocarbon::mesh
