// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/bond_graph.h"

#include <gmock/gmock.h>

#include <random>

#include "molecule/cases.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"

namespace nanocarbon::topology {
namespace {

using testing::ElementsAre;

TEST(BondGraph, FindsTheBondsOfKnownStructures) {
  for (const Molecule& known : {structures::fullerene(3, 3), structures::graphene(1, 1),
                                structures::graphene(2, 1), structures::graphene(5, 3), structures::methane(),
                                structures::ethane(), structures::acetylene(), structures::benzene()}) {
    const Cell* cell = known.cell ? &*known.cell : nullptr;
    EXPECT_TRUE(bonds_within(known.positions, known.elements, cell) == known.bonds);
  }
}

TEST(BondGraph, FormsAndBreaksWithHysteresis) {
  const std::vector<Element> elements(2, Element::carbon);
  std::vector<Bond> bonds;
  const auto bonded_at = [&](double distance) {
    const std::vector<Vec3> positions = {Vec3(0, 0, 0), Vec3(0, distance, 0)};
    bonds = bonds_within(positions, elements, nullptr, {}, bonds);
    return !bonds.empty();
  };
  EXPECT_FALSE(bonded_at(1.8));
  EXPECT_TRUE(bonded_at(1.69));
  EXPECT_TRUE(bonded_at(1.8));
  EXPECT_TRUE(bonded_at(1.99));
  EXPECT_FALSE(bonded_at(2.01));
  EXPECT_FALSE(bonded_at(1.8));
}

TEST(BondGraph, EachPairOfElementsHasItsOwnWindow) {
  const auto bonded = [](Element a, Element b, double distance) {
    const std::vector<Vec3> positions = {Vec3(0, 0, 0), Vec3(0, 0, distance)};
    const std::vector<Element> elements = {a, b};
    return !bonds_within(positions, elements, nullptr).empty();
  };
  EXPECT_TRUE(bonded(Element::carbon, Element::carbon, 1.6));
  EXPECT_FALSE(bonded(Element::hydrogen, Element::carbon, 1.6));
  EXPECT_TRUE(bonded(Element::hydrogen, Element::carbon, 1.2));
  EXPECT_FALSE(bonded(Element::hydrogen, Element::hydrogen, 1.2));
  EXPECT_TRUE(bonded(Element::hydrogen, Element::hydrogen, 0.74));
}

TEST(BondGraph, HysteresisDoesNotDependOnWrapping) {
  // A stretched bond across the boundary, first as given, then with one of its atoms wrapped to the other
  // side.
  const Cell cell = orthogonal_cell(Vec3(10, 10, 10));
  const std::vector<Element> elements(2, Element::carbon);
  const std::vector<Vec3> start = {Vec3(9.5, 5, 5), Vec3(11.0, 5, 5)},
                          wrapped = {Vec3(9.5, 5, 5), Vec3(1.4, 5, 5)};
  const std::vector<Bond> before = bonds_within(start, elements, &cell);
  EXPECT_THAT(before, ElementsAre(Bond{0, 1, {0, 0, 0}}));
  const std::vector<Bond> after = bonds_within(wrapped, elements, &cell, {}, before);
  EXPECT_THAT(after, ElementsAre(Bond{0, 1, {1, 0, 0}}));
  EXPECT_TRUE(compare_bonds(bonded_ids(before), bonded_ids(after)).none());
}

TEST(BondGraph, CountsBondsToSeveralImages) {
  // In a cell of 2.8 Angstrom a chain's atom is bonded to the other one twice; stretched to 3.6 both bonds
  // hold, at 4.2 none.
  const std::vector<Element> elements(2, Element::carbon);
  std::vector<Bond> bonds;
  for (const auto& [length, count] : {std::pair{2.8, 2u}, {3.6, 2u}, {4.2, 0u}, {3.6, 0u}}) {
    const Cell cell = orthogonal_cell(Vec3(length, 20, 20));
    const std::vector<Vec3> positions = {Vec3(0, 0, 0), Vec3(0.5 * length, 0, 0)};
    bonds = bonds_within(positions, elements, &cell, {}, bonds);
    EXPECT_EQ(bonds.size(), count) << length;
  }
}

TEST(BondGraph, UnchangedPositionsKeepEveryBond) {
  const Molecule molecule = test::with_bonds_by_distance(test::rattled(structures::graphene(6, 4), 0.12, 4));
  EXPECT_TRUE(test::with_updated_bonds(molecule).bonds == molecule.bonds);
}

TEST(CompareBonds, TellsBrokenAndFormed) {
  const std::vector<BondedIds> start = {{1, 2}, {1, 2}, {2, 5}, {3, 9}}, now = {{1, 2}, {2, 3}, {3, 9}};
  const BondChanges changes = compare_bonds(start, now);
  EXPECT_THAT(changes.broken, ElementsAre(BondedIds{1, 2}, BondedIds{2, 5}));
  EXPECT_THAT(changes.formed, ElementsAre(BondedIds{2, 3}));
  EXPECT_TRUE(compare_bonds(start, start).none());
}

TEST(RepelledAtoms, AreThoseOutsideTheComponentOfMost) {
  const std::vector<std::uint32_t> initial = {0, 0, 0, 0, 1, 1, 1};
  EXPECT_THAT(repelled_atoms(initial, initial), testing::Each(false));
  const std::vector<std::uint32_t> torn = {0, 1, 1, 1, 2, 2, no_component};
  EXPECT_THAT(repelled_atoms(initial, torn), ElementsAre(true, false, false, false, false, false, true));
  const std::vector<std::uint32_t> merged = {0, 0, 0, 0, 0, 0, 0};
  EXPECT_THAT(repelled_atoms(initial, merged), testing::Each(false));
}

TEST(RepelledAtoms, OfEqualPartsTheOneWithTheLowestAtomStays) {
  const std::vector<std::uint32_t> initial = {0, 0, 0, 0}, halves = {3, 1, 1, 3};
  EXPECT_THAT(repelled_atoms(initial, halves), ElementsAre(false, true, true, false));
  const std::vector<std::uint32_t> all_lost(4, no_component);
  EXPECT_THAT(repelled_atoms(initial, all_lost), testing::Each(true));
  EXPECT_TRUE(repelled_atoms({}, {}).empty());
}

}  // namespace
}  // namespace nanocarbon::topology
