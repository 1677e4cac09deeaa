// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/likeness.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "nanocarbon/mesh/measures.h"
#include "nanocarbon/structures/fullerene.h"
#include "remeshing/shapes.h"

namespace nanocarbon::building {
namespace {

constexpr double area_per_atom = 2.6195;  // square Angstrom

// A (10,10) tube has a radius of 6.78 Angstrom and 0.039 eV an atom above graphene under REBO2.
TEST(Likeness, ATubeCostsWhatItsCurvatureDoes) {
  const TriangleMesh tube = test::open_tube(6.78, 100, 60, 140);
  const double atoms = mesh::area(tube) / area_per_atom;
  const double ends = 1.5 * 2 * 2 * std::numbers::pi * 6.78;
  EXPECT_NEAR(expected_energy(tube, static_cast<std::size_t>(atoms), Boundary::bare) - ends / atoms, 0.039,
              0.004);
}

// Whatever the radius: 8 pi times half the rigidity's square of curvatures, and twelve pentagons.
TEST(Likeness, ASphereCostsTheSameWhateverItsSize) {
  for (const double radius : {15.0, 40.0})
    EXPECT_NEAR(expected_energy(test::sphere(radius, 5), 1), 8 * std::numbers::pi * 1.4 + 12 * 5, 6)
        << radius;
}

TEST(Likeness, AMoleculeOnItsSurfaceIsLikeIt) {
  const Molecule molecule = structures::fullerene(3, 3);  // C540, 0.100 eV an atom above graphene
  double radius = 0;
  for (const Vec3& p : molecule.positions) radius += p.norm() / static_cast<double>(molecule.size());
  const Likeness like = likeness(molecule, test::sphere(radius, 4), 0.100);
  EXPECT_LT(like.distance_share, 0.05);
  EXPECT_NEAR(like.shape_radius, radius, 0.01 * radius);
  EXPECT_GT(like.energy_share, 0.3);
  EXPECT_LT(like.energy_share, 1.5);
  EXPECT_FALSE(like.far() || like.strained());
  EXPECT_THAT(like.warnings(), testing::IsEmpty());
}

TEST(Likeness, OneThatIsFarOrStrainedIsTold) {
  const Molecule molecule = structures::fullerene(3, 3);
  const Likeness far = likeness(molecule, test::sphere(16, 4), 0.1);
  EXPECT_TRUE(far.far());
  EXPECT_THAT(far.warnings(), testing::ElementsAre(testing::HasSubstr("only roughly")));
  const Likeness strained = likeness(molecule, test::sphere(10.5, 4), 1.6);
  EXPECT_TRUE(strained.strained());
  EXPECT_THAT(strained.warnings(), testing::ElementsAre(testing::HasSubstr("1600 meV per atom")));
}

// A ball with a thin finger, and a molecule of the ball alone: no atom is far from the surface.
TEST(Likeness, WhatTheMoleculeLeavesOutOfTheSurfaceIsTold) {
  const Molecule molecule = structures::fullerene(3, 3);
  double radius = 0;
  for (const Vec3& p : molecule.positions) radius += p.norm() / static_cast<double>(molecule.size());
  TriangleMesh surface = test::sphere(radius, 4);
  for (Vec3& p : surface.points)
    if (p.z() > 0.9 * radius) p.z() += 25 * radius * (p.z() / radius - 0.9);
  const Likeness like = likeness(molecule, surface, 0.1);
  EXPECT_LT(like.distance_there, 0.5);
  EXPECT_GT(like.distance_back, 2);
  EXPECT_EQ(like.distance(), like.distance_back);
  EXPECT_THAT(like.warnings(), testing::ElementsAre(testing::HasSubstr("the surface lies")));
}

}  // namespace
}  // namespace nanocarbon::building
