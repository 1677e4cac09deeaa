// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/topology/surface_topology.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "molecule/cases.h"
#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/molecule/molecule_graph.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/hydrocarbons.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::topology {
namespace {

using test::topology;
using testing::ElementsAre;
using testing::HasSubstr;

// The atom nearest to the origin, where flakes have their middle.
AtomIndex middle_atom(const Molecule& molecule) {
  const auto nearer = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); };
  const auto found = std::min_element(molecule.positions.begin(), molecule.positions.end(), nearer);
  return static_cast<AtomIndex>(found - molecule.positions.begin());
}

TEST(SurfaceTopology, FullerenesHaveTwelvePentagons) {
  for (const int k : {0, 1, 2, 5}) {
    const Molecule molecule = structures::fullerene(5, k);
    const SurfaceTopology s = topology(molecule);
    EXPECT_EQ(s.ring_counts[5], 12u);
    EXPECT_EQ(s.ring_counts[6], molecule.size() / 2 - 10);  // Euler
    EXPECT_EQ(s.rings.size(), s.ring_counts[5] + s.ring_counts[6]);
    EXPECT_THAT(s.coordination, testing::Each(3));
  }
}

TEST(SurfaceTopology, RingsAreThoseOfTheDualAndRunTheSameWayRound) {
  const Molecule molecule =
      molecule::dual(test::scaled_to_carbon(test::sqrt3_subdivided_sphere(test::icosahedron())));
  const auto sorted = [](const Rings& rings) {
    std::vector<std::vector<AtomIndex>> list;
    for (std::size_t r = 0; r < rings.size(); ++r) list.emplace_back(rings[r].begin(), rings[r].end());
    std::sort(list.begin(), list.end());
    return list;
  };
  EXPECT_EQ(sorted(topology(molecule).rings), sorted(molecule.rings));
}

TEST(SurfaceTopology, TheSmallestCellsOfGrapheneAreTori) {
  Molecule primitive;
  primitive.positions = {Vec3(0, 0, 0), Vec3(0, 1.42, 0)};
  primitive.elements.assign(2, Element::carbon);
  primitive.cell = Cell{};
  primitive.cell->vectors << 1.42 * std::sqrt(3.0), 1.42 * std::sqrt(0.75), 0, 0, 2.13, 0, 0, 0, 20;
  primitive = test::with_bonds_by_distance(primitive);
  ASSERT_EQ(primitive.bonds.size(), 3u);
  const SurfaceTopology s = topology(primitive);
  ASSERT_FALSE(s.problem) << s.problem->reason;
  EXPECT_EQ(s.euler_characteristic, 0);
  EXPECT_EQ(s.genus, 1);
  EXPECT_EQ(s.ring_counts[6], 1u);  // each atom of the cell stands in it three times
  EXPECT_EQ(topology(structures::graphene(1, 1)).ring_counts[6], 2u);
}

TEST(SurfaceTopology, AnAtomMayBeBondedToItsOwnImage) {
  // A (1,0) "tube" has bonds from an atom to its own image around; here the graph is what counts, so a strip
  // does: atoms in a ladder one period long, every rung closed through the boundary.
  Molecule ladder;
  ladder.positions = {Vec3(0, 0, 0), Vec3(0, 1.4, 0)};
  ladder.elements.assign(2, Element::carbon);
  ladder.cell = orthogonal_cell(Vec3(1.4, 20, 20), {true, false, false});
  ladder.bonds = {{0, 0, {1, 0, 0}}, {0, 1, {0, 0, 0}}, {1, 1, {1, 0, 0}}};
  const SurfaceTopology s = topology(ladder);
  ASSERT_FALSE(s.problem) << s.problem->reason;
  // One square that meets itself, and a rim on each side, each a single straight bond: an annulus.
  EXPECT_EQ(s.ring_counts[4], 1u);
  EXPECT_EQ(s.boundary_loops, 2);
  EXPECT_EQ(s.euler_characteristic, 0);
}

TEST(SurfaceTopology, LongRingsAreHolesFromTheSizeAskedForOn) {
  const Molecule vacancy = test::without_atom(structures::graphene(6, 4), 20);  // leaves a ring of 12
  const SurfaceTopology as_ring = topology(vacancy, 12), as_hole = topology(vacancy, 11);
  EXPECT_EQ(as_ring.ring_counts[12], 1u);
  EXPECT_EQ(as_ring.boundary_loops, 0);
  EXPECT_EQ(as_ring.euler_characteristic, 0);
  EXPECT_EQ(as_hole.boundary_loops, 1);
  EXPECT_EQ(as_hole.euler_characteristic, -1);
}

TEST(SurfaceTopology, ShortRimsAreNoRings) {
  // Benzene, a disc, has a rim of 6 bonds; a (4,0) tube's ends have 8; both are shorter than the longest
  // ring.
  const SurfaceTopology disc = topology(structures::benzene());
  EXPECT_EQ(disc.ring_counts[6], 1u);
  EXPECT_EQ(disc.boundary_loops, 1);
  EXPECT_EQ(disc.euler_characteristic, 1);
  const Molecule tube = structures::open_tube(4, 0, 12.0);
  for (const double deviation : {0.0, 0.05, 0.1}) {
    const SurfaceTopology s = topology(test::rattled(tube, deviation, 3));
    EXPECT_EQ(s.boundary_loops, 2);
    EXPECT_EQ(s.ring_counts[8], 0u);
    EXPECT_EQ(s.euler_characteristic, 0);
  }
}

TEST(SurfaceTopology, FragmentsAreDiscsWithoutRings) {
  Molecule molecule;
  for (int i = 0; i < 5; ++i) molecule.positions.emplace_back(1.3 * i, 0, 0);
  molecule.positions.emplace_back(0, 9, 0);
  molecule.elements.assign(6, Element::carbon);
  const SurfaceTopology s = topology(test::with_bonds_by_distance(molecule));
  ASSERT_FALSE(s.problem);
  EXPECT_THAT(s.components,
              ElementsAre(ComponentTopology{false, true, 0, 1}, ComponentTopology{false, true, 0, 1}));
  EXPECT_EQ(s.rings.size(), 0u);
  EXPECT_THAT(s.coordination, ElementsAre(1, 2, 2, 2, 1, 0));
  EXPECT_TRUE(topology({}).components.empty());
}

TEST(SurfaceTopology, ALongBareCycleIsABand) {
  Molecule ring;  // C18, cyclo[18]carbon
  for (int i = 0; i < 18; ++i) {
    const double angle = 2.0 * std::acos(-1.0) * i / 18, radius = 0.65 / std::sin(std::acos(-1.0) / 18);
    ring.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  }
  ring.elements.assign(18, Element::carbon);
  const SurfaceTopology s = topology(test::with_bonds_by_distance(ring));
  ASSERT_FALSE(s.problem);
  EXPECT_THAT(s.components, ElementsAre(ComponentTopology{false, true, 0, 2}));
  EXPECT_EQ(s.euler_characteristic, 0);
}

TEST(SurfaceTopology, HydrogenAndHangingChainsChangeNothing) {
  const Molecule flake = structures::graphene_flake(8.0);
  const SurfaceTopology bare = topology(flake);
  const auto edge_atom = static_cast<AtomIndex>(
      std::find(bare.coordination.begin(), bare.coordination.end(), 2) - bare.coordination.begin());
  const Vec3 outward = flake.positions[edge_atom].normalized();
  Molecule decorated = flake;
  for (const double distance : {1.4, 2.7, 4.0}) {
    decorated.positions.push_back(flake.positions[edge_atom] + distance * outward);
    decorated.elements.push_back(Element::carbon);
  }
  // A hydrogen on an inner atom makes it sp3, but the sheet is still a sheet.
  decorated.positions.push_back(flake.positions[middle_atom(flake)] + Vec3(0, 0, 1.1));
  decorated.elements.push_back(Element::hydrogen);
  decorated = test::with_bonds_by_distance(decorated);
  ASSERT_EQ(decorated.bonds.size(), flake.bonds.size() + 4);
  const SurfaceTopology s = topology(decorated);
  ASSERT_FALSE(s.problem) << s.problem->reason;
  EXPECT_EQ(s.components, bare.components);
  EXPECT_EQ(s.ring_counts, bare.ring_counts);
  EXPECT_EQ(s.coordination[edge_atom], 3);
  EXPECT_EQ(s.smallest_ring.back(), 0);
}

TEST(SurfaceTopology, FourCarbonNeighboursAreNoSurface) {
  Molecule molecule = structures::graphene_flake(8.0);
  const AtomIndex middle = middle_atom(molecule);
  molecule.positions.push_back(molecule.positions[middle] + Vec3(0, 0, 1.5));
  molecule.elements.push_back(Element::carbon);
  const SurfaceTopology s = topology(test::with_bonds_by_distance(molecule));
  ASSERT_TRUE(s.problem);
  EXPECT_EQ(s.problem->atom, middle);
  EXPECT_EQ(s.problem->reason, "atom ID " + std::to_string(middle + 1) + " is bonded to 4 carbon atoms");
}

// Cycloparaphenylene: a necklace of twelve benzene rings linked by single bonds, each ring turned about the
// necklace by its angle (radians).
Molecule necklace(const std::function<double(int)>& angle) {
  const int rings = 12;
  const double circumference = rings * (2.0 * 1.42 + 1.48), pi = std::acos(-1.0);
  Molecule molecule;
  for (int k = 0; k < rings; ++k) {
    const double at = 2.0 * pi * k / rings;
    const Vec3 radial(std::cos(at), std::sin(at), 0), along(-std::sin(at), std::cos(at), 0);
    const Vec3 across = std::cos(angle(k)) * Vec3(0, 0, 1) + std::sin(angle(k)) * radial;
    for (int c = 0; c < 6; ++c)
      molecule.positions.push_back(circumference / (2.0 * pi) * radial +
                                   1.42 * (std::cos(c * pi / 3.0) * along + std::sin(c * pi / 3.0) * across));
  }
  molecule.elements.assign(molecule.positions.size(), Element::carbon);
  return test::with_bonds_by_distance(molecule);
}

TEST(SurfaceTopology, ANecklaceIsABandOrAMoebiusBandByItsTwist) {
  const double pi = std::acos(-1.0);
  const SurfaceTopology flat = topology(necklace([](int) { return 0.0; }));
  const SurfaceTopology moebius = topology(necklace([&](int k) { return k * pi / 12; }));
  ASSERT_FALSE(flat.problem || moebius.problem);
  EXPECT_THAT(flat.components, ElementsAre(ComponentTopology{true, true, 0, 2}));
  EXPECT_THAT(moebius.components, ElementsAre(ComponentTopology{true, false, 1, 1}));
  EXPECT_EQ(moebius.ring_counts[6], 12u);
}

TEST(SurfaceTopology, ABondTwistedByARightAngleOnALongCycleIsNotGuessed) {
  const SurfaceTopology s = topology(necklace([](int k) { return k < 6 ? 0.0 : std::acos(0.0); }));
  ASSERT_TRUE(s.problem);
  EXPECT_THAT(s.problem->reason, HasSubstr("twisted by a right angle"));
}

TEST(SurfaceTopology, AnAtomPushedPastItsNeighbourIsNotGuessed) {
  // With their bonds kept, the others stand around both the wrong way round.
  Molecule sheet = structures::graphene(6, 4);
  const Bond bond = sheet.bonds[30];
  const Vec3 along =
      sheet.positions[bond.second] + image_shift(*sheet.cell, bond.image) - sheet.positions[bond.first];
  sheet.positions[bond.first] += 0.7 * along;
  ASSERT_FALSE(topology(sheet).problem);
  sheet.positions[bond.first] += 0.5 * along;
  const SurfaceTopology s = topology(sheet);
  ASSERT_TRUE(s.problem);
  EXPECT_THAT(s.problem->reason, HasSubstr("comes back on its other side"));
}

TEST(SurfaceTopology, RingsLinkedBySingleBondsAreDiscs) {
  // Biphenyl's, and three rings around one atom: the rim goes along the links both ways, as it must.
  for (const int rings : {2, 3}) {
    Molecule molecule;
    molecule.positions.emplace_back(0, 0, 0);
    for (int k = 0; k < rings; ++k) {
      const double at = 2.0 * std::acos(-1.0) * k / rings;
      const Vec3 out(std::cos(at), std::sin(at), 0), across(-std::sin(at), std::cos(at), 0);
      for (int c = 0; c < 6; ++c)
        molecule.positions.push_back((1.48 + 1.42) * out - 1.42 * std::cos(c * std::acos(0.5)) * out +
                                     1.42 * std::sin(c * std::acos(0.5)) *
                                         (rings == 3 ? Vec3(0, 0, 1) : across));
    }
    molecule.elements.assign(molecule.size(), Element::carbon);
    const SurfaceTopology s = topology(test::with_bonds_by_distance(molecule));
    ASSERT_FALSE(s.problem) << s.problem->reason;
    EXPECT_THAT(s.components, ElementsAre(ComponentTopology{true, true, 0, 1}));
    EXPECT_EQ(s.ring_counts[6], static_cast<std::uint32_t>(rings));
  }
}

TEST(SurfaceTopology, AChainBetweenTwoHolesHasNoSides) {
  // Through the middle of an open tube, from one end to the other.
  Molecule tube = structures::open_tube(8, 0, 14.0);
  const auto [bottom, top] = std::minmax_element(tube.positions.begin(), tube.positions.end(),
                                                 [](const Vec3& a, const Vec3& b) { return a[2] < b[2]; });
  const auto first = static_cast<AtomIndex>(bottom - tube.positions.begin());
  const auto last = static_cast<AtomIndex>(top - tube.positions.begin());
  const Vec3 from = tube.positions[first], to = tube.positions[last];
  const auto atoms = static_cast<AtomIndex>(tube.size());
  constexpr AtomIndex links = 12;
  for (AtomIndex k = 0; k < links; ++k) {
    const double way = (k + 1.0) / (links + 1.0);
    tube.positions.push_back(from + way * (to - from) - 4.0 * way * (1.0 - way) * Vec3(from[0], from[1], 0));
    tube.elements.push_back(Element::carbon);
    if (k > 0) tube.bonds.push_back({atoms + k - 1, atoms + k, {0, 0, 0}});
  }
  tube.bonds.push_back({first, atoms, {0, 0, 0}});
  tube.bonds.push_back({last, atoms + links - 1, {0, 0, 0}});
  std::sort(tube.bonds.begin(), tube.bonds.end());
  const SurfaceTopology s = topology(tube);
  ASSERT_TRUE(s.problem);
  EXPECT_THAT(s.problem->reason, HasSubstr("comes back on its other side"));
}

TEST(SurfaceTopology, GatheredBondEndsGiveTheSameInAnyOrder) {
  const Molecule molecule = test::rattled(structures::graphene(3, 2), 0.05, 7);
  const EmbeddedGraph graph = molecule::embedded_graph(molecule);
  std::vector<std::int64_t> ids(molecule.size());
  for (std::size_t i = 0; i < ids.size(); ++i) ids[i] = 10 + 3 * static_cast<std::int64_t>(i);
  std::vector<BondEnd> ends;
  for (AtomIndex a = 0; a < graph.atoms(); ++a)
    for (std::uint32_t h = graph.offsets[a]; h < graph.offsets[a + 1]; ++h)
      ends.push_back({ids[a], ids[graph.ends[h]], graph.vectors[h]});
  std::mt19937_64 random(3);
  for (int round = 0; round < 3; ++round) {
    std::shuffle(ends.begin(), ends.end(), random);
    const SurfaceTopology s = surface_topology(embedded_graph(ids, molecule.elements, ends));
    ASSERT_FALSE(s.problem);
    EXPECT_EQ(s.components, topology(molecule).components);
    EXPECT_EQ(s.ring_counts[6], molecule.size() / 2);
  }
  ends.pop_back();
  const SurfaceTopology s = surface_topology(embedded_graph(ids, molecule.elements, ends));
  ASSERT_TRUE(s.problem);
  EXPECT_THAT(s.problem->reason, HasSubstr("is known to only one of them"));
}

}  // namespace
}  // namespace nanocarbon::topology
