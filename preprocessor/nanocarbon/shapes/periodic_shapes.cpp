// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/periodic_shapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/join_points.h"
#include "nanocarbon/mesh/mesh_topology.h"
#include "nanocarbon/mesh/periodic_mesh.h"
#include "nanocarbon/shapes/polygonise_in_cell.h"
#include "nanocarbon/shapes/random_field.h"

namespace nanocarbon::shapes {
namespace {

constexpr double pi = std::numbers::pi;

void require(bool condition, const char* what) {
  if (!condition) throw UserError(Failure::usage, what);
}

using Kind = MinimalSurface::Kind;

// Nodal functions of angles that run over 2 pi in the cubic cell.
double nodal(Kind kind, const Vec3& angle) {
  const Vec3 s = angle.array().sin(), c = angle.array().cos();
  const Vec3 s2 = (2.0 * angle).array().sin(), c2 = (2.0 * angle).array().cos();
  const double pairs = c.x() * c.y() + c.y() * c.z() + c.z() * c.x();
  const double double_pairs = c2.x() * c2.y() + c2.y() * c2.z() + c2.z() * c2.x();
  switch (kind) {
    case Kind::gyroid:
      return s.x() * c.y() + s.y() * c.z() + s.z() * c.x();
    case Kind::schwarz_p:
      return c.sum();
    case Kind::schwarz_d:
      return c.prod() - s.prod();
    case Kind::iwp:
      return 2.0 * pairs - c2.sum();
    case Kind::neovius:
      return 3.0 * c.sum() + 4.0 * c.prod();
    case Kind::frd:
      return 4.0 * c.prod() - double_pairs;
    case Kind::fischer_koch_s:
      return c2.x() * s.y() * c.z() + c.x() * c2.y() * s.z() + s.x() * c.y() * c2.z();
    case Kind::lidinoid:
      return 0.5 * (s2.x() * c.y() * s.z() + s2.y() * c.z() * s.x() + s2.z() * c.x() * s.y()) -
             0.5 * double_pairs + 0.15;
  }
  return 0.0;
}

// Edges of the least cell as columns, in cubic cells.
Mat3 primitive_vectors(Kind kind) {
  Mat3 vectors = Mat3::Identity();
  switch (kind) {
    case Kind::schwarz_d:
    case Kind::frd:  // face-centred
      vectors << 0.0, 0.5, 0.5, 0.5, 0.0, 0.5, 0.5, 0.5, 0.0;
      break;
    case Kind::gyroid:
    case Kind::iwp:
    case Kind::fischer_koch_s:
    case Kind::lidinoid:  // body-centred
      vectors << -0.5, 0.5, 0.5, 0.5, -0.5, 0.5, 0.5, 0.5, -0.5;
      break;
    case Kind::schwarz_p:
    case Kind::neovius:
      break;
  }
  return vectors;
}

void keep_components(TriangleMesh& mesh, const std::vector<bool>& kept, const mesh::MeshTopology& topology) {
  std::vector<Triangle> triangles;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (kept[topology.component_of_face[t]]) triangles.push_back(mesh.triangles[t]);
  mesh.triangles = std::move(triangles);
  mesh::drop_unused_points(mesh);
}

}  // namespace

std::string_view name(MinimalSurface::Kind kind) {
  switch (kind) {
    case Kind::gyroid:
      return "gyroid";
    case Kind::schwarz_p:
      return "schwarz-p";
    case Kind::schwarz_d:
      return "schwarz-d";
    case Kind::iwp:
      return "i-wp";
    case Kind::neovius:
      return "neovius";
    case Kind::frd:
      return "f-rd";
    case Kind::fischer_koch_s:
      return "fischer-koch-s";
    case Kind::lidinoid:
      return "lidinoid";
  }
  return "";
}

TriangleMesh make_minimal_surface(const MinimalSurface& m) {
  require(m.period > 0.0 && m.edge > 0.0, "the lengths of a minimal surface must be above zero");
  require(*std::min_element(m.cells.begin(), m.cells.end()) >= 1, "there must be one cell or more each way");
  require(m.edge <= 0.12 * m.period, "the edge must not be longer than 0.12 periods");
  Cell cell;
  cell.vectors = m.primitive ? primitive_vectors(m.kind) : Mat3::Identity();
  for (int d = 0; d < 3; ++d) cell.vectors.col(d) *= m.period * m.cells[static_cast<std::size_t>(d)];
  const double angle = 2.0 * pi / m.period;
  return polygonise_in_cell([&](const Vec3& p) { return nodal(m.kind, angle * p) - m.level; }, cell, m.edge);
}

TriangleMesh make_foam(const Foam& f) {
  require(f.waves >= 1.0 && f.waves <= 30.0, "a foam has 1 to 30 wavelengths along the edge of its cell");
  const double edge = f.edge.value_or(0.06 * f.size / f.waves);
  require(f.size > 0.0 && edge > 0.0, "the lengths of a foam must be above zero");
  require(std::abs(f.level) <= 1.0, "the level must be within one standard deviation");
  require(!f.thickness || (*f.thickness >= 0.0 && *f.thickness * f.waves <= 0.3 * f.size),
          "the thickness must not be above 0.3 wavelengths");
  require(edge * f.waves <= 0.12 * f.size, "the edge must not be longer than 0.12 wavelengths");
  RandomField field(f.size, f.waves, f.seed);
  thicken_necks(field, f.level, f.thickness.value_or(0.2 * field.wave_length()));
  TriangleMesh mesh = polygonise_in_cell([&](const Vec3& p) { return field(p) - f.level; },
                                         orthogonal_cell(Vec3::Constant(f.size)), edge);
  const mesh::MeshTopology topology = mesh::mesh_topology(mesh);
  const std::vector<int> ranks = mesh::wrapping_ranks(mesh, topology);
  std::vector<bool> kept(ranks.size());
  for (std::size_t c = 0; c < ranks.size(); ++c) kept[c] = ranks[c] > 0;
  require(std::find(kept.begin(), kept.end(), true) != kept.end(),
          "no part of the foam continues through its cell; use another seed, or more waves");
  keep_components(mesh, kept, topology);
  return mesh;
}

}  // namespace nanocarbon::shapes
