// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/final_minimum.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

// The dual of a triangulation of the unit sphere, relaxed on a sphere.
annealing::AnnealingLevel level_of(TriangleMesh triangulation, const TriangleMesh& surface) {
  rescale(triangulation, surface.points[0].norm());
  annealing::AnnealingLevel level = *annealing::level_on(triangulation, {.tether = default_tether});
  annealing::relax_level(level, annealing::TetherSurface(surface, 1));
  return level;
}

// \param factor of the radius that room for the atoms asks for
TriangleMesh sphere(std::size_t atoms, double factor = 1) {
  TriangleMesh surface = test::unit_sphere(16);
  rescale(surface, factor * test::scale_for(atoms, 4 * std::numbers::pi));
  return surface;
}

double mean_radius(const Molecule& molecule) {
  double sum = 0;
  for (const Vec3& p : molecule.positions) sum += p.norm();
  return sum / static_cast<double>(molecule.size());
}

// C320 (Ih) by LAMMPS's pair_style rebo.
TEST(FinalMinimum, OfAFullereneIsItsMinimumOfRebo2) {
  const TriangleMesh surface = sphere(320);
  rebo2::Rebo2 rebo2;
  const FinalMinimum end = final_minimum(level_of(test::unit_sphere(4), surface), surface, 320, rebo2, {});
  EXPECT_NEAR(end.rest.energy, -7.2409063626, 2e-6);
  EXPECT_LT(end.rest.max_force, 1e-3);
  EXPECT_TRUE(end.rest.intact);
  EXPECT_EQ(end.accepted, 0u);
  EXPECT_EQ(end.molecule.rings.size(), 162u);
  // Second neighbours are further apart than what is looked at.
  EXPECT_EQ(end.rest.closest_unbonded, 2.2);
}

// A sphere 4 percent too large: a molecule that may have its own size takes the surface along, another one stays
// in its middle.
TEST(FinalMinimum, TheSurfaceGrowsToTheMoleculesSizeUnlessItIsKept) {
  const TriangleMesh surface = sphere(320, 1.04);
  rebo2::Rebo2 rebo2;
  const annealing::AnnealingLevel level = level_of(test::unit_sphere(4), surface);
  const FinalMinimum free = final_minimum(level, surface, 320, rebo2, {});
  EXPECT_NEAR(free.growth * surface.points[0].norm(), mean_radius(free.molecule), 0.05);
  EXPECT_LT(free.growth, 0.99);
  const FinalMinimum kept = final_minimum(level, surface, 320, rebo2, {.keep_size = true});
  EXPECT_EQ(kept.growth, 1);
  EXPECT_NEAR(mean_radius(kept.molecule), mean_radius(free.molecule), 1e-3);
}

// Three flips in ten faces leave bonds that REBO2 would not see as they are: such places get other bonds.
TEST(FinalMinimum, WhatRebo2WouldBindOtherwiseIsMended) {
  const TriangleMesh triangulation = test::rough_sphere(6, 3, 0.3), surface = sphere(720);
  rebo2::Rebo2 rebo2;
  const FinalMinimum end = final_minimum(level_of(triangulation, surface), surface, 720, rebo2, {});
  EXPECT_TRUE(end.rest.intact);
  EXPECT_GT(end.accepted, 0u);
  const std::vector<double> lengths = molecule::bond_lengths(end.molecule);
  EXPECT_LT(*std::max_element(lengths.begin(), lengths.end()), 1.7);
  EXPECT_GT(end.rest.closest_unbonded, 2.0);
}

}  // namespace
}  // namespace nanocarbon::building
