// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/spring_back.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/annealing/fixed_bond_model.h"
#include "nanocarbon/building/crystal_start.h"
#include "nanocarbon/building/size_request.h"
#include "nanocarbon/shapes/periodic_shapes.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

// The icosahedral fullerene of 20 n^2 atoms on a sphere about its centre, at rest under no tether.
annealing::SwitchingState fullerene_at_rest(int n) {
  annealing::SwitchingState state;
  const TriangleMesh sphere = test::unit_sphere(n);
  state.network = annealing::trivalent_network(sphere);
  for (const Triangle& t : sphere.triangles)
    state.positions.push_back(test::scale_for(sphere.triangles.size(), 4 * std::numbers::pi) *
                              (sphere.points[t[0]] + sphere.points[t[1]] + sphere.points[t[2]]).normalized());
  annealing::FixedBondModel model;
  model.rebo2.set_graph(annealing::fixed_bond_graph(state.network, state.space));
  annealing::minimise_fixed_bonds(model, nullptr, state.positions,
                                  {.max_iterations = 5000, .force_tolerance = 1e-5});
  return state;
}

double mean_radius(const std::vector<Vec3>& positions) {
  double sum = 0;
  for (const Vec3& p : positions) sum += p.norm();
  return sum / static_cast<double>(positions.size());
}

annealing::TetherSurface sphere_of(double radius) { return {test::unit_sphere(16), radius}; }

// C80 comes to rest nearly round.
TEST(SpringBack, AMoleculeAtRestStaysWhereItIs) {
  const annealing::SwitchingState state = fullerene_at_rest(2);
  const double radius = mean_radius(state.positions);
  const Released back = spring_back(state, sphere_of(radius), false);
  EXPECT_LT(back.mean_distance, 0.05);
  EXPECT_LT(back.left_out, 0.3);  // where its pentagons are flat
}

TEST(SpringBack, WhatIsLeftOutOfTheSurfaceIsTold) {
  const annealing::SwitchingState state = fullerene_at_rest(3);
  const double radius = mean_radius(state.positions);
  TriangleMesh finger = test::unit_sphere(16);
  for (Vec3& p : finger.points)
    if (p.z() > 0.9) p.z() += 25 * (p.z() - 0.9);
  const Released back = spring_back(state, {finger, radius}, false);
  EXPECT_LT(back.mean_distance, 0.6);
  EXPECT_GT(back.left_out, 1.5);
  EXPECT_EQ(back.distance(), back.left_out);
}

// A cage held on a sphere that is too large or too small goes back to the radius that it has at rest.
TEST(SpringBack, TheDistanceIsWhatASphereIsTooLargeBy) {
  const annealing::SwitchingState rest = fullerene_at_rest(3);
  const double radius = mean_radius(rest.positions);
  for (const double factor : {0.9, 1.1}) {
    annealing::SwitchingState held = rest;
    for (Vec3& p : held.positions) p *= factor;
    const Released back = spring_back(held, sphere_of(factor * radius), false);
    EXPECT_NEAR(back.mean_distance, std::abs(1 - factor) * radius, 0.15) << factor;
    // Held or not, the molecule is the same where it rests.
    EXPECT_NEAR(back.energy, spring_back(rest, sphere_of(radius), false).energy, 1e-4);
  }
}

TEST(SpringBack, ASurfaceThatMayBeScaledIsMetAtAnySize) {
  const annealing::SwitchingState rest = fullerene_at_rest(3);
  const double radius = mean_radius(rest.positions);
  const Released back = spring_back(rest, sphere_of(1.1 * radius), true);
  EXPECT_GT(spring_back(rest, sphere_of(1.1 * radius), false).mean_distance, 0.08 * radius);
  EXPECT_LT(back.mean_distance, 0.15);
}

// From 2,000 atoms on minimisation is preconditioned, and lets molecules drift. Half a cell away a fit does not know
// which way to go.
TEST(SpringBack, AMoleculeThatDriftsInItsCellIsBroughtBack) {
  const SizedSurface sized = sized_surface(
      shapes::make_minimal_surface({.kind = shapes::MinimalSurface::Kind::schwarz_p}), AtomCount{400}, 1.42);
  CrystalStart start = crystal_start(sized.mesh, sized.atoms, {.quality = Quality::draft});
  ASSERT_TRUE(start.level);
  annealing::relax_level(*start.level, annealing::TetherSurface(sized.mesh, 1));
  const annealing::SwitchingState& state = start.level->state;
  Mat3 strain = Mat3::Identity();
  strain(0, 0) = 1.02;
  strain(0, 1) = 0.01;
  for (const double share : {0.0, 0.5}) {
    const Vec3 drift = share * strain * sized.mesh.space.cell()->vectors.col(0);
    std::vector<Vec3> there;
    for (const Vec3& p : state.positions) there.push_back(strain * p + drift);
    const Released back = released_in_cell(state.network, there, state.positions, sized.mesh, strain, -7.3);
    EXPECT_LT(back.distance(), 0.5) << share;
    EXPECT_EQ(back.energy, -7.3);
  }
}

// The molecule is only looked at: whoever asked goes on from where it was.
TEST(SpringBack, LeavesTheMoleculeAlone) {
  annealing::SwitchingState held = fullerene_at_rest(2);
  for (Vec3& p : held.positions) p *= 1.03;
  const std::vector<Vec3> before = held.positions;
  spring_back(held, sphere_of(mean_radius(before)), false);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), held.positions.begin()));
}

}  // namespace
}  // namespace nanocarbon::building
