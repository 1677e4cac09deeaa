// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/boundary_units.h"

#include <gtest/gtest.h>

#include <numbers>

#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"

namespace nanocarbon::molecule {
namespace {

// Sum of 3 less the length over all chains.
long turning(const BoundaryUnits& units) {
  long sum = 0;
  for (std::size_t size = 0; size < units.chains.size(); ++size)
    sum += (3 - static_cast<long>(size)) * static_cast<long>(units.chains[size]);
  return sum;
}

TEST(BoundaryUnits, EndsOfArmchairTubesAreArmchairAndOfZigzagTubesZigzag) {
  const BoundaryUnits armchair = boundary_units(structures::open_tube(10, 10, 20.0));
  EXPECT_EQ(armchair.loops, 2u);
  EXPECT_EQ(armchair.open_atoms, 40u);  // two for each of the ten cells around, at either end
  EXPECT_EQ(armchair.armchair, 40u);
  EXPECT_EQ(armchair.others(), 0u);
  const BoundaryUnits zigzag = boundary_units(structures::open_tube(17, 0, 20.0));
  EXPECT_EQ(zigzag.loops, 2u);
  EXPECT_EQ(zigzag.open_atoms, 34u);
  EXPECT_EQ(zigzag.zigzag, 34u);
  EXPECT_EQ(zigzag.others(), 0u);
  for (const auto& [units, n, m] : {std::tuple(armchair, 10, 10), std::tuple(zigzag, 17, 0)})
    EXPECT_NEAR(units.length, 4 * std::numbers::pi * structures::tube_geometry(n, m).radius,
                0.02 * units.length);
}

TEST(BoundaryUnits, HydrogenChangesNothing) {
  for (const Molecule& bare : {structures::open_tube(8, 3, 16.0), structures::graphene_flake(9.0)}) {
    const BoundaryUnits with = boundary_units(saturated_with_hydrogen(bare)), without = boundary_units(bare);
    EXPECT_EQ(with.chains, without.chains);
    EXPECT_EQ(with.loops, without.loops);
    EXPECT_EQ(with.armchair, without.armchair);
    EXPECT_EQ(with.length, without.length);
  }
}

// Gauss and Bonnet: six times the Euler characteristic where all rings are hexagons.
TEST(BoundaryUnits, ChainsTurnAroundAFlakeOnceAndAroundATubeNot) {
  EXPECT_EQ(turning(boundary_units(structures::graphene_flake(1.5))), 6);  // benzene
  EXPECT_EQ(turning(boundary_units(structures::graphene_flake(4.0))), 6);  // coronene
  EXPECT_EQ(turning(boundary_units(structures::graphene_flake(14.0))), 6);
  EXPECT_EQ(turning(boundary_units(structures::open_tube(8, 3, 16.0))), 0);
}

TEST(BoundaryUnits, CoronenesCornersArePairsOfOpenAtoms) {
  const BoundaryUnits units = boundary_units(structures::graphene_flake(4.0));
  EXPECT_EQ(units.open_atoms, 12u);
  EXPECT_EQ(units.chains, (std::vector<std::size_t>{0, 0, 6, 6}));  // CH=CH and CH-C-CH in turn
  EXPECT_EQ(units.zigzag, 6u);
  EXPECT_EQ(units.others(), 6u);  // its corners
}

TEST(BoundaryUnits, AClosedMoleculeHasNone) {
  const BoundaryUnits units = boundary_units(structures::fullerene(1, 1));
  EXPECT_EQ(units.loops, 0u);
  EXPECT_EQ(units.open_atoms, 0u);
  EXPECT_EQ(units.length, 0.0);
}

TEST(BoundaryUnits, AnAtomWithOneNeighbourIsADeadEnd) {
  Molecule flake = structures::graphene_flake(4.0);
  EXPECT_EQ(boundary_units(flake).dead_ends, 0u);
  AtomIndex open = 0;
  std::vector<unsigned> degree(flake.size(), 0);
  for (const Bond& bond : flake.bonds) ++degree[bond.first], ++degree[bond.second];
  while (degree[open] != 2) ++open;
  flake.bonds.push_back({open, static_cast<AtomIndex>(flake.size()), {0, 0, 0}});
  flake.positions.push_back(flake.positions[open] + Vec3(0, 0, 1.4));
  flake.elements.push_back(Element::carbon);
  EXPECT_EQ(boundary_units(flake).dead_ends, 1u);
  EXPECT_EQ(boundary_units(flake).loops, 1u);
}

}  // namespace
}  // namespace nanocarbon::molecule
