// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/network_edit.h"

#include <gtest/gtest.h>

#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::annealing {
namespace {

// Everything that makes the network a closed surface of Euler characteristic 2 with consistent records.
void expect_sphere(const TrivalentNetwork& network) {
  std::size_t rings = 0;
  std::vector<AtomIndex> cycle;
  for (RingIndex r = 0; r < network.rings.size(); ++r) {
    if (network.rings[r].size == 0) continue;
    ++rings;
    atoms_of_ring(network, r, cycle);
    ASSERT_EQ(cycle.size(), network.rings[r].size) << "ring " << r;
    for (const AtomIndex a : cycle) ASSERT_LT(slot_of_ring(network.atoms[a], r), 3u);
  }
  for (AtomIndex a = 0; a < network.atoms.size(); ++a) {
    const TrivalentAtom& atom = network.atoms[a];
    if (!atom.exists()) continue;
    for (unsigned s = 0; s < 3; ++s) {
      const TrivalentAtom& other = network.atoms[atom.neighbour[s]];
      const unsigned back = slot_of_neighbour(other, a);
      ASSERT_LT(back, 3u);
      // The bond separates the same two rings, seen from either end.
      ASSERT_EQ(atom.ring[(s + 1) % 3], other.ring[(back + 2) % 3]);
      ASSERT_EQ(atom.ring[(s + 2) % 3], other.ring[(back + 1) % 3]);
    }
  }
  // V - E + F of the bond graph with 3 V = 2 E.
  EXPECT_EQ(static_cast<long>(rings) - static_cast<long>(atom_count(network)) / 2, 2);
}

TEST(NetworkEdit, AStoneWalesSwitchAmongHexagonsMakesTwoPentagonsAndTwoHeptagons) {
  TrivalentNetwork network = trivalent_network(structures::icosahedral_triangulation(3, 0));
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  // A bond between four hexagons exists in C180; switched, it is the 5-7-7-5 defect.
  for (AtomIndex a = 0; a < network.atoms.size(); ++a)
    for (unsigned s = 0; s < 3; ++s) {
      const auto edit = flip_bond(network, a, s);
      ASSERT_TRUE(edit);
      bool hexagons = true;
      for (const auto& [ring, change] : edit->rings) hexagons &= network.rings[ring].size == 6;
      if (!hexagons) continue;
      commit_edit(network, *edit, free_atoms, free_rings);
      expect_sphere(network);
      const auto counts = ring_counts(network);
      EXPECT_EQ(counts[5], 14u);
      EXPECT_EQ(counts[7], 2u);
      return;
    }
  FAIL() << "no bond between four hexagons";
}

TEST(NetworkEdit, SplitThenCollapseOfTheNewBondRestoresTheCounts) {
  TrivalentNetwork network = trivalent_network(structures::icosahedral_triangulation(3, 0));
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  RingIndex hexagon = 0;
  while (network.rings[hexagon].size != 6) ++hexagon;
  const auto edit = split_ring(network, hexagon, 0, 3);
  ASSERT_TRUE(edit);
  const AtomIndex u = commit_edit(network, *edit, free_atoms, free_rings).atoms[0];
  expect_sphere(network);
  EXPECT_EQ(atom_count(network), 182u);
  const auto back = collapse_bond(network, u, 1);  // of the bond between the two that were added
  ASSERT_TRUE(back);
  commit_edit(network, *back, free_atoms, free_rings);
  expect_sphere(network);
  EXPECT_EQ(atom_count(network), 180u);
  const auto counts = ring_counts(network);
  EXPECT_EQ(counts[5], 12u);
  EXPECT_EQ(counts[6], 80u);
}

TEST(NetworkEdit, RandomEditsKeepTheSurfaceClosed) {
  TrivalentNetwork network = trivalent_network(structures::icosahedral_triangulation(2, 2));
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  RandomStream random(3, 0);
  int made[3] = {0, 0, 0};
  for (int trial = 0; trial < 3000; ++trial) {
    const auto atom = static_cast<AtomIndex>(random.below(network.atoms.size()));
    if (!network.atoms[atom].exists()) continue;
    const auto slot = static_cast<unsigned>(random.below(3));
    const RingIndex ring = network.atoms[atom].ring[slot];
    const std::uint64_t kind = random.below(4);
    const std::uint32_t size = network.rings[ring].size;
    const auto edit = kind == 0   ? collapse_bond(network, atom, slot)
                      : kind == 1 ? split_ring(network, ring, static_cast<unsigned>(random.below(size)),
                                               static_cast<unsigned>(1 + random.below(size - 1)))
                                  : flip_bond(network, atom, slot);
    if (!edit) continue;
    bool small = false;  // below 4 the triangulation is no longer simple
    for (const auto& [r, change] : edit->rings) {
      const int after = change + (is_added_ring(r) ? 0 : static_cast<int>(network.rings[r].size));
      small |= after != 0 && after < 4;
    }
    if (small) continue;
    commit_edit(network, *edit, free_atoms, free_rings);
    ++made[static_cast<int>(edit->kind)];
    if (trial % 50 == 0) expect_sphere(network);
    if (testing::Test::HasFatalFailure()) return;
  }
  for (const int count : made) EXPECT_GT(count, 100);
  compact(network);
  expect_sphere(network);
}

// Each of its bonds has a place of the boundary at both ends, which a switch would join.
TEST(NetworkEdit, ABondBetweenBoundaryAtomsOfOneRingStays) {
  TriangleMesh fan;
  fan.points.resize(7, Vec3::Zero());
  for (VertexIndex k = 0; k < 6; ++k) fan.triangles.push_back({0, 1 + k, 1 + (k + 1) % 6});
  const TrivalentNetwork network = trivalent_network(fan);
  for (unsigned s = 0; s < 3; ++s) {
    EXPECT_FALSE(flip_bond(network, 0, s));
    EXPECT_FALSE(collapse_bond(network, 0, s));
  }
}

}  // namespace
}  // namespace nanocarbon::annealing
