// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/coordination_tables.h"

#include <gmock/gmock.h>

#include <random>

namespace nanocarbon::rebo2 {
namespace {

const CoordinationTables& tables = rebo2_tables();

//! Tables 3, 5, 7 and 9 of Brenner et al. 2002.
TEST(CoordinationTables, HaveThePublishedEntries) {
  EXPECT_NEAR(tables.p_cc.evaluate(1, 1).value, 0.003026697473481, 1e-15);
  EXPECT_NEAR(tables.p_ch.evaluate(0, 3).value, -0.303927546346162, 1e-15);
  EXPECT_EQ(tables.p_cc.evaluate(2, 0).value, 0.0);  // AIREBO has -0.0276 here
  EXPECT_EQ(tables.f_cc.evaluate(1, 1, 1).value, 0.105 / 2);
  EXPECT_EQ(tables.f_cc.evaluate(2, 2, 9).value, 0.0);
  EXPECT_EQ(tables.f_hh.evaluate(1, 1, 1).value, 0.249831916 / 2);
  EXPECT_NEAR(tables.t_cc.evaluate(2, 2, 1).value, -0.070280085 / 2, 1e-6);
  EXPECT_NEAR(tables.t_cc.evaluate(2, 2, 9).value, -0.00809675 / 2, 1e-6);
}

TEST(CoordinationTables, KeepTheirEndsBeyondThem) {
  EXPECT_EQ(tables.f_cc.evaluate(7, 1, 12).value, tables.f_cc.evaluate(4, 1, 9).value);
  EXPECT_EQ(tables.f_cc.evaluate(-1, 2, 0).value, tables.f_cc.evaluate(0, 2, 1).value);
  EXPECT_EQ(tables.p_ch.evaluate(-0.5, 1).value, tables.p_ch.evaluate(0, 1).value);
  EXPECT_EQ(tables.f_cc.evaluate(4, 2, 3).value, tables.f_cc.evaluate(3, 2, 3).value);
}

TEST(CoordinationTables, DoNotDependOnWhichEndOfABondIsFirst) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> n(0.0, 4.0), conj(1.0, 9.0);
  for (const TricubicTable* table : {&tables.f_cc, &tables.f_ch, &tables.f_hh, &tables.t_cc})
    for (int i = 0; i < 200; ++i) {
      const double a = n(random), b = n(random), c = conj(random);
      const TricubicValue ab = table->evaluate(a, b, c), ba = table->evaluate(b, a, c);
      EXPECT_NEAR(ab.value, ba.value, 1e-15);
      EXPECT_NEAR(ab.slope[0], ba.slope[1], 1e-14);
      EXPECT_NEAR(ab.slope[2], ba.slope[2], 1e-14);
    }
}

TEST(CoordinationTables, SlopesAreTheDerivatives) {
  std::mt19937_64 random(6);
  std::uniform_real_distribution<double> n(0.01, 3.99), conj(1.01, 8.99);
  constexpr double step = 1e-6;
  for (const TricubicTable* table : {&tables.f_cc, &tables.f_ch, &tables.f_hh, &tables.t_cc})
    for (int i = 0; i < 200; ++i) {
      const std::array<double, 3> x = {n(random), n(random), conj(random)};
      const TricubicValue value = table->evaluate(x[0], x[1], x[2]);
      for (int d = 0; d < 3; ++d) {
        auto up = x, down = x;
        up[d] += step;
        down[d] -= step;
        EXPECT_NEAR(
            value.slope[d],
            (table->evaluate(up[0], up[1], up[2]).value - table->evaluate(down[0], down[1], down[2]).value) /
                (2 * step),
            1e-8);
      }
    }
  for (const BicubicTable* table : {&tables.p_cc, &tables.p_ch})
    for (int i = 0; i < 200; ++i) {
      const double c = n(random), h = n(random);
      const BicubicValue value = table->evaluate(c, h);
      EXPECT_NEAR(value.slope[0],
                  (table->evaluate(c + step, h).value - table->evaluate(c - step, h).value) / (2 * step),
                  1e-8);
      EXPECT_NEAR(value.slope[1],
                  (table->evaluate(c, h + step).value - table->evaluate(c, h - step).value) / (2 * step),
                  1e-8);
    }
}

}  // namespace
}  // namespace nanocarbon::rebo2
