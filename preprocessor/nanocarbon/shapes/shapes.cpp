// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/shapes.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/shapes/goldberg_coxeter.h"
#include "nanocarbon/shapes/icosahedron.h"
#include "nanocarbon/shapes/loft.h"

namespace nanocarbon::shapes {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double equilateral_height = 0.5 * std::numbers::sqrt3;

void require(bool condition, const char* what) {
  if (!condition) throw UserError(Failure::usage, what);
}

//! Before any are made, so that neither memory nor the numbers of rows run over.
void require_few_triangles(double area, double edge) {
  const double triangles = area / (0.5 * equilateral_height * edge * edge);
  if (!(triangles <= 2e7))
    throw UserError(
        Failure::usage,
        fmt::format("that would be {:.2g} triangles; the limit is 20 million: use a longer edge", triangles));
}

int steps(double length, double step, int fewest) {
  return std::max(fewest, static_cast<int>(std::lround(length / step)));
}

//! Loops of a hemisphere around `centre`, from its boundary (not included) to its pole in the direction x cross y.
std::vector<Loop> dome(const Vec3& centre, const Vec3& x, const Vec3& y, double radius, double edge,
                       double turn) {
  std::vector<Loop> loops;
  const int rows = steps(0.5 * pi * radius, equilateral_height * edge, 2);
  for (int i = 1; i < rows; ++i) {
    const double latitude = 0.5 * pi * i / rows;
    turn = 0.5 - turn;
    loops.push_back(circle(centre + radius * std::sin(latitude) * x.cross(y), x, y,
                           radius * std::cos(latitude), edge, turn));
  }
  loops.push_back({centre + radius * x.cross(y)});
  return loops;
}

}  // namespace

TriangleMesh make_sphere(double radius, int subdivisions) {
  require(radius > 0.0, "the radius of a sphere must be above zero");
  require(subdivisions >= 1 && subdivisions <= 1000, "a sphere takes 1 to 1000 subdivisions");
  TriangleMesh mesh = goldberg_coxeter(icosahedron(1.0), subdivisions, 0);
  for (Vec3& point : mesh.points) point *= radius / point.norm();
  return mesh;
}

TriangleMesh make_nested_spheres(const NestedSpheres& s) {
  require(s.radius > 0.0 && s.gap > 0.0 && s.edge > 0.0, "the lengths of nested spheres must be above zero");
  require(s.count >= 1 && s.count <= 100, "1 to 100 spheres can be nested");
  require(s.edge <= 1.5 * s.radius, "the edge must not be longer than 1.5 radii");
  double area = 0.0;
  for (int i = 0; i < s.count; ++i) area += 4.0 * pi * std::pow(s.radius + i * s.gap, 2);
  require_few_triangles(area, s.edge);
  // The edge of an icosahedron in a sphere of radius 1.
  const double icosahedron_edge = 1.0 / std::sin(0.4 * pi);
  TriangleMesh all;
  for (int i = 0; i < s.count; ++i) {
    const double radius = s.radius + i * s.gap;
    const TriangleMesh one = make_sphere(radius, std::min(1000, steps(icosahedron_edge * radius, s.edge, 1)));
    const auto first = static_cast<VertexIndex>(all.points.size());
    all.points.insert(all.points.end(), one.points.begin(), one.points.end());
    for (const Triangle& t : one.triangles)
      all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
  return all;
}

TriangleMesh make_hemisphere(double radius, double edge) {
  require(radius > 0.0 && edge > 0.0, "the radius and the edge of a hemisphere must be above zero");
  require(edge <= 1.5 * radius, "the edge must not be longer than 1.5 radii");
  require_few_triangles(2.0 * pi * radius * radius, edge);
  std::vector<Loop> loops = {circle(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), radius, edge, 0.0)};
  for (Loop& loop : dome(Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), radius, edge, 0.0))
    loops.push_back(std::move(loop));
  return loft(loops);
}

TriangleMesh make_capsule(double radius, double length, double edge) {
  require(radius > 0.0 && length > 0.0 && edge > 0.0, "the lengths of a capsule must be above zero");
  require(edge <= 1.5 * radius, "the edge must not be longer than 1.5 radii");
  require_few_triangles(2.0 * pi * radius * (length + 2.0 * radius), edge);
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY(), half(0.0, 0.0, 0.5 * length);
  // The lower dome is made the other way up and run through backwards.
  std::vector<Loop> loops = dome(-half, x, -y, radius, edge, 0.0);
  for (Loop& loop : loops)
    if (loop.size() > 1) std::reverse(loop.begin() + 1, loop.end());
  std::reverse(loops.begin(), loops.end());
  const int rows = steps(length, equilateral_height * edge, 1);
  for (int i = 0; i <= rows; ++i)
    loops.push_back(circle(half * (2.0 * i / rows - 1.0), x, y, radius, edge, i % 2 ? 0.5 : 0.0));
  for (Loop& loop : dome(half, x, y, radius, edge, rows % 2 ? 0.5 : 0.0)) loops.push_back(std::move(loop));
  return loft(loops);
}

TriangleMesh make_cylinder(double radius, double length, double edge) {
  require(radius > 0.0 && length > 0.0 && edge > 0.0, "the lengths of a cylinder must be above zero");
  require(edge <= 1.5 * radius, "the edge must not be longer than 1.5 radii");
  require_few_triangles(2.0 * pi * radius * length, edge);
  std::vector<Loop> loops;
  const int rows = steps(length, equilateral_height * edge, 1);
  for (int i = 0; i <= rows; ++i)
    loops.push_back(circle(Vec3(0.0, 0.0, length * (1.0 * i / rows - 0.5)), Vec3::UnitX(), Vec3::UnitY(),
                           radius, edge, i % 2 ? 0.5 : 0.0));
  return loft(loops);
}

TriangleMesh make_torus(double major, double minor, double edge) {
  require(minor > 0.0 && edge > 0.0, "the lengths of a torus must be above zero");
  require(major > minor,
          "the major radius of a torus must be larger than its minor radius, or it meets itself");
  require(edge <= 1.5 * minor, "the edge must not be longer than 1.5 minor radii");
  require_few_triangles(4.0 * pi * pi * major * minor, edge);
  std::vector<Loop> loops;
  const int rows = 2 * steps(pi * major, equilateral_height * edge, 3);
  for (int i = 0; i < rows; ++i) {
    const double angle = 2.0 * pi * i / rows;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    // Counter-clockwise seen from further round z.
    loops.push_back(circle(major * outward, outward, -Vec3::UnitZ(), minor, edge, i % 2 ? 0.5 : 0.0));
  }
  return loft(loops, true);
}

TriangleMesh make_helix(const HelixShape& s) {
  require(s.coil_radius > 0.0 && s.tube_radius > 0.0 && s.pitch > 0.0 && s.turns > 0.0 && s.edge > 0.0,
          "the lengths and the turns of a helix must be above zero");
  require(s.edge <= 1.5 * s.tube_radius, "the edge must not be longer than 1.5 radii of the tube");
  require(s.coil_radius > s.tube_radius,
          "the coil of a helix must be wider than its tube, or it meets itself");
  // Neighbouring turns are pitch * cos(slope) apart.
  const double around = 2.0 * pi * s.coil_radius, turn_length = std::hypot(around, s.pitch);
  require(s.turns <= 0.5 || s.pitch * around / turn_length > 2.2 * s.tube_radius,
          "the turns of the helix meet: increase the pitch or decrease the tube's radius");
  require_few_triangles(2.0 * pi * s.tube_radius * (s.turns * turn_length + 2.0 * s.tube_radius), s.edge);

  const int rows = steps(s.turns * turn_length, equilateral_height * s.edge, 4);
  std::vector<Loop> loops;
  struct Frame {
    Vec3 centre, inward, side;
  };
  const auto frame_at = [&](int row) {
    const double angle = 2.0 * pi * s.turns * row / rows;
    const Vec3 outward(std::cos(angle), std::sin(angle), 0.0);
    const Vec3 ahead = Vec3(-around * std::sin(angle), around * std::cos(angle), s.pitch) / turn_length;
    const Vec3 centre =
        s.coil_radius * outward + Vec3(0.0, 0.0, s.pitch * s.turns * (1.0 * row / rows - 0.5));
    return Frame{centre, -outward, ahead.cross(-outward)};
  };
  for (int i = 0; i <= rows; ++i) {
    const Frame f = frame_at(i);
    loops.push_back(circle(f.centre, f.inward, f.side, s.tube_radius, s.edge, i % 2 ? 0.5 : 0.0));
  }
  if (!s.open) {
    const Frame front = frame_at(0), back = frame_at(rows);
    std::vector<Loop> start = dome(front.centre, front.inward, -front.side, s.tube_radius, s.edge, 0.0);
    for (Loop& loop : start)
      if (loop.size() > 1) std::reverse(loop.begin() + 1, loop.end());
    loops.insert(loops.begin(), start.rbegin(), start.rend());
    for (Loop& loop : dome(back.centre, back.inward, back.side, s.tube_radius, s.edge, rows % 2 ? 0.5 : 0.0))
      loops.push_back(std::move(loop));
  }
  return loft(loops);
}

}  // namespace nanocarbon::shapes
