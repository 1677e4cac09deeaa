// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/shapes/random_field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace nanocarbon::shapes {
namespace {

RandomField with_bumps() {
  RandomField field(3, 2, 5);
  field.add_bump({0.2, 0.1, 2.9}, 0.7, 0.3);
  field.add_bump({1.5, 2.0, 0.4}, -0.4, 0.2);
  return field;
}

TEST(RandomField, RepeatsItselfAndHasItsDerivatives) {
  const RandomField field = with_bumps();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0, 3);
  constexpr double step = 1e-5;
  for (int k = 0; k < 40; ++k) {
    const Vec3 at(uniform(random), uniform(random), uniform(random));
    const RandomField::Jet jet = field.jet(at);
    EXPECT_NEAR(jet.value, field(at), 1e-12);
    EXPECT_NEAR(field(at + Vec3(3, -6, 9)), field(at), 1e-10);
    for (int d = 0; d < 3; ++d) {
      const Vec3 to = step * Vec3::Unit(d);
      EXPECT_NEAR(jet.gradient[d], (field(at + to) - field(at - to)) / (2 * step), 1e-7);
      const Vec3 slope = (field.jet(at + to).gradient - field.jet(at - to).gradient) / (2 * step);
      EXPECT_LT((Vec3(jet.hessian.col(d)) - slope).norm(), 1e-6);
    }
  }
}

TEST(RandomField, HasUnitVarianceAndMeanZero) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const RandomField field(1, 3, seed);
    constexpr int n = 24;  // more than enough for waves of three periods
    double sum = 0, squares = 0;
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j)
        for (int k = 0; k < n; ++k) {
          const double value = field(Vec3(i, j, k) / n);
          sum += value;
          squares += value * value;
        }
    EXPECT_NEAR(sum / (n * n * n), 0, 1e-10);
    EXPECT_NEAR(squares / (n * n * n), 1, 1e-10);
  }
}

TEST(RandomField, IsLeftAsItIsWhereNothingIsTooThin) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    RandomField field(1, 2, seed);
    const double before = field({0.3, 0.4, 0.5}), thickness = 0.2 * field.wave_length();
    EXPECT_EQ(thicken_necks(field, 0, 0), 0u);
    EXPECT_EQ(field({0.3, 0.4, 0.5}), before);
    EXPECT_GT(thicken_necks(field, 0, thickness), 0u);
    EXPECT_EQ(thicken_necks(field, 0, thickness), 0u) << "once is enough";
  }
}

}  // namespace
}  // namespace nanocarbon::shapes
