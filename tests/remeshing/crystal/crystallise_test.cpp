// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/crystal/crystallise.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/remeshing/crystal/triangulation_quality.h"
#include "remeshing/shapes.h"
#include "remeshing/topology.h"

namespace nanocarbon::crystal {
namespace {

CrystalOptions options_for(std::size_t faces, Quality quality = Quality::draft) {
  CrystalOptions options;
  options.faces = faces;
  options.quality = quality;
  return options;
}

//! What is promised on every smooth closed surface.
void expect_crystal(const CrystalResult& result, const TriangleMesh& surface, std::size_t faces) {
  EXPECT_EQ(test::topology_of(result.mesh), test::topology_of(surface));
  EXPECT_EQ(result.mesh.triangles.size(), faces);
  EXPECT_EQ(result.bad_valences, 0u);
  EXPECT_EQ(result.unsound, 0u);
  const TriangulationQuality quality = measure_triangulation(result.mesh, surface);
  EXPECT_EQ(quality.bad, 0u);
  EXPECT_EQ(quality.defects, result.defects);
  EXPECT_EQ(quality.folds, 0u);
  EXPECT_LT(quality.distance_mean, 0.03);
  EXPECT_LT(quality.edge_cv, 0.06);
}

TEST(Crystallise, SphereIsCovered) {
  const TriangleMesh surface = test::sphere(10, 4);
  const CrystalResult result = crystallise(surface, options_for(1000));
  expect_crystal(result, surface, 1000);
  EXPECT_GE(result.defects, 12u);  // Euler
}

TEST(Crystallise, TorusKeepsItsHandle) {
  const TriangleMesh surface = test::torus(3, 1.2, 120, 48);
  expect_crystal(crystallise(surface, options_for(3000)), surface, 3000);
}

TEST(Crystallise, CoarseInputIsRefined) {
  const TriangleMesh surface = test::icosahedron(10);
  const CrystalResult result = crystallise(surface, options_for(1500));
  EXPECT_EQ(test::topology_of(result.mesh), test::topology_of(surface));
  EXPECT_EQ(result.mesh.triangles.size(), 1500u);
  EXPECT_EQ(result.bad_valences, 0u);
}

TEST(Crystallise, BoundaryVerticesStayOnTheBoundary) {
  const TriangleMesh surface = test::open_tube(2, 10, 60, 60);
  const CrystalResult result = crystallise(surface, options_for(1600));
  const auto topology = test::topology_of(result.mesh);
  EXPECT_EQ(topology, test::topology_of(surface));
  EXPECT_NEAR(static_cast<double>(result.mesh.triangles.size()), 1600, 16);
  EXPECT_EQ(result.bad_valences, 0u);
  const double mean = measure_triangulation(result.mesh, surface).edge_mean;
  std::size_t low = 0, high = 0;
  for (const Vec3& p : result.mesh.points) {
    low += p.z() < 1e-9 ? 1 : 0;
    high += p.z() > 10 - 1e-9 ? 1 : 0;
  }
  // A rim of circumference 4 pi holds about that many edges.
  const double expected = 4 * std::numbers::pi / mean;
  EXPECT_NEAR(static_cast<double>(low), expected, 0.15 * expected);
  EXPECT_NEAR(static_cast<double>(high), expected, 0.15 * expected);
}

TEST(Crystallise, AnyNumberOfThreadsGivesTheSameMesh) {
  const TriangleMesh surface = test::torus(3, 1.2, 60, 24);
  CrystalOptions options = options_for(24000);  // enough for every step to be shared out
  const CrystalResult one = crystallise(surface, options);
  for (const unsigned threads : {2u, 3u}) {
    ThreadTeam team(threads);
    options.team = &team;
    const CrystalResult other = crystallise(surface, options);
    EXPECT_EQ(one.mesh.points, other.mesh.points);
    EXPECT_EQ(one.mesh.triangles, other.mesh.triangles);
  }
}

TEST(Crystallise, TheSameSeedGivesTheSameMesh) {
  const TriangleMesh surface = test::torus(3, 1.2, 60, 24);
  const CrystalResult one = crystallise(surface, options_for(800));
  const CrystalResult two = crystallise(surface, options_for(800));
  EXPECT_EQ(one.mesh.points, two.mesh.points);
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
}

TEST(Crystallise, TheUnitDoesNotMatter) {
  TriangleMesh surface = test::torus(3, 1.2, 60, 24);
  const CrystalResult one = crystallise(surface, options_for(800));
  for (Vec3& p : surface.points) p *= 1024;
  const CrystalResult two = crystallise(surface, options_for(800));
  EXPECT_EQ(one.mesh.triangles, two.mesh.triangles);
}

}  // namespace
}  // namespace nanocarbon::crystal
