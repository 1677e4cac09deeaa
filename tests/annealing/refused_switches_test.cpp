// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/refused_switches.h"

#include <gtest/gtest.h>

#include <numeric>
#include <set>

#include "support/rough_sphere.h"

namespace nanocarbon::annealing {
namespace {

std::vector<std::uint32_t> numbered(const TrivalentNetwork& network) {
  std::vector<std::uint32_t> identity(network.atoms.size());
  std::iota(identity.begin(), identity.end(), 0u);
  return identity;
}

TEST(SwitchKey, TellsEveryBondApartAndHasOneForBothItsEnds) {
  const TrivalentNetwork network = trivalent_network(test::unit_sphere(4));
  const auto identity = numbered(network);
  std::set<std::uint64_t> keys;
  std::size_t switches = 0;
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    for (unsigned s = 0; s < 3; ++s)
      for (const auto& edit : {flip_bond(network, a, s), collapse_bond(network, a, s)})
        if (edit) {
          keys.insert(switch_key(*edit, identity));
          ++switches;
        }
  EXPECT_GT(switches, network.atoms.size());
  EXPECT_EQ(2 * keys.size(), switches);
}

TEST(SwitchKey, TellsSplitsApart) {
  const TrivalentNetwork network = trivalent_network(test::unit_sphere(4));
  const auto identity = numbered(network);
  const auto key = [&](RingIndex ring, unsigned first) {
    return switch_key(split_ring(network, ring, first, 3).value(), identity);
  };
  std::set<std::uint64_t> keys;
  std::size_t hexagons = 0;
  for (RingIndex ring = 0; ring < network.rings.size(); ++ring) {
    if (network.rings[ring].size != 6) continue;
    ++hexagons;
    // Atoms go into opposite bonds of a hexagon, of which there are three pairs.
    for (unsigned first = 0; first < 3; ++first) keys.insert(key(ring, first));
  }
  EXPECT_EQ(keys.size(), 3 * hexagons);
}

// An atom's entry may change when others are removed; the switch at it stays the same.
TEST(SwitchKey, FollowsIdentitiesAndNotEntries) {
  const TrivalentNetwork network = trivalent_network(test::unit_sphere(4));
  const auto edit = flip_bond(network, 0, 0);
  ASSERT_TRUE(edit);
  auto identity = numbered(network);
  const std::uint64_t before = switch_key(*edit, identity);
  for (std::uint32_t& i : identity) ++i;
  EXPECT_NE(switch_key(*edit, identity), before);
}

TEST(RefusedSwitches, RefuseOnlyWhatIsAllowedNoMoreThanBefore) {
  RefusedSwitches refused;
  refused.add(7, 0.5, 10);
  EXPECT_TRUE(refused.contains(7, 0.4, 3));
  EXPECT_FALSE(refused.contains(7, 0.6, 3));
  EXPECT_FALSE(refused.contains(8, 0.4, 3));
}

TEST(RefusedSwitches, AreOutOfDateWhereAtomsHaveMovedSince) {
  RefusedSwitches refused;
  refused.add(7, 0.5, 10);
  EXPECT_TRUE(refused.contains(7, 0.4, 9));
  EXPECT_FALSE(refused.contains(7, 0.4, 10));
  EXPECT_FALSE(refused.contains(7, 0.4, 11));
}

TEST(RefusedSwitches, AreForgottenAfterThreeBlocks) {
  RefusedSwitches refused;
  refused.add(7, 0.5, 10);
  refused.next_block();
  refused.next_block();
  EXPECT_TRUE(refused.contains(7, 0.4, 3));
  refused.next_block();
  EXPECT_FALSE(refused.contains(7, 0.4, 3));
}

}  // namespace
}  // namespace nanocarbon::annealing
