// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/surface_tether.h"

#include <Eigen/Geometry>
#include <cmath>

#include "nanocarbon/core/chunks.h"

namespace nanocarbon::annealing {

namespace {

// Normals further apart than this cosine belong to the other side of a thin part, looked for up to this
// distance.
constexpr double other_side = -0.3, farthest_side = 8;  // Angstrom

TriangleMesh scaled_mesh(const TriangleMesh& surface, double scale) {
  TriangleMesh scaled = surface;
  rescale(scaled, scale);
  return scaled;
}

double angle_at(const Vec3& corner, const Vec3& a, const Vec3& b) {
  const Vec3 u = a - corner, v = b - corner;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

// Normals weighted by the angles of the triangles (Thürmer and Wüthrich 1998): independent of the
// triangulation.
std::vector<Vec3> vertex_normals_of(const TriangleMesh& mesh) {
  std::vector<Vec3> normals(mesh.points.size(), Vec3::Zero());
  for (const Triangle& t : mesh.triangles) {
    const std::array<Vec3, 3> p = corners_of(mesh, t);
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]).normalized();
    for (int s = 0; s < 3; ++s) normals[t[s]] += angle_at(p[s], p[(s + 1) % 3], p[(s + 2) % 3]) * normal;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

// Barycentric coordinates of a point of the triangle, by the areas of the parts.
Vec3 barycentric(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double area = normal.squaredNorm();
  if (area < 1e-30) return Vec3::Constant(1.0 / 3);
  return Vec3((c - b).cross(point - b).dot(normal), (a - c).cross(point - c).dot(normal),
              (b - a).cross(point - a).dot(normal)) /
         area;
}

}  // namespace

TetherSurface::TetherSurface(const TriangleMesh& surface, double scale)
    : scaled_(scaled_mesh(surface, scale)),
      nearest_(scaled_),
      tree_(mesh::triangle_tree(scaled_)),
      vertex_normals_(vertex_normals_of(scaled_)),
      boundary_(scaled_, vertex_normals_) {}

TangentPlane TetherSurface::plane_at(const Vec3& foot, std::uint32_t triangle) const {
  const Triangle& t = scaled_.triangles[triangle];
  const Vec3 a = scaled_.space.beside(scaled_.points[t[0]], foot);
  const Vec3 weight = barycentric(foot, a, scaled_.space.beside(scaled_.points[t[1]], a),
                                  scaled_.space.beside(scaled_.points[t[2]], a));
  Vec3 normal = weight[0] * vertex_normals_[t[0]] + weight[1] * vertex_normals_[t[1]] +
                weight[2] * vertex_normals_[t[2]];
  const double length = normal.norm();
  if (!(length > 1e-12)) normal = Vec3::UnitZ();
  return {foot, length > 1e-12 ? Vec3(normal / length) : normal};
}

TangentPlane TetherSurface::plane_at(const Vec3& position) const {
  const mesh::SurfacePoint found = nearest_.nearest(position);
  return plane_at(found.point, found.triangle);
}

TangentPlane TetherSurface::plane_at(const Vec3& position, const Vec3& facing) const {
  const TangentPlane nearest = plane_at(position);
  if (nearest.normal.dot(facing) > other_side) return nearest;
  double best = farthest_side * farthest_side;
  TangentPlane plane = nearest;
  scaled_.space.for_images([&](const Vec3& shift) {
    const Vec3 at = scaled_.space.wrapped(position) + shift;
    mesh::visit_triangles(
        tree_,
        [&](const mesh::BoundingBox& box) {
          return (at - at.cwiseMax(box.low).cwiseMin(box.high)).squaredNorm() < best;
        },
        [&](std::uint32_t triangle) {
          const auto [a, b, c] = corners_in_cell(scaled_, scaled_.triangles[triangle]);
          const Vec3 foot = mesh::nearest_on_triangle(at, a, b, c);
          if ((foot - at).squaredNorm() >= best) return;
          const TangentPlane candidate = plane_at(foot, triangle);
          if (candidate.normal.dot(facing) <= other_side) return;
          best = (foot - at).squaredNorm();
          plane = {candidate.point - (at - position), candidate.normal};
        });
  });
  return plane;
}

double TetherSurface::distance(const Vec3& position) const { return nearest_.nearest(position).distance; }

Vec3 TetherSurface::nearest(const Vec3& position) const { return nearest_.nearest(position).point; }

std::vector<TangentPlane> tangent_planes(const TetherSurface& surface, std::span<const Vec3> positions,
                                         std::span<const TangentPlane> former, ThreadTeam* team) {
  std::vector<TangentPlane> planes(positions.size());
  for_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t a = begin; a < end; ++a)
      planes[a] = former.size() == positions.size() ? surface.plane_at(positions[a], former[a].normal)
                                                    : surface.plane_at(positions[a]);
  });
  return planes;
}

double mean_height(std::span<const TangentPlane> planes, std::span<const Vec3> positions, ThreadTeam* team) {
  const double sum = sum_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    double part = 0;
    for (std::size_t a = begin; a < end; ++a) part += height_above(planes[a], positions[a]);
    return part;
  });
  return positions.empty() ? 0 : sum / static_cast<double>(positions.size());
}

double add_tether(std::span<const TangentPlane> planes, double stiffness, std::span<const Vec3> positions,
                  std::span<Vec3> gradient, bool free_mean, ThreadTeam* team) {
  const double mean = free_mean ? mean_height(planes, positions, team) : 0;
  return sum_chunks(team, positions.size(), [&](std::size_t begin, std::size_t end) {
    double energy = 0;
    for (std::size_t a = begin; a < end; ++a) {
      const double height = height_above(planes[a], positions[a]) - mean;
      gradient[a] += stiffness * height * planes[a].normal;
      energy += 0.5 * stiffness * height * height;
    }
    return energy;
  });
}

}  // namespace nanocarbon::annealing
