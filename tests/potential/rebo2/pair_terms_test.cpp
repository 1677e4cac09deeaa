// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/potential/rebo2/pair_terms.h"

#include <gmock/gmock.h>

namespace nanocarbon::rebo2 {
namespace {

constexpr double step = 1e-6;

void expect_slope(const auto& function, double x) {
  const double difference = (function(x + step).value - function(x - step).value) / (2.0 * step);
  EXPECT_NEAR(function(x).slope, difference, 1e-7 * (1.0 + std::abs(difference))) << "at " << x;
}

TEST(Switching, RunsFromOneToZeroWithoutAKink) {
  for (const auto& f : {&cosine_switch, &cubic_switch}) {
    EXPECT_EQ(f(1.7, 1.7, 2.0).value, 1.0);
    EXPECT_EQ(f(2.0, 1.7, 2.0).value, 0.0);
    EXPECT_EQ(f(1.0, 1.7, 2.0).slope, 0.0);
    EXPECT_EQ(f(3.0, 1.7, 2.0).value, 0.0);
    EXPECT_NEAR(f(1.85, 1.7, 2.0).value, 0.5, 1e-14);
    EXPECT_NEAR(f(1.7 + 1e-9, 1.7, 2.0).slope, 0.0, 1e-6);
    EXPECT_NEAR(f(2.0 - 1e-9, 1.7, 2.0).slope, 0.0, 1e-6);
    for (double x = 1.705; x < 2.0; x += 0.029) expect_slope([&](double t) { return f(t, 1.7, 2.0); }, x);
  }
}

TEST(PairTerms, SlopesAreTheDerivatives) {
  for (const PairParameters& pair : rebo2_parameters().pairs)
    for (double r = 0.8; r < 2.1; r += 0.1) {
      expect_slope([&](double x) { return pair_repulsion(pair, x); }, r);
      expect_slope([&](double x) { return pair_attraction(pair, x); }, r);
    }
}

//! Brenner et al. 2002, section 2.1: pair terms and whole weights for typical bonds.
TEST(PairTerms, RepelAndAttract) {
  for (const PairParameters& pair : rebo2_parameters().pairs) {
    EXPECT_GT(pair_repulsion(pair, 1.0).value, 0.0);
    EXPECT_LT(pair_attraction(pair, 1.0).value, 0.0);
    EXPECT_EQ(bond_weight(pair, pair.cutoff_begin).value, 1.0);
    EXPECT_EQ(bond_weight(pair, pair.cutoff_end).value, 0.0);
  }
}

//! The H2 molecule, whose bond order is 1: D_e = 4.506 eV at 0.7415887 Angstrom is what its terms were fitted
//! to.
TEST(PairTerms, HydrogenMoleculeHasItsBondEnergyAndLength) {
  const PairParameters& pair = rebo2_parameters().pairs[pair_index(Element::hydrogen, Element::hydrogen)];
  const auto energy = [&](double r) {
    return pair_repulsion(pair, r).value + pair_attraction(pair, r).value;
  };
  EXPECT_NEAR(energy(pair.equilibrium), -4.75, 0.03);
  EXPECT_NEAR(pair_repulsion(pair, pair.equilibrium).slope + pair_attraction(pair, pair.equilibrium).slope,
              0.0, 0.01);
}

}  // namespace
}  // namespace nanocarbon::rebo2
