// SPDX-License-Identifier: GPL-2.0-or-later
// Ring statistics of known crystals and cages, and of random networks as their definitions give them.
#include <gmock/gmock.h>

#include <map>
#include <queue>
#include <set>

#include "bonded.h"
#include "nanocarbon/analysis/king_rings.h"
#include "nanocarbon/analysis/primitive_rings.h"
#include "nanocarbon/core/random_stream.h"
#include "nanocarbon/structures/diamond.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/schwarzite.h"

namespace nanocarbon::analysis {
namespace {

using Counts = std::map<std::size_t, std::uint64_t>;
using testing::AllOf;
using testing::ElementsAre;
using testing::Pair;

Counts counts(const RingStatistics& statistics) {
  Counts result;
  for (std::size_t size = 0; size < statistics.counts.size(); ++size)
    if (statistics.counts[size] > 0) result[size] = statistics.counts[size];
  return result;
}

BondRows rows(const Molecule& molecule) { return bond_rows(test::bonded(molecule)); }

// The definitions, word by word, on a small network without a cell: all cycles, and distances of all pairs.
class ByDefinition {
 public:
  ByDefinition(const BondRows& network, std::size_t max_ring) : network_(network), max_ring_(max_ring) {
    for (AtomIndex a = 0; a < network.atoms(); ++a) distance_.push_back(distances_from(a, none));
    std::vector<AtomIndex> path;
    for (AtomIndex a = 0; a < network.atoms(); ++a) {
      path = {a};
      extend(path);
    }
  }
  Counts primitive, king;

 private:
  static constexpr AtomIndex none = 0xffffffff;

  std::vector<std::size_t> distances_from(AtomIndex from, AtomIndex avoided) const {
    std::vector<std::size_t> distance(network_.atoms(), 1000);
    distance[from] = 0;
    std::queue<AtomIndex> next;
    next.push(from);
    while (!next.empty()) {
      const AtomIndex a = next.front();
      next.pop();
      for (const BondRowEnd& end : network_.of(a))
        if (end.atom != avoided && distance[end.atom] == 1000) {
          distance[end.atom] = distance[a] + 1;
          next.push(end.atom);
        }
    }
    return distance;
  }

  // Cycles whose lowest atom is the first, each in one of its two directions.
  void extend(std::vector<AtomIndex>& path) {
    for (const BondRowEnd& end : network_.of(path.back())) {
      if (end.atom == path.front() && path.size() >= 3 && path[1] < path.back()) judge(path);
      if (end.atom <= path.front() || path.size() == max_ring_) continue;
      if (std::find(path.begin(), path.end(), end.atom) != path.end()) continue;
      path.push_back(end.atom);
      extend(path);
      path.pop_back();
    }
  }

  void judge(const std::vector<AtomIndex>& ring) {
    const std::size_t n = ring.size();
    bool is_primitive = true, is_king = false;
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j)
        is_primitive = is_primitive && distance_[ring[i]][ring[j]] == std::min(j - i, n - j + i);
      is_king = is_king || distances_from(ring[(i + 1) % n], ring[i])[ring[(i + n - 1) % n]] == n - 2;
    }
    if (is_primitive) ++primitive[n];
    if (is_king) ++king[n];
  }

  const BondRows& network_;
  std::size_t max_ring_;
  std::vector<std::vector<std::size_t>> distance_;
};

Molecule random_network(std::size_t atoms, std::size_t most_bonds, std::uint64_t seed) {
  RandomStream random(seed, 0);
  Molecule network;
  network.positions.assign(atoms, Vec3::Zero());
  network.elements.assign(atoms, Element::carbon);
  std::vector<std::size_t> degree(atoms, 0);
  std::set<Bond> bonds;
  for (int trial = 0; trial < 2000; ++trial) {
    auto a = static_cast<AtomIndex>(random.below(atoms)), b = static_cast<AtomIndex>(random.below(atoms));
    if (a == b || degree[a] == most_bonds || degree[b] == most_bonds) continue;
    if (a > b) std::swap(a, b);
    if (bonds.insert({a, b}).second) ++degree[a], ++degree[b];
  }
  network.bonds.assign(bonds.begin(), bonds.end());
  return network;
}

TEST(RingSearch, RandomNetworksHaveTheRingsOfTheDefinitions) {
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const Molecule network = random_network(24 + seed, seed % 2 ? 3 : 4, seed);
    const BondRows all = bond_rows(network);
    const ByDefinition expected(all, 9);
    EXPECT_EQ(counts(king_rings(all, {.max_ring = 9})), expected.king) << "seed " << seed;
    EXPECT_EQ(counts(primitive_rings(all, {.max_ring = 9})), expected.primitive) << "seed " << seed;
  }
}

TEST(RingSearch, GrapheneHasHalfAHexagonAnAtomInCellsOfAnySize) {
  for (const auto& [x, y] : {std::pair{1, 1}, {2, 1}, {4, 3}, {6, 7}}) {
    const Molecule sheet = structures::graphene(x, y);
    EXPECT_THAT(counts(king_rings(rows(sheet))), ElementsAre(Pair(6, sheet.size() / 2))) << x << " x " << y;
    EXPECT_THAT(counts(primitive_rings(rows(sheet))), ElementsAre(Pair(6, sheet.size() / 2)))
        << x << " x " << y;
  }
}

// Each atom of diamond is on twelve hexagons: two an atom.
TEST(RingSearch, DiamondHasTwoHexagonsAnAtomInCellsOfAnySize) {
  for (const int cells : {1, 2, 3}) {
    const Molecule crystal = structures::diamond(cells, cells, cells);
    EXPECT_THAT(counts(king_rings(rows(crystal))), ElementsAre(Pair(6, 2 * crystal.size()))) << cells;
  }
}

TEST(RingSearch, APrimitiveCellOfDiamondWithTwoAtomsHasFourHexagons) {
  Molecule cell;
  const double a = 3.567;
  cell.positions = {Vec3::Zero(), Vec3::Constant(a / 4)};
  cell.elements.assign(2, Element::carbon);
  Mat3 vectors;
  vectors << 0, a / 2, a / 2, a / 2, 0, a / 2, a / 2, a / 2, 0;
  if (vectors.determinant() < 0) vectors.col(0).swap(vectors.col(1));
  cell.cell = Cell{vectors, Vec3::Zero(), {true, true, true}};
  const BondRows two = rows(cell);
  ASSERT_EQ(two.degree(0), 4u);
  EXPECT_THAT(counts(king_rings(two)), ElementsAre(Pair(6, 4)));
  const auto large = counts(primitive_rings(rows(structures::diamond(3, 3, 3))));
  const auto small = counts(primitive_rings(two));
  for (const auto& [size, count] : large) EXPECT_EQ(small.at(size) * 27 * 4, count) << size;
}

// The ten rings of 18 go around the waist (each five-fold and three-fold pair of poles has its own).
TEST(RingSearch, C60HasTwelvePentagonsTwentyHexagonsAndTenWaists) {
  const BondRows cage = rows(structures::fullerene(1, 1));
  EXPECT_THAT(counts(king_rings(cage)), ElementsAre(Pair(5, 12), Pair(6, 20)));
  EXPECT_THAT(counts(primitive_rings(cage, {.max_ring = 20})),
              ElementsAre(Pair(5, 12), Pair(6, 20), Pair(18, 10)));
}

TEST(RingSearch, RingsAreCyclesOfBondedAtomsAndDoNotDependOnThreads) {
  const Molecule p688 = test::bonded(structures::schwarzite_p688(2, 1, 1));
  const BondRows network = bond_rows(p688);
  const RingStatistics one = king_rings(network), three = king_rings(network, {.threads = 3});
  EXPECT_EQ(one.rings.atoms, three.rings.atoms);
  EXPECT_EQ(one.rings.offsets, three.rings.offsets);
  for (std::size_t r = 0; r < one.rings.size(); ++r) {
    const auto ring = one.rings[r];
    EXPECT_EQ(*std::min_element(ring.begin(), ring.end()), ring[0]);
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const auto ends = network.of(ring[k]);
      EXPECT_TRUE(std::any_of(ends.begin(), ends.end(), [&](const BondRowEnd& end) {
        return end.atom == ring[(k + 1) % ring.size()];
      }));
    }
  }
}

TEST(RingSearch, FacesOfASurfaceAreItsKingsRings) {
  const Molecule crystal = test::bonded(structures::schwarzite_d688(2, 2, 2));
  const Analysis faces = test::analysed(crystal);
  ASSERT_TRUE(faces.components.all_surfaces());
  const Counts found = counts(king_rings(faces.rows));
  for (const std::size_t size : {6u, 8u}) EXPECT_EQ(found.at(size), faces.components.ring_counts[size]);
}

TEST(RingSearch, CrowdedAtomsAreSaidNotSearched) {
  Molecule heap;
  for (int i = 0; i < 30; ++i) heap.positions.push_back(Vec3(0.05 * i, 0.0, 0.0));
  heap.elements.assign(30, Element::carbon);
  const Analysis analysis = test::analysed(test::bonded(heap));
  EXPECT_THAT(analysis.components.rings_not_counted, testing::HasSubstr("atom ID 1 has 29 bonds"));
  EXPECT_EQ(analysis.components.list[0].rings, RingKind::none);
}

}  // namespace
}  // namespace nanocarbon::analysis
