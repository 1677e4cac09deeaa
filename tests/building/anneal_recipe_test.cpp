// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/anneal_recipe.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "nanocarbon/core/error.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "support/rough_sphere.h"

namespace nanocarbon::building {
namespace {

constexpr double graphene = -7.3949972517;  // eV/atom, pair_style rebo

// Icosahedral numbers of faces only, which is all that these tests ask for.
TriangleMesh rough_triangulation(const TriangleMesh& surface, std::size_t faces, std::uint64_t seed) {
  TriangleMesh mesh = test::rough_sphere(static_cast<int>(std::lround(std::sqrt(faces / 20.0))), seed, 0.2);
  for (Vec3& p : mesh.points) p *= surface.points[0].norm();
  return mesh;
}

TriangleMesh sphere_for(std::size_t atoms) {
  TriangleMesh surface = test::unit_sphere(16);
  for (Vec3& p : surface.points) p *= test::scale_for(atoms, 4 * std::numbers::pi);
  return surface;
}

std::size_t rings_of(const Molecule& molecule, std::size_t size) {
  std::size_t count = 0;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) count += molecule.rings[r].size() == size;
  return count;
}

TEST(Anneal, ADraftIsAnIntactMinimumOfRebo2) {
  rebo2::Rebo2 rebo2;
  const auto result = anneal(sphere_for(720), 720, rough_triangulation, rebo2, {.quality = Quality::draft});
  const std::size_t atoms = result.molecule.size();
  EXPECT_NEAR(static_cast<double>(atoms), 720, 7.2);
  EXPECT_EQ(2 * result.molecule.bonds.size(), 3 * atoms);
  EXPECT_EQ(2 * result.molecule.rings.size(), atoms + 4);  // Euler's formula
  EXPECT_LT(result.max_force, 1e-3);
  EXPECT_TRUE(result.intact);
  EXPECT_LT(result.longest_bond, 1.7);
  EXPECT_LT(result.mean_distance, 1.0);
}

TEST(Anneal, GoodLeavesASphereItsTwelvePentagons) {
  rebo2::Rebo2 rebo2;
  const auto result = anneal(sphere_for(320), 320, rough_triangulation, rebo2, {.threads = 2});
  EXPECT_EQ(rings_of(result.molecule, 5), 12u);
  EXPECT_EQ(rings_of(result.molecule, 6), result.molecule.rings.size() - 12);
  EXPECT_TRUE(result.intact);
  EXPECT_LT(result.energy, result.unannealed_energy);
  // C320 (Ih) has 154.1 meV an atom; bending goes with the inverse of the count.
  EXPECT_LT(result.energy - graphene, 0.1541 * 320 / static_cast<double>(result.molecule.size()) + 0.006);
}

// Twelve pentagons at a quarter of the atoms, and a rough triangulation with all of them; and the other way
// round.
TEST(Anneal, TakesTheBetterOfItsStarts) {
  constexpr std::size_t atoms = 1280;
  for (const bool coarse_is_better : {true, false}) {
    const auto triangulate = [&](const TriangleMesh& surface, std::size_t faces, std::uint64_t seed) {
      if ((faces < atoms) != coarse_is_better) return rough_triangulation(surface, faces, seed);
      TriangleMesh mesh = test::unit_sphere(static_cast<int>(std::lround(std::sqrt(faces / 20.0))));
      for (Vec3& p : mesh.points) p *= surface.points[0].norm();
      return mesh;
    };
    rebo2::Rebo2 rebo2;
    const auto result = anneal(sphere_for(atoms), atoms, triangulate, rebo2, {.threads = 2});
    EXPECT_EQ(result.refinements, coarse_is_better ? 1 : 0);
    EXPECT_EQ(rings_of(result.molecule, 5), 12u);
    EXPECT_EQ(rings_of(result.molecule, 7), 0u);
    EXPECT_LT(result.energy, result.unannealed_energy);
  }
}

// High genus: a sixteenth of the atoms is too few for the topology, the number asked for is not.
TEST(Anneal, LevelsTooCoarseForTheTopologyAreLeftOut) {
  const auto triangulate = [](const TriangleMesh& surface, std::size_t faces, std::uint64_t seed) {
    if (faces < 500) throw UserError(Failure::size, "too few for the topology");
    return rough_triangulation(surface, faces, seed);
  };
  rebo2::Rebo2 rebo2;
  const auto result = anneal(sphere_for(980), 980, triangulate, rebo2, {.threads = 2});
  EXPECT_EQ(result.refinements, 0);
  EXPECT_TRUE(result.intact);
  EXPECT_NEAR(static_cast<double>(result.molecule.size()), 980, 10);
}

}  // namespace
}  // namespace nanocarbon::building
