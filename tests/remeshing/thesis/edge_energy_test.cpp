// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/thesis/edge_energy.h"

#include <gmock/gmock.h>

#include <random>

#include "nanocarbon/remeshing/thesis/local_optimiser.h"
#include "remeshing/shapes.h"

namespace nanocarbon::thesis {
namespace {

//! The region around an edge of a torus whose points were moved at random.
EdgeEnergy region(bool tangent_plane, std::vector<VertexIndex>* moving = nullptr) {
  TriangleMesh torus = test::torus(6.0, 2.0, 30, 12);
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  for (Vec3& p : torus.points) p += Vec3(uniform(random), uniform(random), uniform(random));
  const VertexStars stars = vertex_stars(to_triangulation(torus));
  RingSearch search(stars);
  LocalOptions options;
  options.interval = {0.9, 1.5};
  options.rings = 2;
  options.tangent_plane = tangent_plane;
  EdgeEnergy energy;
  std::vector<VertexIndex> vertices;
  region_energy(stars, search, {100, stars.of(100)[0]}, options, energy, vertices);
  if (moving) *moving = vertices;
  return energy;
}

// The derivative by differences of the energy itself.
TEST(EdgeEnergy, GradientOfEq44AgreesWithFiniteDifferences) {
  EdgeEnergy energy = region(false);
  std::vector<Vec3> gradient;
  edge_energy_gradient(energy, gradient);
  ASSERT_EQ(gradient.size(), energy.moving);
  constexpr double step = 1e-5;
  for (std::size_t i = 0; i < energy.moving; ++i)
    for (int d = 0; d < 3; ++d) {
      const double place = energy.points[i][d];
      energy.points[i][d] = place + step;
      const double above = edge_energy(energy);
      energy.points[i][d] = place - step;
      const double below = edge_energy(energy);
      energy.points[i][d] = place;
      EXPECT_NEAR(gradient[i][d], (above - below) / (2 * step), 1e-6 * (1.0 + std::abs(gradient[i][d])));
    }
}

TEST(EdgeEnergy, GradientOfEq47AgreesWithFiniteDifferencesInTheTangentPlane) {
  EdgeEnergy energy = region(true);
  std::vector<Vec3> gradient;
  edge_energy_gradient(energy, gradient);
  constexpr double step = 1e-5;
  for (std::size_t i = 0; i < energy.moving; ++i) {
    const Vec3 n = energy.normals[i];
    EXPECT_NEAR(gradient[i].dot(n), 0.0, 1e-9);
    const Vec3 t = n.unitOrthogonal();
    for (const Vec3& along : {t, Vec3(n.cross(t))}) {
      const Vec3 place = energy.points[i];
      energy.points[i] = place + step * along;
      const double above = edge_energy(energy);
      energy.points[i] = place - step * along;
      const double below = edge_energy(energy);
      energy.points[i] = place;
      const double slope = gradient[i].dot(along);
      EXPECT_NEAR(slope, (above - below) / (2 * step), 1e-6 * (1.0 + std::abs(slope)));
    }
  }
}

// The double sum of Eq. 4.4, written out over the mesh: vertices of the star, and for each all of its
// neighbours.
TEST(EdgeEnergy, IsTheDoubleSumOfEq44UpToTermsThatCannotChange) {
  const TriangleMesh sphere = test::sphere(3.0, 3);
  const VertexStars stars = vertex_stars(to_triangulation(sphere));
  RingSearch search(stars);
  LocalOptions options;
  options.interval = {0.4, 0.8};
  EdgeEnergy energy;
  std::vector<VertexIndex> moving;
  region_energy(stars, search, {5, stars.of(5)[0]}, options, energy, moving);
  double sum = 0.0;
  for (const VertexIndex i : moving)  // no boundaries: all of the star moves
    for (const VertexIndex j : stars.of(i)) {
      const double q = (stars.points[i] - stars.points[j]).squaredNorm() - 0.36;
      sum += q * q;
    }
  EXPECT_NEAR(edge_energy(energy), sum, 1e-10 * sum);
  EXPECT_EQ(moving.size(), search.ring_begin(5));
}

TEST(Minimise, BringsThreeFreePointsToAnEquilateralTriangle) {
  EdgeEnergy energy;
  energy.points = {{0, 0, 0}, {1, 0, 0}, {0.2, 0.3, 0.4}};
  energy.terms = {{0, 1, 2.0}, {1, 2, 2.0}, {0, 2, 2.0}};
  energy.moving = 3;
  energy.m = 1.5;
  MinimiserWorkspace workspace;
  const MinimiserResult result = minimise(energy, {200, 1e-15}, workspace);
  EXPECT_LT(result.energy_after, 1e-12);
  for (const EdgeTerm& term : energy.terms)
    EXPECT_NEAR((energy.points[term.a] - energy.points[term.b]).norm(), 1.5, 1e-6);
}

TEST(Minimise, NeverRaisesTheEnergyAndTellsWhatItReached) {
  for (const bool tangent_plane : {true, false}) {
    EdgeEnergy energy = region(tangent_plane);
    const std::vector<Vec3> before = energy.points;
    const double start = edge_energy(energy);
    MinimiserWorkspace workspace;
    const MinimiserResult result = minimise(energy, {}, workspace);
    EXPECT_DOUBLE_EQ(result.energy_before, start);
    EXPECT_NEAR(result.energy_after, edge_energy(energy), 1e-9 * start);
    EXPECT_LT(result.energy_after, start);
    for (std::size_t i = energy.moving; i < before.size(); ++i) EXPECT_EQ(energy.points[i], before[i]);
    for (std::size_t i = 0; i < energy.normals.size(); ++i)
      EXPECT_NEAR((energy.points[i] - before[i]).dot(energy.normals[i]), 0.0, 1e-9);
  }
}

TEST(Minimise, StaysWhereItIsAtAMinimum) {
  EdgeEnergy energy;
  energy.points = {{0, 0, 0}, {1.5, 0, 0}};
  energy.terms = {{0, 1, 1.0}};
  energy.moving = 1;
  energy.m = 1.5;
  MinimiserWorkspace workspace;
  EXPECT_EQ(minimise(energy, {}, workspace).iterations, 0u);
  EXPECT_EQ(energy.points[0], Vec3(0, 0, 0));
}

}  // namespace
}  // namespace nanocarbon::thesis
