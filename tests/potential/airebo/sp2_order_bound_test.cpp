// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/airebo/sp2_order_bound.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "nanocarbon/potential/airebo/parameters.h"
#include "nanocarbon/potential/airebo/trigonal_term.h"
#include "nanocarbon/potential/rebo2/angular_spline.h"

namespace nanocarbon::airebo {
namespace {

const rebo2::CarbonAngles& angles() { return airebo_parameters().rebo.carbon; }

double g(double cosine) { return rebo2::angular_carbon(angles(), cosine, 3.0).value; }

TEST(Sp2OrderBound, IsBelowGEverywhereAndCloseWhereSheetsFaceEachOther) {
  const Sp2OrderBound bound(angles());
  for (int s = 0; s <= 20000; ++s) {
    const double cosine = -1.0 + s * 1e-4;
    EXPECT_LE(bound.below_g(cosine), g(cosine)) << cosine;
    EXPECT_GT(bound.below_g(cosine), std::min(g(cosine), g(0.45)) - 0.03) << cosine;
  }
}

// (p_ij + p_ji)/2 of Stuart et al. 2000, equation 15, written out.
double order(const TrigonalPair& pair) {
  double sum_i = pair.i->base, sum_j = pair.j->base;
  for (int b = 0; b < 9; b += 3) {
    double at_i = 0.0, at_j = 0.0;
    for (int d = 0; d < 3; ++d) {
      at_i += pair.i->along[b + d] * pair.along[d];
      at_j -= pair.j->along[b + d] * pair.along[d];
    }
    sum_i += g(at_i);
    sum_j += g(at_j);
  }
  return 0.5 * (1.0 / std::sqrt(sum_i) + 1.0 / std::sqrt(sum_j));
}

TEST(Sp2OrderBound, MissesNoPairAndSortsOutMostOfThoseThatItMay) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  const auto direction = [&](double* to) {
    Vec3 v(normal(random), normal(random), normal(random));
    v.normalize();
    std::copy(v.begin(), v.end(), to);
  };
  std::vector<TrigonalCarbon> carbons(200);
  for (TrigonalCarbon& c : carbons) {
    for (int b = 0; b < 9; b += 3) direction(&c.along[b]);
    c.base = 0.97;
  }
  std::vector<TrigonalPair> pairs;
  for (std::size_t k = 0; k < 3003; ++k) {
    pairs.push_back({&carbons[k % 200], &carbons[k * 7 % 199], {}});
    direction(pairs.back().along.data());
  }
  const Sp2OrderBound bound(angles());
  for (const double limit : {0.6, 0.77}) {
    std::vector<std::uint32_t> found;
    bound.find_high(pairs, limit, found);
    std::vector<char> high(pairs.size(), 0);
    for (const std::uint32_t n : found) high[n] = 1;
    std::size_t wrongly = 0;
    for (std::size_t n = 0; n < pairs.size(); ++n) {
      EXPECT_TRUE(high[n] || order(pairs[n]) <= limit) << n;
      wrongly += high[n] && order(pairs[n]) <= limit;
    }
    EXPECT_LT(wrongly, pairs.size() / 4);  // whatever way bonds point; of facing sheets next to none
  }
}

TEST(TrigonalTerm, IsOfAireboWhoseTablesVanishAtThreeAndThreeBonds) {
  EXPECT_TRUE(trigonal_order_is_plain(airebo_parameters().rebo));
  EXPECT_TRUE(trigonal_order_is_plain(airebo_m_parameters().rebo));
}

}  // namespace
}  // namespace nanocarbon::airebo
