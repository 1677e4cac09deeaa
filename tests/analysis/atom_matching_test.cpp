// SPDX-License-Identifier: GPL-2.0-or-later
// Frames made of one whose atoms are known: which atom is which must come out again.
#include "nanocarbon/analysis/atom_matching.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <random>

#include "bonded.h"
#include "nanocarbon/structures/graphene.h"

namespace nanocarbon::analysis {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

// Each coordinate moved by a hot solid's noise between two frames.
Molecule shaken(Molecule molecule, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0.0, 0.1);
  for (Vec3& position : molecule.positions) position += Vec3(noise(random), noise(random), noise(random));
  return molecule;
}

Molecule permuted(const Molecule& molecule, const std::vector<AtomIndex>& order) {
  Molecule result = molecule;
  for (std::size_t k = 0; k < order.size(); ++k) {
    result.positions[k] = molecule.positions[order[k]];
    result.elements[k] = molecule.elements[order[k]];
  }
  return result;
}

TEST(AtomMatching, AtomsInTheSameOrderKeepTheirIds) {
  const Molecule before = structures::graphene(7, 4);
  const auto ids = test::numbered(before);
  const AtomMatching matching = match_atoms(shaken(before, 1), before, ids, 1000);
  EXPECT_EQ(matching.ids, ids);
  EXPECT_THAT(matching.doubt, IsEmpty());
}

TEST(AtomMatching, AtomsThatVanishAreFoundAlsoInTheMiddleOfTheFile) {
  const Molecule before = structures::graphene(7, 4);
  const AtomMatching matching =
      match_atoms(shaken(test::without(before, {3, 50, 51}), 2), before, test::numbered(before), 1000);
  std::vector<std::int64_t> expected = test::numbered(before);
  std::erase_if(expected, [](std::int64_t id) { return id == 4 || id == 51 || id == 52; });
  EXPECT_EQ(matching.ids, expected);
  EXPECT_THAT(matching.doubt, HasSubstr("which ones are gone"));
}

TEST(AtomMatching, NewAtomsGetNewIds) {
  const Molecule whole = structures::graphene(7, 4);
  const Molecule before = test::without(whole, {10});
  const AtomMatching matching = match_atoms(shaken(whole, 3), before, test::numbered(before), 1000);
  EXPECT_EQ(matching.ids[9], 10);
  EXPECT_EQ(matching.ids[10], 1000);
  EXPECT_EQ(matching.ids[11], 11);
}

TEST(AtomMatching, AnotherOrderIsToldByPlaceThroughTheFacesOfTheCell) {
  const Molecule before = structures::graphene(7, 4);
  std::vector<AtomIndex> order(before.size());
  for (AtomIndex a = 0; a < order.size(); ++a) order[a] = a;
  std::shuffle(order.begin(), order.end(), std::mt19937(4));
  Molecule now = permuted(shaken(before, 4), order);
  now.positions[5] += now.cell->vectors.col(0);  // an image of it
  const AtomMatching matching = match_atoms(now, before, test::numbered(before), 1000);
  for (std::size_t k = 0; k < order.size(); ++k)
    EXPECT_EQ(matching.ids[k], static_cast<std::int64_t>(order[k]) + 1);
  EXPECT_THAT(matching.doubt, HasSubstr("order differs"));
}

// By a vector of the lattice, where each atom comes to lie where another was.
TEST(AtomMatching, AWholeThatDriftsKeepsItsOrder) {
  Molecule before = structures::graphene(7, 4);
  before.cell.reset();
  Molecule now = shaken(before, 5);
  for (Vec3& position : now.positions) position += Vec3(2.46, 0.1, 0);
  const AtomMatching matching = match_atoms(now, before, test::numbered(before), 1000);
  EXPECT_EQ(matching.ids, test::numbered(before));
  EXPECT_THAT(matching.doubt, IsEmpty());
}

// A bond apart, which is little.
TEST(AtomMatching, NeighboursThatHaveChangedPlacesInTheFileAreToldByPlace) {
  const Molecule before = structures::graphene(7, 4);
  std::vector<AtomIndex> order(before.size());
  for (AtomIndex a = 0; a < order.size(); ++a) order[a] = a ^ 1u;
  const AtomMatching matching =
      match_atoms(permuted(shaken(before, 6), order), before, test::numbered(before), 1000);
  for (std::size_t k = 0; k < order.size(); ++k)
    EXPECT_EQ(matching.ids[k], static_cast<std::int64_t>(order[k]) + 1);
  EXPECT_THAT(matching.doubt, HasSubstr("order differs"));
}

TEST(AtomMatching, WhereNearlyAllAtomsHaveMovedFarItSaysThatOnlyTheOrderIsLeft) {
  const Molecule before = structures::graphene(7, 4);
  Molecule now = test::without(before, {0});
  for (Vec3& position : now.positions) position.z() += 3.0;
  const AtomMatching matching = match_atoms(now, before, test::numbered(before), 1000);
  EXPECT_THAT(matching.doubt, HasSubstr("same order"));
}

}  // namespace
}  // namespace nanocarbon::analysis
