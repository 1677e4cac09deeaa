// SPDX-License-Identifier: GPL-2.0-or-later
// Closed shells that grow together through a neck, and what the tracking says of it.
#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "molecule/cases.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/topology/surface_topology.h"

namespace nanocarbon::topology {
namespace {

using test::topology;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr double bond = 1.42;

// C60 about the origin with a hexagon flat on top, and so another at the bottom.
Molecule c60_on_a_hexagon() {
  Molecule molecule = structures::fullerene(1, 1);
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    if (molecule.rings[r].size() != 6) continue;
    Vec3 middle = Vec3::Zero();
    for (const AtomIndex a : molecule.rings[r]) middle += molecule.positions[a];
    const auto upright = Eigen::Quaterniond::FromTwoVectors(middle, Vec3::UnitZ());
    for (Vec3& p : molecule.positions) p = upright * p;
    return molecule;
  }
  return molecule;
}

// The height of the topmost layer of atoms: of the hexagon, or of the six around it where that is gone.
double top(const Molecule& molecule) {
  double height = 0;
  for (const Vec3& p : molecule.positions) height = std::max(height, p.z());
  return height;
}

// Without the hexagons at the top, and at the bottom too if asked.
Molecule opened(const Molecule& molecule, bool below) {
  const double cut = top(molecule) - 0.1;
  Molecule open;
  for (const Vec3& p : molecule.positions)
    if (p.z() < cut && (!below || p.z() > -cut)) open.positions.push_back(p);
  open.elements.assign(open.positions.size(), Element::carbon);
  return test::with_bonds_by_distance(open);
}

// A cage and its mirror image above it, their topmost layers that far apart.
Molecule facing(const Molecule& cage, double distance) {
  Molecule image = cage;
  const double plane = top(cage) + 0.5 * distance;
  for (Vec3& p : image.positions) p.z() = 2 * plane - p.z();
  return test::with_bonds_by_distance(test::together(cage, image));
}

// Connected sums of spheres are spheres: two of Euler characteristic 2 lose a disc each.
TEST(MergingShells, TwoCagesJoinedByANeckAreOneSphere) {
  const Molecule molecule = facing(opened(c60_on_a_hexagon(), false), bond);
  ASSERT_EQ(molecule.size(), 108u);
  ASSERT_EQ(molecule.bonds.size(), 162u);
  const SurfaceTopology s = topology(molecule);
  ASSERT_FALSE(s.problem) << s.problem->reason;
  EXPECT_THAT(s.components, ElementsAre(ComponentTopology{true, true, 0, 0}));
  EXPECT_EQ(s.euler_characteristic, 2);
  // Around the neck two halves of three pentagons and of three hexagons meet, which lost an edge each.
  EXPECT_EQ(s.ring_counts[5], 18u);
  EXPECT_EQ(s.ring_counts[8], 3u);
  for (const std::uint64_t seed : {1, 2, 3})
    EXPECT_EQ(topology(test::turned_and_shuffled(molecule, seed)).components, s.components);
}

// A chain of cages that goes on through the boundary closes to a torus.
TEST(MergingShells, TwoNecksMakeAHandle) {
  const Molecule cage = opened(c60_on_a_hexagon(), true);
  Molecule chain = facing(cage, bond);
  chain.cell = orthogonal_cell(Vec3(30, 30, 4 * top(cage) + 2 * bond), {false, false, true});
  chain = test::with_bonds_by_distance(chain);
  ASSERT_EQ(chain.size(), 96u);
  ASSERT_EQ(chain.bonds.size(), 144u);
  const SurfaceTopology s = topology(chain);
  ASSERT_FALSE(s.problem) << s.problem->reason;
  EXPECT_THAT(s.components, ElementsAre(ComponentTopology{true, true, 1, 0}));
  EXPECT_EQ(s.euler_characteristic, 0);
}

// On the way there six atoms have a fourth bond, which is no surface, whatever else may be said of it.
TEST(MergingShells, CagesThatTouchAreNoSurface) {
  const Molecule cage = c60_on_a_hexagon();
  const SurfaceTopology apart = topology(facing(cage, 3.0));
  ASSERT_FALSE(apart.problem);
  EXPECT_EQ(apart.components.size(), 2u);
  const SurfaceTopology touching = topology(facing(cage, bond));
  ASSERT_TRUE(touching.problem);
  EXPECT_THAT(touching.problem->reason, HasSubstr("is bonded to 4 carbon atoms"));
  EXPECT_EQ(judge(apart, touching, false).verdict, Verdict::not_a_surface);
}

TEST(MergingShells, GrowingTogetherIsBroken) {
  const Molecule cage = c60_on_a_hexagon();
  const SurfaceTopology apart = topology(facing(cage, 3.0));
  const SurfaceTopology merged = topology(facing(opened(cage, false), bond));
  const Judgement judgement = judge(apart, merged, false);
  EXPECT_EQ(judgement.verdict, Verdict::broken);
  EXPECT_EQ(judgement.reason, "1 piece instead of 2");
  // Open cages that grow together lose their rims, too.
  const SurfaceTopology open = topology(facing(opened(cage, false), 3.0));
  EXPECT_THAT(open.components,
              ElementsAre(ComponentTopology{true, true, 0, 1}, ComponentTopology{true, true, 0, 1}));
  EXPECT_EQ(judge(open, merged, false).verdict, Verdict::broken);
}

}  // namespace
}  // namespace nanocarbon::topology
