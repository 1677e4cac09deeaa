// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/bond_statistics.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numeric>

#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"

namespace nanocarbon::molecule {
namespace {

TEST(BondStatistics, OfKnownLengths) {
  const std::vector<double> lengths = {1.0, 1.2, 1.5, 1.8, 2.0, 1.5};
  const LengthStatistics s = length_statistics(lengths, {1.2, 1.8}, 2);
  EXPECT_EQ(s.lengths.count, 6u);
  EXPECT_DOUBLE_EQ(s.lengths.min, 1.0);
  EXPECT_DOUBLE_EQ(s.lengths.max, 2.0);
  EXPECT_DOUBLE_EQ(s.lengths.mean, 1.5);
  EXPECT_DOUBLE_EQ(s.lengths.deviation, std::sqrt((0.25 + 0.09 + 0.09 + 0.25) / 6.0));
  EXPECT_EQ(s.below, 1u);
  EXPECT_EQ(s.above, 1u);
  EXPECT_DOUBLE_EQ(s.fraction_outside, 2.0 / 6.0);
  EXPECT_EQ(std::accumulate(s.histogram.begin(), s.histogram.end(), std::size_t{0}), 4u);
}

TEST(BondStatistics, OfNothing) {
  const LengthStatistics s = length_statistics({});
  EXPECT_EQ(s.lengths.count, 0u);
  EXPECT_EQ(s.fraction_outside, 0.0);
}

TEST(BondStatistics, AFlatSheetHasOneLengthAndAnglesOf120Degrees) {
  const Molecule molecule = dual(test::scaled_to_carbon(test::sheet(5, 5)));
  const Spread lengths = spread(bond_lengths(molecule)), angles = spread(bond_angles(molecule));
  EXPECT_NEAR(lengths.min, 1.42, 1e-12);
  EXPECT_NEAR(lengths.max, 1.42, 1e-12);
  EXPECT_NEAR(angles.mean, 120.0, 1e-9);
  EXPECT_NEAR(angles.deviation, 0.0, 1e-9);
}

TEST(BondStatistics, CrossPeriodicBoundaries) {
  Molecule chain;
  chain.positions = {Vec3(0.1, 0, 0), Vec3(1.5, 0, 0)};
  chain.elements = {Element::carbon, Element::carbon};
  chain.cell = orthogonal_cell(Vec3(2.8, 10, 10));
  chain.bonds = {{0, 1, {-1, 0, 0}}, {0, 1, {0, 0, 0}}};
  EXPECT_THAT(bond_lengths(chain), testing::Each(testing::DoubleNear(1.4, 1e-12)));
  EXPECT_THAT(bond_angles(chain), testing::Each(testing::DoubleNear(180.0, 1e-6)));
}

}  // namespace
}  // namespace nanocarbon::molecule
