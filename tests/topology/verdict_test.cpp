// SPDX-License-Identifier: GPL-2.0-or-later
// What happens to molecules, and what the tracking says of it.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "molecule/cases.h"
#include "molecule/shapes.h"
#include "nanocarbon/molecule/dual.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::topology {
namespace {

using test::topology;
using testing::HasSubstr;

struct Outcome {
  Verdict verdict;
  std::string reason;
  std::vector<AtomIndex> repelled;
  std::size_t broken, formed;
  SurfaceTopology now;
};

Outcome compare(const Molecule& start, const Molecule& now) {
  const BondChanges changes = compare_bonds(bonded_ids(start.bonds), bonded_ids(now.bonds));
  const SurfaceTopology before = topology(start), after = topology(now);
  const Judgement judgement = judge(before, after, changes.none());
  Outcome outcome{judgement.verdict,     judgement.reason,      {},
                  changes.broken.size(), changes.formed.size(), after};
  const std::vector<bool> repelled = repelled_atoms(before.component_of_atom, after.component_of_atom);
  for (AtomIndex a = 0; a < repelled.size(); ++a)
    if (repelled[a]) outcome.repelled.push_back(a);
  return outcome;
}

TEST(Verdict, AMoleculeThatMovesAboutIsIntact) {
  const std::vector<Molecule> molecules = {structures::fullerene(1, 1), structures::open_tube(10, 10, 20.0),
                                           structures::graphene(6, 4)};
  for (const Molecule& start : molecules) {
    const Outcome outcome = compare(start, test::with_updated_bonds(test::rattled(start, 0.05, 9)));
    EXPECT_EQ(outcome.verdict, Verdict::intact);
    EXPECT_TRUE(outcome.repelled.empty());
    EXPECT_TRUE(outcome.reason.empty());
  }
}

TEST(Verdict, AStoneWalesRotationIsHomeomorphic) {
  for (const Molecule& start : {structures::fullerene(3, 3), structures::graphene(6, 4)}) {
    const Bond bond = start.bonds[start.bonds.size() / 2];
    ASSERT_EQ(bond.image, (std::array<std::int32_t, 3>{0, 0, 0}));
    const Outcome outcome = compare(start, test::stone_wales(start, bond.first, bond.second));
    EXPECT_EQ(outcome.verdict, Verdict::homeomorphic) << outcome.reason;
    EXPECT_EQ(outcome.broken, 2u);
    EXPECT_EQ(outcome.formed, 2u);
    EXPECT_EQ(outcome.now.ring_counts[7], 2u);
    EXPECT_TRUE(outcome.repelled.empty());
  }
}

TEST(Verdict, APulledOffAtomIsRepelled) {
  const Molecule start = structures::fullerene(1, 1);
  Molecule now = start;
  now.positions[17] *= 2.5;
  const Outcome outcome = compare(start, test::with_updated_bonds(now));
  EXPECT_EQ(outcome.verdict, Verdict::broken);
  EXPECT_THAT(outcome.reason, HasSubstr("2 pieces instead of 1"));
  EXPECT_THAT(outcome.repelled, testing::ElementsAre(17));
  EXPECT_EQ(outcome.broken, 3u);
  EXPECT_EQ(outcome.formed, 0u);
}

TEST(Verdict, OfACutTubeTheSmallerPartIsRepelled) {
  const Molecule start = structures::open_tube(10, 10, 30.0);
  Molecule now = start;
  std::vector<AtomIndex> beyond;
  for (AtomIndex a = 0; a < now.size(); ++a)
    if (now.positions[a][2] > 6.0) {
      beyond.push_back(a);
      now.positions[a][2] += 5.0;
    }
  ASSERT_LT(beyond.size(), start.size() / 2);
  const Outcome outcome = compare(start, test::with_updated_bonds(now));
  EXPECT_EQ(outcome.verdict, Verdict::broken);
  EXPECT_EQ(outcome.now.components.size(), 2u);
  EXPECT_EQ(outcome.now.boundary_loops, 4);
  EXPECT_EQ(outcome.repelled, beyond);
}

TEST(Verdict, AHoleTornOpenIsBrokenThoughNoAtomIsLost) {
  const Molecule start = structures::graphene_flake(15.0);
  Molecule now = start;
  now.bonds.clear();
  for (const Bond& bond : start.bonds) {  // a slit: the bonds across the positive x axis
    const Vec3 &a = start.positions[bond.first], &b = start.positions[bond.second];
    const bool across = a[1] * b[1] < 0.0 && std::abs(a[0] + b[0]) < 12.0;
    if (!across) now.bonds.push_back(bond);
  }
  const Outcome outcome = compare(start, now);
  EXPECT_EQ(outcome.verdict, Verdict::broken);
  EXPECT_EQ(outcome.now.components.size(), 1u);
  EXPECT_EQ(outcome.now.boundary_loops, 2);
  EXPECT_TRUE(outcome.repelled.empty());
  EXPECT_EQ(
      outcome.reason,
      "a piece was orientable, genus 0, 1 boundary loop; now one is orientable, genus 0, 2 boundary loops");
}

TEST(Verdict, TwoShellsFusedAreNoSurface) {
  const Molecule shell = structures::fullerene(1, 1);
  double radius = 0.0;
  for (const Vec3& p : shell.positions) radius = std::max(radius, p[0]);
  const auto apart = [&](double gap) {
    Molecule other = shell;
    for (Vec3& p : other.positions) p = Vec3(2.0 * radius + gap - p[0], p[1], p[2]);
    return test::together(shell, other);
  };
  const Molecule start = test::with_bonds_by_distance(apart(3.0));
  const Molecule now = test::with_updated_bonds(apart(1.5));
  ASSERT_EQ(topology(start).components.size(), 2u);
  const Outcome outcome = compare(start, now);
  EXPECT_EQ(outcome.verdict, Verdict::not_a_surface);
  EXPECT_THAT(outcome.reason, HasSubstr("is bonded to 4 carbon atoms"));
  EXPECT_TRUE(outcome.repelled.empty());  // the components are one, and both shells are in it
}

TEST(Verdict, TwoClosedShellsThatBecomeOneAreBroken) {
  const Molecule shell = structures::fullerene(1, 1);
  const Judgement judgement =
      judge(topology(test::together(shell, shell)), topology(structures::fullerene(3, 3)), false);
  EXPECT_EQ(judgement.verdict, Verdict::broken);
  EXPECT_EQ(judgement.reason, "1 piece instead of 2");
}

TEST(Verdict, ACrosslinkIsNoSurface) {
  const Molecule flake = structures::graphene_flake(9.0);
  Molecule other = flake;
  for (Vec3& p : other.positions) p[2] += 3.3;
  const Molecule start = test::together(flake, other);
  const auto nearer = [](const Vec3& a, const Vec3& b) { return a.squaredNorm() < b.squaredNorm(); };
  const auto middle =
      std::min_element(flake.positions.begin(), flake.positions.end(), nearer) - flake.positions.begin();
  Molecule now = start;
  now.positions[static_cast<std::size_t>(middle)][2] += 0.85;
  now.positions[static_cast<std::size_t>(middle) + flake.size()][2] -= 0.85;
  const Outcome outcome = compare(start, test::with_updated_bonds(now));
  EXPECT_EQ(outcome.verdict, Verdict::not_a_surface);
  EXPECT_EQ(outcome.formed, 1u);
  EXPECT_EQ(outcome.broken, 0u);
  EXPECT_EQ(outcome.now.coordination[static_cast<std::size_t>(middle)], 4);
}

TEST(Verdict, ALostAtomIsBroken) {
  const Molecule start = structures::graphene(6, 4);
  const SurfaceTopology before = topology(start), after = topology(test::without_atom(start, 20));
  EXPECT_EQ(before.components, after.components);  // a ring of 12 closes the hole, so only the count tells
  const Judgement judgement = judge(before, after, false, 1);
  EXPECT_EQ(judgement.verdict, Verdict::broken);
  EXPECT_EQ(judgement.reason, "1 atom was lost");
}

TEST(Verdict, ChangesThatMakeUpForEachOtherInTheSumsAreSeen) {
  // Components, Euler characteristic, genus and boundary loops add up to the same.
  const Molecule torus = molecule::dual(test::scaled_to_carbon(test::torus(24, 60, 3.0, 1.0)));
  const SurfaceTopology tori = topology(test::together(torus, torus));
  const SurfaceTopology others = topology(test::together(structures::fullerene(1, 1), test::handles(2)));
  EXPECT_EQ(tori.components.size(), others.components.size());
  EXPECT_EQ(tori.euler_characteristic, others.euler_characteristic);
  EXPECT_EQ(tori.genus, others.genus);
  EXPECT_EQ(tori.boundary_loops, others.boundary_loops);
  EXPECT_EQ(judge(tori, others, false).verdict, Verdict::broken);
}

TEST(Verdict, AMoebiusBandThatBecomesABandIsBroken) {
  const Judgement judgement = judge(topology(test::twisted_band(1)), topology(test::twisted_band(2)), false);
  EXPECT_EQ(judgement.verdict, Verdict::broken);
  EXPECT_THAT(judgement.reason, HasSubstr("not orientable"));
}

TEST(Verdict, ARingThatOpensIsBroken) {
  // A disc with a ring and a chain are both contractible.
  Molecule ring;
  for (int i = 0; i < 6; ++i)
    ring.positions.emplace_back(1.4 * std::cos(i * std::acos(0.5)), 1.4 * std::sin(i * std::acos(0.5)), 0.0);
  ring.elements.assign(6, Element::carbon);
  ring = test::with_bonds_by_distance(ring);
  Molecule chain = ring;
  chain.bonds.pop_back();
  EXPECT_EQ(topology(ring).euler_characteristic, topology(chain).euler_characteristic);
  EXPECT_EQ(compare(ring, chain).verdict, Verdict::broken);
}

TEST(Verdict, SameBondsAreIntactWhateverTheyAre) {
  EXPECT_EQ(judge(topology({}), topology({}), true).verdict, Verdict::intact);
}

}  // namespace
}  // namespace nanocarbon::topology
