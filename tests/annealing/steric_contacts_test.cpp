// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/steric_contacts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace nanocarbon::annealing {
namespace {

// Two chains of eight atoms, side by side at the given distance, not bonded to each other.
struct Chains {
  explicit Chains(double apart) {
    for (AtomIndex c = 0; c < 2; ++c)
      for (AtomIndex k = 0; k < 8; ++k) {
        positions.push_back(Vec3(1.42 * k, apart * c, 0));
        graph.neighbours.push_back(
            {k > 0 ? 8 * c + k - 1 : no_atom, k < 7 ? 8 * c + k + 1 : no_atom, no_atom});
      }
  }
  std::vector<Vec3> positions;
  FixedBondGraph graph;
};

TEST(StericContacts, AtomsOfTheSameNeighbourhoodDoNotRepel) {
  const Chains far(10.0);
  StericContacts contacts;
  std::vector<Vec3> gradient(far.positions.size(), Vec3::Zero());
  EXPECT_EQ(contacts.evaluate(far.positions, far.graph, gradient), 0);
}

TEST(StericContacts, SheetsThatNearlyTouchArePushedApart) {
  const Chains near(2.2);
  StericContacts contacts;
  std::vector<Vec3> gradient(near.positions.size(), Vec3::Zero());
  EXPECT_GT(contacts.evaluate(near.positions, near.graph, gradient), 0);
  for (AtomIndex k = 0; k < 8; ++k) {
    EXPECT_GT(gradient[k].y(), 0);
    EXPECT_LT(gradient[8 + k].y(), 0);
  }
}

TEST(StericContacts, TheGraphSaysHowFarTheyReach) {
  Chains chains(3.7);  // beyond what is listed by default
  StericContacts contacts;
  std::vector<Vec3> gradient(chains.positions.size(), Vec3::Zero());
  EXPECT_EQ(contacts.evaluate(chains.positions, chains.graph, gradient), 0);
  chains.graph.steric_reach = 3.8;
  double expected = 0;
  Vec3 unused = Vec3::Zero();
  for (AtomIndex a = 0; a < 8; ++a)
    for (AtomIndex b = 8; b < 16; ++b)
      expected += steric_pair(chains.positions[a], chains.positions[b], 3.8, unused);
  EXPECT_GT(expected, 0);
  EXPECT_NEAR(contacts.evaluate(chains.positions, chains.graph, gradient), expected, 1e-12);
  chains.graph.steric_reach = 2.9;
  EXPECT_EQ(contacts.evaluate(chains.positions, chains.graph, gradient), 0);
}

TEST(StericContacts, PairsAreFoundAgainAfterAtomsHaveMoved) {
  Chains chains(10.0);
  StericContacts contacts;
  std::vector<Vec3> gradient(chains.positions.size(), Vec3::Zero());
  EXPECT_EQ(contacts.evaluate(chains.positions, chains.graph, gradient), 0);
  for (AtomIndex k = 8; k < 16; ++k) chains.positions[k].y() = 2.5;
  EXPECT_GT(contacts.evaluate(chains.positions, chains.graph, gradient), 0);
}

TEST(StericContacts, PairsAreFoundAgainWhereEverythingMovesFarAndTwoPartsMeet) {
  Chains chains(4.5);
  StericContacts contacts;
  std::vector<Vec3> gradient(chains.positions.size(), Vec3::Zero());
  contacts.renew(chains.positions, chains.graph);
  for (int step = 1; step <= 20; ++step) {
    for (AtomIndex a = 0; a < 16; ++a) chains.positions[a] += Vec3(0.7, 0.4, -1.1);
    for (AtomIndex k = 8; k < 16; ++k) chains.positions[k].y() -= 0.1;
    StericContacts fresh;
    EXPECT_EQ(contacts.evaluate(chains.positions, chains.graph, gradient),
              fresh.evaluate(chains.positions, chains.graph, gradient));
  }
}

// Large molecules renew pairs where something has moved. Rungs of a ladder stand for bonds; its sides are pressed
// against each other here and there, and the whole swings.
TEST(StericContacts, LargeMoleculesAreRepelledByTheSamePairs) {
  Chains chains(10.0);
  chains.positions.clear();
  chains.graph.neighbours.clear();
  constexpr AtomIndex length = 1500;
  for (AtomIndex c = 0; c < 2; ++c)
    for (AtomIndex k = 0; k < length; ++k) {
      chains.positions.push_back(Vec3(1.42 * k, 3.5 * c, 0));
      chains.graph.neighbours.push_back(
          {k > 0 ? length * c + k - 1 : no_atom, k + 1 < length ? length * c + k + 1 : no_atom, no_atom});
    }
  StericContacts contacts;
  ThreadTeam team(2);
  double largest = 0;
  for (int step = 0; step < 40; ++step) {
    for (AtomIndex k = 0; k < length; ++k) {
      chains.positions[length + k].y() = 3.5 - 1.2 * std::pow(std::sin(0.01 * k + 0.3 * step), 8);
      for (const AtomIndex a : {k, length + k}) chains.positions[a].z() = 0.2 * step * std::sin(0.002 * k);
    }
    std::vector<Vec3> kept(chains.positions.size(), Vec3::Zero()), fresh = kept;
    StericContacts all;
    all.renew(chains.positions, chains.graph);
    double energy = 0;
    for (AtomIndex a = 0; a < chains.positions.size(); ++a)
      for (const AtomIndex b : all.near(a)) {
        const double pair =
            steric_pair(chains.positions[a], chains.positions[b], default_steric_reach, fresh[a]);
        if (b > a) energy += pair;
      }
    EXPECT_NEAR(contacts.evaluate(chains.positions, chains.graph, kept, step % 2 ? &team : nullptr), energy,
                1e-9 * energy);
    EXPECT_EQ(kept, fresh);
    largest = std::max(largest, energy);
  }
  EXPECT_GT(largest, 1);
}

TEST(StericContacts, ForceIsTheSlopeOfTheEnergy) {
  const Vec3 a(0.1, 0.2, 0.3), b(1.4, -0.5, 1.9);
  Vec3 gradient = Vec3::Zero(), unused = Vec3::Zero();
  steric_pair(a, b, default_steric_reach, gradient);
  for (int d = 0; d < 3; ++d) {
    const Vec3 h = 1e-6 * Vec3::Unit(d);
    EXPECT_NEAR(gradient[d],
                (steric_pair(a + h, b, default_steric_reach, unused) -
                 steric_pair(a - h, b, default_steric_reach, unused)) /
                    2e-6,
                1e-7);
  }
  EXPECT_EQ(steric_pair(Vec3::Zero(), Vec3(3.2, 0, 0), 3.2, unused), 0);
}

}  // namespace
}  // namespace nanocarbon::annealing
