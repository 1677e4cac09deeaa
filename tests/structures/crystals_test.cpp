// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "nanocarbon/structures/schwarzite.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::ElementsAre;
using testing::Pair;

TEST(Diamond, EveryAtomHasFourBonds) {
  for (const int cells : {1, 2, 3}) {
    const Molecule crystal = diamond(cells, cells, cells);
    const Facts f = facts(crystal);
    EXPECT_EQ(crystal.size(), 8u * cells * cells * cells);
    EXPECT_THAT(f.coordination, ElementsAre(Pair(4, crystal.size())));
    EXPECT_NEAR(f.shortest_bond, 1.5440, 1e-4);
    EXPECT_NEAR(f.longest_bond, 1.5440, 1e-4);
  }
  EXPECT_THROW(diamond(1, 0, 1), UserError);
}

TEST(Schwarzite, D688HasTheCountsOfTheSurfaceD) {
  for (const int cells : {1, 2}) {
    const Molecule crystal = schwarzite_d688(cells, cells, cells);
    const Facts f = facts(crystal);
    const std::size_t n = static_cast<std::size_t>(cells * cells * cells);
    EXPECT_EQ(crystal.size(), 24 * n);
    EXPECT_THAT(f.coordination, ElementsAre(Pair(3, 24 * n)));
    EXPECT_THAT(f.rings, ElementsAre(Pair(6, 4 * n), Pair(8, 6 * n)));
    EXPECT_EQ(f.euler_characteristic, -2 * static_cast<long>(n));
    EXPECT_NEAR(f.shortest_bond, 1.420, 1e-3);
    EXPECT_NEAR(f.longest_bond, 1.447, 1e-3);
    EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds);
  }
  EXPECT_TRUE(facts(schwarzite_d688(2, 2, 2)).sides_agree);
}

TEST(Schwarzite, P688HasTheCountsOfTheSurfaceP) {
  for (const int cells : {1, 2}) {
    const Molecule crystal = schwarzite_p688(cells, cells, cells);
    const Facts f = facts(crystal);
    const std::size_t n = static_cast<std::size_t>(cells * cells * cells);
    EXPECT_EQ(crystal.size(), 48 * n);
    EXPECT_THAT(f.coordination, ElementsAre(Pair(3, 48 * n)));
    EXPECT_THAT(f.rings, ElementsAre(Pair(6, 8 * n), Pair(8, 12 * n)));
    EXPECT_EQ(f.euler_characteristic, -4 * static_cast<long>(n));
    EXPECT_NEAR(f.shortest_bond, 1.417, 1e-3);
    EXPECT_NEAR(f.longest_bond, 1.447, 1e-3);
    EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
  }
}

TEST(Hydrocarbons, HaveTheirFormulasAndBonds) {
  const auto formula = [](const Molecule& m) {
    const auto hydrogen = std::count(m.elements.begin(), m.elements.end(), Element::hydrogen);
    return std::array<long, 3>{static_cast<long>(m.size()) - hydrogen, hydrogen,
                               static_cast<long>(m.bonds.size())};
  };
  EXPECT_EQ(formula(methane()), (std::array<long, 3>{1, 4, 4}));
  EXPECT_EQ(formula(methyl_radical()), (std::array<long, 3>{1, 3, 3}));
  EXPECT_EQ(formula(acetylene()), (std::array<long, 3>{2, 2, 3}));
  EXPECT_EQ(formula(ethynyl_radical()), (std::array<long, 3>{2, 1, 2}));
  EXPECT_EQ(formula(ethylene()), (std::array<long, 3>{2, 4, 5}));
  EXPECT_EQ(formula(ethane()), (std::array<long, 3>{2, 6, 7}));
  EXPECT_EQ(formula(cyclopropane()), (std::array<long, 3>{3, 6, 9}));
  EXPECT_EQ(formula(benzene()), (std::array<long, 3>{6, 6, 12}));
}

}  // namespace
}  // namespace nanocarbon::structures
