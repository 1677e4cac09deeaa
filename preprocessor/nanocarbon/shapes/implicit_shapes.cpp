// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/implicit_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/shapes/clip_mesh.h"
#include "nanocarbon/shapes/even_out.h"
#include "nanocarbon/shapes/polygonise.h"

namespace nanocarbon::shapes {
namespace {

constexpr double pi = std::numbers::pi;

void require(bool condition, const char* what) {
  if (!condition) throw UserError(Failure::usage, what);
}

std::vector<Vec3> arm_directions(JunctionShape::Kind kind) {
  const double half = 0.5, root = 0.5 * std::numbers::sqrt3;
  switch (kind) {
    case JunctionShape::Kind::y:
      return {{1, 0, 0}, {-half, root, 0}, {-half, -root, 0}};
    case JunctionShape::Kind::t:
      return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}};
    case JunctionShape::Kind::x:
      return {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}};
  }
  return {};
}

//! Nodal approximation of the surface, scaled to have about unit gradient on it.
double nodal(MinimalSurfacePiece::Kind kind, const Vec3& point, double period) {
  const Vec3 angle = 2.0 * pi / period * point;
  const Vec3 s = angle.array().sin(), c = angle.array().cos();
  const double unit = period / (2.0 * pi);
  switch (kind) {
    case MinimalSurfacePiece::Kind::gyroid:
      return unit / 1.5 * (s.x() * c.y() + s.y() * c.z() + s.z() * c.x());
    case MinimalSurfacePiece::Kind::schwarz_p:
      return unit / 1.5 * (c.x() + c.y() + c.z());
    case MinimalSurfacePiece::Kind::schwarz_d:
      return unit *
             (s.x() * s.y() * s.z() + s.x() * c.y() * c.z() + c.x() * s.y() * c.z() + c.x() * c.y() * s.z());
  }
  return 0.0;
}

}  // namespace

TriangleMesh make_genus_two(double major, double minor, double edge) {
  require(minor > 0.0 && edge > 0.0, "the lengths of a genus-two shape must be above zero");
  require(major > 1.5 * minor, "the major radius must be more than 1.5 minor radii, or the holes close");
  require(edge <= minor, "the edge must not be longer than the minor radius");
  const Vec3 side(major, 0.0, 0.0);
  const ImplicitShape shape = [=](const Vec3& p) {
    return smooth_union(torus_distance(p, side, major, minor), torus_distance(p, -side, major, minor),
                        0.5 * minor);
  };
  const Vec3 reach(2.0 * major + minor, major + minor, minor);
  const Vec3 room = Vec3::Constant(0.25 * minor + 2.0 * edge);
  return polygonise(shape, -reach - room, reach + room, edge);
}

TriangleMesh make_junction(const JunctionShape& s) {
  require(s.tube_radius > 0.0 && s.arm_length > 0.0 && s.edge > 0.0,
          "the lengths of a junction must be above zero");
  require(s.blend > 0.0 && s.blend <= 2.0 * s.tube_radius,
          "the blend must be above zero and at most two tube radii");
  require(s.arm_length >= 2.0 * s.tube_radius + s.blend,
          "the arms must be at least two tube radii and the blend long");
  require(s.edge <= s.tube_radius, "the edge must not be longer than the radius of the tubes");
  const std::vector<Vec3> arms = arm_directions(s.kind);
  // Open arms are made longer and cut to length.
  const double axis = s.open ? s.arm_length + 2.0 * s.edge : s.arm_length - s.tube_radius;
  const ImplicitShape shape = [&](const Vec3& p) {
    double distance = capsule_distance(p, Vec3::Zero(), axis * arms[0], s.tube_radius);
    for (std::size_t a = 1; a < arms.size(); ++a)
      distance =
          smooth_union(distance, capsule_distance(p, Vec3::Zero(), axis * arms[a], s.tube_radius), s.blend);
    return distance;
  };
  const double reach = axis + s.tube_radius + 2.0 * s.edge, height = s.tube_radius + s.blend + 2.0 * s.edge;
  TriangleMesh mesh = polygonise(shape, Vec3(-reach, -reach, -height), Vec3(reach, reach, height), s.edge);
  if (s.open) {
    for (const Vec3& arm : arms)
      mesh = clip_mesh(mesh, [&](const Vec3& p) { return p.dot(arm) - s.arm_length; });
    even_out(mesh, shape, s.edge, 8);
  }
  return mesh;
}

TriangleMesh make_minimal_surface_piece(const MinimalSurfacePiece& m) {
  require(m.period > 0.0 && m.cells > 0.0 && m.edge > 0.0 && m.thickness >= 0.0,
          "the lengths of a piece of minimal surface must be above zero");
  require(m.cells >= 0.5, "a piece of minimal surface must be half a period wide or more");
  require(m.edge <= 0.12 * m.period, "the edge must not be longer than 0.12 periods");
  require(m.thickness == 0.0 || (m.thickness >= 1.5 * m.edge && m.thickness <= 0.3 * m.period),
          "the thickness must be 0, or at least 1.5 edges and at most 0.3 periods");
  const double half = 0.5 * m.cells * m.period;
  // Off the symmetry planes, so that the cube's faces do not run along the surface.
  const Vec3 shift = Vec3(0.031, 0.017, 0.043) * m.period;
  const ImplicitShape surface = [=](const Vec3& p) { return nodal(m.kind, p + shift, m.period); };
  const auto cube = [=](const Vec3& p) { return p.cwiseAbs().maxCoeff() - half; };
  const Vec3 reach = Vec3::Constant(half + 3.0 * m.edge);
  if (m.thickness > 0.0) {
    // The shell and the cube meet in a rounded edge: a smooth intersection is a smooth union of the outsides.
    const double blend = 0.5 * m.thickness;
    const ImplicitShape shell = [=](const Vec3& p) {
      return -smooth_union(0.5 * m.thickness - std::abs(surface(p)), -cube(p), blend);
    };
    return largest_component(polygonise(shell, -reach, reach, m.edge));
  }
  TriangleMesh mesh = polygonise(surface, -reach, reach, m.edge);
  for (int face = 0; face < 6; ++face) {
    const double sign = face % 2 ? 1.0 : -1.0;
    mesh = clip_mesh(mesh, [=](const Vec3& p) { return sign * p[face / 2] - half; });
  }
  mesh = largest_component(mesh);
  even_out(mesh, surface, m.edge, 8);
  return mesh;
}

}  // namespace nanocarbon::shapes
