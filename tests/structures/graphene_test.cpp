// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/graphene.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::ElementsAre;
using testing::Pair;

TEST(Graphene, PeriodicSheetIsATorusOfHexagons) {
  const Molecule sheet = graphene(5, 4);
  const Facts f = facts(sheet);
  EXPECT_EQ(sheet.size(), 4u * 5 * 4);
  EXPECT_THAT(f.coordination, ElementsAre(Pair(3, 80)));
  EXPECT_THAT(f.rings, ElementsAre(Pair(6, 40)));
  EXPECT_EQ(f.euler_characteristic, 0);
  EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
  EXPECT_NEAR(f.shortest_bond, 1.4204, 1e-9);
  EXPECT_NEAR(f.longest_bond, 1.4204, 1e-9);
  EXPECT_NEAR(f.nearest_unbonded, 2.460, 1e-3);
}

TEST(Graphene, OneCellIsBondedToItsOwnImages) {
  const Facts f = facts(graphene(1, 1));
  EXPECT_THAT(f.coordination, ElementsAre(Pair(3, 4)));
  EXPECT_THAT(f.rings, ElementsAre(Pair(6, 2)));
  EXPECT_EQ(f.euler_characteristic, 0);
}

TEST(Graphene, SheetTakesTheNearestNumberOfCells) {
  const Molecule sheet = graphene_sheet(50.0, 50.0);
  EXPECT_NEAR(sheet.cell->vectors(0, 0), 50.0, 1.24);
  EXPECT_NEAR(sheet.cell->vectors(1, 1), 50.0, 2.14);
}

TEST(Graphene, SmallestFlakesAreBenzeneAndCoronene) {
  EXPECT_THAT(facts(graphene_flake(1.5)).rings, ElementsAre(Pair(6, 1)));
  const Molecule coronene = graphene_flake(4.0);
  EXPECT_EQ(coronene.size(), 24u);
  EXPECT_THAT(facts(coronene).rings, ElementsAre(Pair(6, 7)));
}

TEST(Graphene, FlakeIsADiskWithoutDanglingAtoms) {
  for (const double radius : {4.0, 5.3, 8.0, 20.0}) {
    const Facts f = facts(graphene_flake(radius));
    EXPECT_EQ(f.euler_characteristic, 1) << radius;
    EXPECT_THAT(f.coordination, ElementsAre(Pair(2, testing::_), Pair(3, testing::_))) << radius;
    EXPECT_THAT(f.rings, ElementsAre(Pair(6, testing::_))) << radius;
  }
}

TEST(Graphene, RefusesNothingAtAll) {
  EXPECT_THROW(graphene(0, 3), UserError);
  EXPECT_THROW(graphene_sheet(10.0, -1.0), UserError);
  EXPECT_THROW(graphene_flake(1.0), UserError);
}

}  // namespace
}  // namespace nanocarbon::structures
