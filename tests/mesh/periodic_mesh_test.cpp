// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/periodic_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <sstream>

#include "nanocarbon/core/error.h"
#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/formats/read_mesh.h"
#include "nanocarbon/mesh/formats/write_mesh.h"
#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/mesh/nearest_point.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "support/temporary_folder.h"

namespace nanocarbon::mesh {
namespace {

using shapes::MinimalSurface;

struct Known {
  MinimalSurface::Kind kind;
  bool primitive;
  std::int64_t euler;
  double area;  // of the nodal surface in the cube of edge 1, from the literature's tables; 0: not compared
};

// Euler characteristics and areas for a cell (Schoen 1970; areas of the nodal surfaces).
const Known known[] = {{MinimalSurface::Kind::schwarz_p, false, -4, 2.354},
                       {MinimalSurface::Kind::gyroid, false, -8, 3.094},
                       {MinimalSurface::Kind::gyroid, true, -4, 3.094 / 2},
                       {MinimalSurface::Kind::schwarz_d, false, -16, 3.843},
                       {MinimalSurface::Kind::schwarz_d, true, -4, 3.843 / 4},
                       {MinimalSurface::Kind::iwp, true, -6, 3.557 / 2},
                       {MinimalSurface::Kind::neovius, false, -16, 0}};

TriangleMesh surface(const Known& k) {
  MinimalSurface minimal;
  minimal.kind = k.kind;
  minimal.primitive = k.primitive;
  return shapes::make_minimal_surface(minimal);
}

TEST(PeriodicMesh, MinimalSurfacesHaveTheirTopologyAndArea) {
  for (const Known& k : known) {
    const TriangleMesh mesh = surface(k);
    const MeshTopology t = mesh_topology(mesh);
    SCOPED_TRACE(shapes::name(k.kind));
    EXPECT_TRUE(t.manifold() && t.closed() && t.orientable && t.consistently_wound());
    EXPECT_EQ(t.components, 1u);
    EXPECT_EQ(t.euler_characteristic, k.euler);
    EXPECT_EQ(wrapping_ranks(mesh, t), std::vector<int>{3});
    if (k.area > 0) {
      EXPECT_NEAR(area(mesh), k.area, 0.01 * k.area);
    }
    EXPECT_LT(edge_lengths(mesh).max, mesh.space.least_width() / 3);
  }
}

// A flat sheet in z, a tube along z, and a sphere, in a cell of edge 10 each.
TriangleMesh tube_of(int around, int along, double radius, double length) {
  TriangleMesh mesh;
  for (int k = 0; k < along; ++k)
    for (int j = 0; j < around; ++j) {
      const double angle = 2 * M_PI * j / around;
      mesh.points.push_back({radius * std::cos(angle), radius * std::sin(angle), length * k / along});
    }
  for (int k = 0; k < along; ++k)
    for (int j = 0; j < around; ++j) {
      const auto at = [&](int a, int b) { return static_cast<VertexIndex>(b % along * around + a % around); };
      mesh.triangles.push_back({at(j, k), at(j + 1, k), at(j + 1, k + 1)});
      mesh.triangles.push_back({at(j, k), at(j + 1, k + 1), at(j, k + 1)});
    }
  mesh.space = Space(orthogonal_cell({10, 10, length}, {false, false, true}));
  return mesh;
}

TEST(PeriodicMesh, ATubeGoesOnInOneDirection) {
  const TriangleMesh tube = tube_of(12, 8, 2, 10);
  const MeshTopology t = mesh_topology(tube);
  EXPECT_EQ(t.euler_characteristic, 0);
  EXPECT_EQ(wrapping_ranks(tube, t), std::vector<int>{1});
  EXPECT_NEAR(area(tube), 12 * 2 * 2 * std::sin(M_PI / 12) * 10, 1e-9);
}

// Whatever generates them, those of a lattice are its whole multiples and no others.
TEST(PeriodicMesh, TranslationsAreThoseOfTheLattice) {
  Translations none, skewed, plane;
  EXPECT_EQ(none.rank(), 0);
  EXPECT_TRUE(none.contains({0, 0, 0}));
  EXPECT_FALSE(none.contains({0, 0, 1}));
  // Face-centred: the sum is even.
  for (const std::array<std::int32_t, 3> t : {std::array{1, 1, 0}, {0, 1, 1}, {7, -1, 2}, {3, 2, 5}})
    skewed.add(t);
  EXPECT_EQ(skewed.rank(), 3);
  for (std::int32_t i = -3; i <= 3; ++i)
    for (std::int32_t j = -3; j <= 3; ++j)
      for (std::int32_t k = -3; k <= 3; ++k)
        EXPECT_EQ(skewed.contains({i, j, k}), (i + j + k) % 2 == 0) << i << j << k;
  for (const std::array<std::int32_t, 3> t :
       {std::array{6, 0, 4}, {0, 0, 0}, {3, 0, 2}, {0, -2, 0}, {3, 4, 2}})
    plane.add(t);
  EXPECT_EQ(plane.rank(), 2);
  EXPECT_TRUE(plane.contains({-9, 8, -6}));
  EXPECT_FALSE(plane.contains({3, 1, 2}));
  EXPECT_FALSE(plane.contains({3, 2, 1}));
}

TEST(PeriodicMesh, ManyCellsAreAsManyTimesTheSame) {
  const TriangleMesh one = surface(known[0]);
  const TriangleMesh eight = repeated(one, {2, 2, 2});
  EXPECT_EQ(mesh_topology(eight).euler_characteristic, 8 * -4);
  EXPECT_EQ(mesh_topology(eight).components, 1u);
  EXPECT_NEAR(area(eight), 8 * area(one), 1e-9);
  EXPECT_NEAR(edge_lengths(eight).max, edge_lengths(one).max, 1e-12);
}

TEST(PeriodicMesh, DistancesDoNotDependOnTheImage) {
  for (const Known& k : {known[0], known[2], known[4]}) {
    TriangleMesh mesh = surface(k);
    const NearestPoint nearest(mesh);
    const Cell& cell = *mesh.space.cell();
    // The same surface with each point in some other image.
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      mesh.points[v] += image_shift(
          cell, {static_cast<int>(v % 3) - 1, static_cast<int>(v % 5) - 2, static_cast<int>(v % 2)});
    const NearestPoint shifted(mesh);
    for (int q = 0; q < 200; ++q) {
      const Vec3 query(0.37 * q, -0.21 * q, 0.11 * q * q);
      const SurfacePoint one = nearest.nearest(query), other = shifted.nearest(query);
      EXPECT_NEAR(one.distance, other.distance, 1e-9);
      EXPECT_NEAR((one.point - query).norm(), one.distance, 1e-9) << "the foot is beside the query";
      if (q > 3) continue;
      double brute = 1e300;
      for (const Triangle& t : mesh.triangles) {
        const auto corners = corners_of(mesh, t);
        mesh.space.for_images([&](const Vec3& shift) {
          const Vec3 a = mesh.space.beside(corners[0], query) + shift, d = a - corners[0];
          brute =
              std::min(brute, (nearest_on_triangle(query, a, corners[1] + d, corners[2] + d) - query).norm());
        });
      }
      EXPECT_NEAR(one.distance, brute, 1e-9);
    }
  }
}

TEST(PeriodicMesh, FilesTellTheirCell) {
  const TriangleMesh mesh = surface(known[4]);
  for (const MeshFormat format : {MeshFormat::off, MeshFormat::obj, MeshFormat::ply}) {
    std::ostringstream file;
    write_mesh(file, format, mesh, {});
    const PolygonSoup soup = parse_mesh(file.str(), "mesh");
    ASSERT_TRUE(soup.cell);
    EXPECT_EQ(soup.cell->vectors, mesh.space.cell()->vectors);
    EXPECT_EQ(soup.faces(), mesh.triangles.size());
    EXPECT_GT(soup.points.size(), mesh.points.size()) << "vertices at the seam are there for each image";
  }
  std::ostringstream stl;
  EXPECT_THROW(write_mesh(stl, MeshFormat::stl, mesh, {}), UserError);
}

// The cut leaves parts that touch each other; they are one surface in the cell.
TEST(PeriodicMesh, WhatIsWrittenIsTakenAgain) {
  const test::TemporaryFolder folder;
  for (const std::uint64_t seed : {1, 2}) {
    const TriangleMesh foam = shapes::make_foam({.waves = 2, .seed = seed, .edge = 0.04});
    write_mesh(folder.path() / "foam.off", foam);
    const TriangleMesh read = load_surface(folder.path() / "foam.off").mesh;
    EXPECT_EQ(read.points.size(), foam.points.size());
    EXPECT_EQ(mesh_topology(read).euler_characteristic, mesh_topology(foam).euler_characteristic);
    EXPECT_TRUE(mesh_topology(read).closed());
  }
}

TEST(PeriodicMesh, ACommentThatIsNoCellIsRefused) {
  const std::string mesh = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
  EXPECT_FALSE(parse_mesh(mesh, "m.off").cell);
  EXPECT_TRUE(parse_mesh(mesh + "# Lattice=\"2 0 0 0 2 0 0 0 2\"\n", "m.off").cell);
  EXPECT_THROW(parse_mesh(mesh + "# Lattice=\"2 0 0 0 2 0 0\"\n", "m.off"), UserError);
  EXPECT_THROW(parse_mesh(mesh + "# Lattice=\"2 0 0 0 2 0 0 0 2\" pbc=\"T T\"\n", "m.off"), UserError);
}

// However its names are spelled, a cell is taken or refused, but never passed over.
TEST(PeriodicMesh, ACellIsSeenInAnySpelling) {
  const std::string mesh = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", nine = "2 0 0 0 3 0 0 0 4";
  for (const std::string& line :
       {"# Lattice=\"" + nine + "\" Origin=\"1 2 3\" pbc=\"T T F\"",
        "# lattice=\"" + nine + "\" origin=\"1 2 3\" pbc=\"t t f\"",
        "#LATTICE='" + nine + "' ORIGIN='1 2 3' PBC='T T F'",
        "# made by x=y pbc = \"T T F\"  Origin = \"1 2 3\"\tLattice = \"" + nine + "\" n=1"}) {
    const auto cell = parse_mesh(line + "\n" + mesh, "m.off").cell;
    ASSERT_TRUE(cell) << line;
    EXPECT_EQ(cell->vectors, Vec3(2, 3, 4).asDiagonal().toDenseMatrix()) << line;
    EXPECT_EQ(cell->origin, Vec3(1, 2, 3)) << line;
    EXPECT_EQ(cell->periodic, (std::array{true, true, false})) << line;
  }
  for (const std::string& value : {nine, "[" + nine + "]", "'" + nine, std::string("\"\"")})
    EXPECT_THROW(parse_mesh("# lattice=" + value + "\n" + mesh, "m.off"), UserError) << value;
  for (const char* line :
       {"# lattice=hexagonal", "# sublattice=\"2 0 0 0 3 0 0 0 4\"", "# lattice", "#lattice=",
        "# P surface, lattice = 20.5 Angstrom, cells = 2"})
    EXPECT_FALSE(parse_mesh(std::string(line) + "\n" + mesh, "m.off").cell) << line;
}

}  // namespace
}  // namespace nanocarbon::mesh
