// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/boundary_edit.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "nanocarbon/core/random_stream.h"

namespace nanocarbon::annealing {
namespace {

// A lattice of so many vertices each way with equal triangles.
TriangleMesh lattice(unsigned width, unsigned height) {
  TriangleMesh mesh;
  for (unsigned y = 0; y < height; ++y)
    for (unsigned x = 0; x < width; ++x) mesh.points.emplace_back(x + 0.5 * y, 0.866 * y, 0);
  const auto vertex = [&](unsigned x, unsigned y) { return static_cast<VertexIndex>(y * width + x); };
  for (unsigned y = 0; y + 1 < height; ++y)
    for (unsigned x = 0; x + 1 < width; ++x) {
      // The triangles at the two sharp corners would hang on by one side.
      if (x + y > 0) mesh.triangles.push_back({vertex(x, y), vertex(x + 1, y), vertex(x, y + 1)});
      if (x + y + 4 < width + height)
        mesh.triangles.push_back({vertex(x + 1, y), vertex(x + 1, y + 1), vertex(x, y + 1)});
    }
  // Without their vertices, the first and the last.
  mesh.points.erase(mesh.points.begin());
  mesh.points.pop_back();
  for (Triangle& t : mesh.triangles)
    for (VertexIndex& v : t) --v;
  return mesh;
}

TrivalentNetwork lattice_network(unsigned width = 9, unsigned height = 9) {
  return trivalent_network(lattice(width, height));
}

// The lattice without the triangles of a vertex in its middle, so that there are two loops.
TrivalentNetwork annulus() {
  TriangleMesh mesh = lattice(12, 12);
  const VertexIndex middle = 6 * 12 + 6 - 1;
  std::erase_if(mesh.triangles,
                [&](const Triangle& t) { return t[0] == middle || t[1] == middle || t[2] == middle; });
  for (Triangle& t : mesh.triangles)
    for (VertexIndex& v : t) v -= v > middle;
  mesh.points.erase(mesh.points.begin() + middle);
  return trivalent_network(mesh);
}

struct Census {
  long euler = 0;
  std::size_t loops = 0;
};

// Checks every record, and counts.
void take_census(const TrivalentNetwork& network, Census& census) {
  std::vector<AtomIndex> cycle;
  std::map<RingIndex, RingIndex> next;  // around the boundary
  long rings = 0, bonds = 0, atoms = 0;
  for (RingIndex r = 0; r < network.rings.size(); ++r) {
    const TrivalentRing& ring = network.rings[r];
    if (ring.size == 0) continue;
    if (!ring.boundary) ++rings;
    atoms_of_ring(network, r, cycle);
    ASSERT_EQ(cycle.size(), ring.size) << "ring " << r;
    for (const AtomIndex a : cycle) ASSERT_LT(slot_of_ring(network.atoms[a], r), 3u);
    const TrivalentAtom& first = network.atoms[cycle.front()];
    const AtomIndex clockwise = first.neighbour[(slot_of_ring(first, r) + 2) % 3];
    ASSERT_EQ(clockwise == no_atom, ring.boundary);
    if (ring.boundary) next[r] = first.ring[(slot_of_ring(first, r) + 1) % 3];
  }
  std::set<std::pair<AtomIndex, AtomIndex>> seen;
  for (AtomIndex a = 0; a < network.atoms.size(); ++a) {
    const TrivalentAtom& atom = network.atoms[a];
    if (!atom.exists()) continue;
    ++atoms;
    int open = 0;
    for (unsigned s = 0; s < 3; ++s) {
      const RingIndex one = atom.ring[(s + 1) % 3], other = atom.ring[(s + 2) % 3];
      if (atom.neighbour[s] == no_atom) {
        ++open;
        ASSERT_TRUE(network.rings[one].boundary && network.rings[other].boundary);
        continue;
      }
      ASSERT_FALSE(network.rings[one].boundary && network.rings[other].boundary) << "a bridge at atom " << a;
      const TrivalentAtom& end = network.atoms[atom.neighbour[s]];
      const unsigned back = slot_of_neighbour(end, a);
      ASSERT_LT(back, 3u);
      ASSERT_EQ(one, end.ring[(back + 2) % 3]);
      ASSERT_EQ(other, end.ring[(back + 1) % 3]);
      ASSERT_TRUE(seen.insert({a, atom.neighbour[s]}).second) << "two bonds between the same atoms";
      bonds += atom.neighbour[s] > a ? 1 : 0;
    }
    ASSERT_LE(open, 1) << "atom " << a << " has one neighbour";
  }
  census.euler = atoms - bonds + rings;
  census.loops = 0;
  std::set<RingIndex> passed;
  for (const auto& [start, unused] : next) {
    if (passed.contains(start)) continue;
    ++census.loops;
    for (RingIndex at = start; passed.insert(at).second;) at = next.at(at);
  }
}

TEST(BoundaryEdit, ClosingABayMakesAHexagonAndOpeningItLeavesTheBayAgain) {
  TrivalentNetwork network = lattice_network();
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  const std::size_t atoms = atom_count(network);
  const auto hexagons = ring_counts(network)[6];
  for (std::uint32_t size = 5; size <= 7; ++size)
    for (RingIndex r = 0; r < network.rings.size(); ++r) {
      const std::uint32_t chain = network.rings[r].size;
      if (!network.rings[r].boundary || chain != 3) continue;
      const auto closing = close_chain(network, r, size);
      ASSERT_TRUE(closing);
      EXPECT_EQ(closing->atoms_added(), static_cast<int>(size - chain));
      commit_edit(network, *closing, free_atoms, free_rings);
      Census census;
      take_census(network, census);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
      EXPECT_EQ(census.euler, 1);
      EXPECT_EQ(network.rings[r].size, size);
      const auto opening = open_ring(network, r);
      ASSERT_TRUE(opening);
      commit_edit(network, *opening, free_atoms, free_rings);
      take_census(network, census);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
      EXPECT_EQ(census.euler, 1);
      EXPECT_EQ(network.rings[r].size, chain);
    }
  EXPECT_EQ(atom_count(network), atoms);
  EXPECT_EQ(ring_counts(network)[6], hexagons);
}

TEST(BoundaryEdit, AnAtomInsertedAndRemovedLeavesTheCountsAsTheyWere) {
  TrivalentNetwork network = lattice_network();
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  const auto before = ring_counts(network);
  const std::size_t atoms = network.atoms.size();
  int made = 0;
  for (AtomIndex a = 0; a < atoms; ++a)
    for (unsigned s = 0; s < 3; ++s) {
      const auto insertion = insert_open_atom(network, a, s);
      const TrivalentAtom& record = network.atoms[a];
      const bool at_boundary =
          record.neighbour[s] != no_atom && network.rings[record.ring[(s + 1) % 3]].boundary !=
                                                network.rings[record.ring[(s + 2) % 3]].boundary;
      ASSERT_EQ(insertion.has_value(), at_boundary);
      if (!insertion) continue;
      const CommittedEdit added = commit_edit(network, *insertion, free_atoms, free_rings);
      Census census;
      take_census(network, census);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
      EXPECT_EQ(census.euler, 1);
      EXPECT_NE(ring_counts(network), before);
      const auto removal = remove_open_atom(network, added.atoms[0]);
      ASSERT_TRUE(removal);
      commit_edit(network, *removal, free_atoms, free_rings);
      take_census(network, census);
      ASSERT_FALSE(testing::Test::HasFatalFailure());
      EXPECT_EQ(census.euler, 1);
      ++made;
    }
  EXPECT_GT(made, 60);
  EXPECT_EQ(ring_counts(network), before);
}

TEST(BoundaryEdit, RandomEditsKeepTheSurfaceAndItsLoops) {
  for (const bool hole : {false, true}) {
    TrivalentNetwork network = hole ? annulus() : lattice_network(12, 12);
    Census start;
    take_census(network, start);
    EXPECT_EQ(start.euler, hole ? 0 : 1);
    EXPECT_EQ(start.loops, hole ? 2u : 1u);
    std::vector<AtomIndex> free_atoms;
    std::vector<RingIndex> free_rings;
    RandomStream random(7, hole);
    std::map<NetworkEdit::Kind, int> made;
    for (int trial = 0; trial < 20000; ++trial) {
      const auto atom = static_cast<AtomIndex>(random.below(network.atoms.size()));
      if (!network.atoms[atom].exists()) continue;
      const auto slot = static_cast<unsigned>(random.below(3));
      const RingIndex ring = network.atoms[atom].ring[slot];
      std::optional<NetworkEdit> edit;
      switch (random.below(7)) {
        case 0:
          edit = flip_bond(network, atom, slot);
          break;
        case 1:
          edit = collapse_bond(network, atom, slot);
          break;
        case 2:
          edit =
              split_ring(network, ring, static_cast<unsigned>(random.below(6)),
                         static_cast<unsigned>(1 + random.below(std::max(network.rings[ring].size, 2u) - 1)));
          break;
        case 3:
          edit = insert_open_atom(network, atom, slot);
          break;
        case 4:
          edit = remove_open_atom(network, atom);
          break;
        case 5:
          edit = close_chain(network, ring, static_cast<std::uint32_t>(5 + random.below(3)));
          break;
        default:
          edit = open_ring(network, ring);
          break;
      }
      if (!edit) continue;
      bool small = false;  // below 4 the triangulation is no longer simple
      for (const auto& [r, change] : edit->rings) {
        const bool chain = is_added_ring(r)
                               ? edit->new_rings_open
                               : (network.rings[r].boundary && r != edit->closed) || r == edit->opened;
        const int after = change + (is_added_ring(r) ? 0 : static_cast<int>(network.rings[r].size));
        small |= after != 0 && (after > 9 || after < (chain ? 2 : 4));
      }
      if (small) continue;
      commit_edit(network, *edit, free_atoms, free_rings);
      ++made[edit->kind];
      if (trial % 20 != 0) continue;
      Census census;
      take_census(network, census);
      if (testing::Test::HasFatalFailure()) return;
      ASSERT_EQ(census.euler, start.euler);
      ASSERT_EQ(census.loops, start.loops);
    }
    EXPECT_EQ(made.size(), 7u);
    for (const auto& [kind, count] : made) EXPECT_GT(count, 30) << static_cast<int>(kind);
    compact(network);
    Census census;
    take_census(network, census);
    EXPECT_EQ(census.euler, start.euler);
  }
}

// A hole of so few vertices is not closed by one atom more, which would fill it.
TEST(BoundaryEdit, NoLoopIsFilled) {
  TrivalentNetwork network = annulus();
  std::vector<AtomIndex> free_atoms;
  std::vector<RingIndex> free_rings;
  RandomStream random(3, 0);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto ring = static_cast<RingIndex>(random.below(network.rings.size()));
    const std::uint32_t chain = network.rings[ring].size;
    if (chain == 0 || !network.rings[ring].boundary) continue;
    const auto edit = close_chain(network, ring, chain + 1);
    if (!edit || chain > 8) continue;
    commit_edit(network, *edit, free_atoms, free_rings);
    Census census;
    take_census(network, census);
    if (testing::Test::HasFatalFailure()) return;
    ASSERT_EQ(census.loops, 2u);
  }
}

}  // namespace
}  // namespace nanocarbon::annealing
