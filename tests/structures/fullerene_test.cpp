// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/fullerene.h"

#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::ElementsAre;
using testing::Pair;

TEST(Fullerene, EveryGoldbergPairHasTwelvePentagonsOnASphere) {
  for (int h = 0; h <= 6; ++h)
    for (int k = 0; k <= 6; ++k) {
      const std::size_t triangles = static_cast<std::size_t>(h * h + h * k + k * k);
      if (triangles < 3) continue;
      SCOPED_TRACE(testing::Message() << "(" << h << ", " << k << ")");
      const Molecule cage = fullerene(h, k);
      const Facts f = facts(cage);
      EXPECT_EQ(cage.size(), 20 * triangles);
      EXPECT_EQ(cage.bonds.size(), 30 * triangles);
      EXPECT_THAT(f.rings, ElementsAre(Pair(5, 12), Pair(6, 10 * triangles - 10)));
      EXPECT_EQ(f.euler_characteristic, 2);
      EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
      EXPECT_GT(f.shortest_bond, 1.35);
      EXPECT_LT(f.longest_bond, 1.50);
      EXPECT_GT(f.nearest_unbonded, 2.2);
    }
}

TEST(Fullerene, DodecahedronIsTheSmallest) {
  const Facts f = facts(fullerene(1, 0));
  EXPECT_THAT(f.coordination, ElementsAre(Pair(3, 20)));
  EXPECT_THAT(f.rings, ElementsAre(Pair(5, 12)));
}

TEST(Fullerene, RefusesWhatIsNoFullerene) {
  EXPECT_THROW(fullerene(0, 0), UserError);
  EXPECT_THROW(fullerene(-1, 2), UserError);
  EXPECT_THROW(fullerene(100000, 100000), UserError);
}

}  // namespace
}  // namespace nanocarbon::structures
