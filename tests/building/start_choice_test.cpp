// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/start_choice.h"

#include <gtest/gtest.h>

#include "nanocarbon/building/annealed_options.h"

namespace nanocarbon::building {
namespace {

// One is better, and the other is not.
void expect_better(const Released& one, const Released& other, double tether = default_tether) {
  EXPECT_TRUE(is_better(one, other, tether));
  EXPECT_FALSE(is_better(other, one, tether));
}

// The promise to users: within 1 Angstrom where the shape allows.
TEST(StartChoice, WithinOneAngstromComesFirst) { expect_better({-7.33, 0.99}, {-7.39, 1.01}); }

TEST(StartChoice, WithinOneAngstromTheLeastEnergyIsBest) { expect_better({-7.36, 0.99}, {-7.359, 0.1}); }

TEST(StartChoice, BeyondItAnAngstromIsWorthThirtyMillielectronvolts) {
  expect_better({-7.371, 2.5}, {-7.34, 1.5});
  expect_better({-7.34, 1.5}, {-7.369, 2.5});
}

TEST(StartChoice, AStifferTetherPrefersWhatIsNearer) {
  const Released nearer{-7.34, 0.5}, lower{-7.36, 0.9};
  expect_better(lower, nearer);
  expect_better(nearer, lower, 0.2);
}

TEST(StartChoice, ASofterTetherPrefersWhatIsLower) {
  const Released nearer{-7.34, 0.9}, lower{-7.36, 1.6};
  expect_better(nearer, lower);
  expect_better(lower, nearer, 0.02);
  expect_better(lower, nearer, 0);
}

// What is left out of the surface counts as much as how far the atoms are from it.
TEST(StartChoice, TheLargerDistanceCounts) {
  EXPECT_FALSE(is_near({-7.33, 0.5, 1.01}, default_tether));
  EXPECT_FALSE(is_near({-7.33, 1.01, 0.5}, default_tether));
  expect_better({-7.33, 0.9, 0.9}, {-7.39, 0.1, 1.2});
}

TEST(StartChoice, NoneIsBetterThanItself) {
  EXPECT_FALSE(is_better({-7.36, 1.5}, {-7.36, 1.5}, default_tether));
}

}  // namespace
}  // namespace nanocarbon::building
