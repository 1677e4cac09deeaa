// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/anneal_recipe.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "support/ring_counts.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

constexpr double graphene = -7.3949972517;  // eV/atom, pair_style rebo

TriangleMesh sphere_for(std::size_t atoms) {
  TriangleMesh surface = test::unit_sphere(16);
  for (Vec3& p : surface.points) p *= test::scale_for(atoms, 4 * std::numbers::pi);
  return surface;
}

double longest_bond(const Molecule& molecule) {
  const std::vector<double> lengths = molecule::bond_lengths(molecule);
  return *std::max_element(lengths.begin(), lengths.end());
}

TEST(Anneal, ADraftIsAnIntactMinimumOfRebo2) {
  rebo2::Rebo2 rebo2;
  const AnnealResult result = anneal(sphere_for(720), 720, rebo2, {.quality = Quality::draft});
  const Molecule& molecule = result.minimum.molecule;
  const std::size_t atoms = molecule.size();
  EXPECT_NEAR(static_cast<double>(atoms), 720, 7.2);
  EXPECT_EQ(2 * molecule.bonds.size(), 3 * atoms);
  EXPECT_EQ(2 * molecule.rings.size(), atoms + 4);  // Euler's formula
  EXPECT_LT(result.minimum.rest.max_force, 1e-3);
  EXPECT_TRUE(result.minimum.rest.intact);
  EXPECT_LT(longest_bond(molecule), 1.7);
  const double radius = sphere_for(720).points[0].norm() * result.minimum.growth;
  for (const Vec3& p : molecule.positions) EXPECT_NEAR(p.norm(), radius, 2.5);
  EXPECT_EQ(result.record.accepted, 0u);
  EXPECT_GT(result.remeshing_seconds, 0);
}

TEST(Anneal, GoodLeavesASphereItsTwelvePentagons) {
  rebo2::Rebo2 rebo2;
  ThreadTeam team(2);
  const AnnealResult result = anneal(sphere_for(320), 320, rebo2, {.running = {&team}});
  const Molecule& molecule = result.minimum.molecule;
  EXPECT_EQ(test::rings_of(molecule.rings, 5), 12u);
  EXPECT_EQ(test::rings_of(molecule.rings, 6), molecule.rings.size() - 12);
  EXPECT_TRUE(result.minimum.rest.intact);
  EXPECT_LE(result.minimum.rest.energy, result.record.unannealed_energy);
  // C320 (Ih) has 154.1 meV an atom; bending goes with the inverse of the count.
  EXPECT_LT(result.minimum.rest.energy - graphene,
            0.1541 * 320 / static_cast<double>(molecule.size()) + 0.006);
}

}  // namespace
}  // namespace nanocarbon::building
