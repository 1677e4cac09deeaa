// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/molecule/hydrogens.h"

#include <gmock/gmock.h>

#include "molecule/cases.h"
#include "nanocarbon/molecule/bond_statistics.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/tube.h"
#include "nanocarbon/topology/bond_graph.h"

namespace nanocarbon::molecule {
namespace {

std::size_t hydrogens(const Molecule& m) {
  return static_cast<std::size_t>(std::count(m.elements.begin(), m.elements.end(), Element::hydrogen));
}

Molecule carbons(std::vector<Vec3> positions) {
  Molecule molecule;
  molecule.positions = std::move(positions);
  molecule.elements.assign(molecule.positions.size(), Element::carbon);
  return test::with_bonds_by_distance(molecule);
}

TEST(Hydrogens, TheSmallestFlakesAreBenzeneAndCoronene) {
  const Molecule benzene = saturated_with_hydrogen(structures::graphene_flake(1.5));
  EXPECT_EQ(benzene.size(), 12u);
  EXPECT_EQ(hydrogens(benzene), 6u);
  const Spread angles = spread(bond_angles(benzene));
  EXPECT_NEAR(angles.min, 120.0, 1e-6);
  EXPECT_NEAR(angles.max, 120.0, 1e-6);
  const Molecule coronene = saturated_with_hydrogen(structures::graphene_flake(4.0));
  EXPECT_EQ(coronene.size() - hydrogens(coronene), 24u);
  EXPECT_EQ(hydrogens(coronene), 12u);
}

TEST(Hydrogens, BondsAreAsLongAsAskedForAndAreThoseOfTheirDistances) {
  const Molecule bare = structures::open_tube(8, 4, 20.0), tube = saturated_with_hydrogen(bare);
  EXPECT_TRUE(test::with_bonds_by_distance(tube).bonds == tube.bonds);
  for (std::size_t b = 0; b < tube.bonds.size(); ++b)
    if (tube.elements[tube.bonds[b].second] == Element::hydrogen) {
      EXPECT_NEAR(bond_lengths(tube)[b], 1.09, 1e-12);
    }
  EXPECT_THAT(test::topology(tube).coordination,
              testing::Each(testing::AnyOf(testing::Eq(3), testing::Eq(1))));  // carbon, hydrogen
  EXPECT_EQ(test::topology(tube).components, test::topology(bare).components);
}

TEST(Hydrogens, OneBondGetsTwoInThePlaneOfTheOtherAtom) {
  const Molecule ethylene = saturated_with_hydrogen(carbons({Vec3(0, 0, 0), Vec3(1.33, 0, 0)}));
  EXPECT_EQ(hydrogens(ethylene), 4u);
  const Spread angles = spread(bond_angles(ethylene));
  EXPECT_NEAR(angles.mean, 120.0, 1e-6);
  EXPECT_NEAR(angles.deviation, 0.0, 1e-6);
  // The end of a bent chain continues its plane.
  const Molecule chain =
      saturated_with_hydrogen(carbons({Vec3(0, 0, 0), Vec3(1.4, 0, 0), Vec3(2.1, 1.21, 0)}));
  EXPECT_EQ(hydrogens(chain), 5u);
  for (const Vec3& p : chain.positions) EXPECT_NEAR(p[2], 0.0, 1e-12);
}

TEST(Hydrogens, WholeMoleculesStayAsTheyAre) {
  EXPECT_EQ(saturated_with_hydrogen(structures::fullerene(1, 1)).size(), 60u);
  EXPECT_EQ(saturated_with_hydrogen(structures::graphene(3, 2)).size(), structures::graphene(3, 2).size());
  const Molecule once = saturated_with_hydrogen(structures::graphene_flake(6.0));
  EXPECT_EQ(saturated_with_hydrogen(once).size(), once.size());
  EXPECT_EQ(saturated_with_hydrogen({}).size(), 0u);
}

TEST(Hydrogens, LoneAtomsAndStraightChainsToo) {
  EXPECT_EQ(hydrogens(saturated_with_hydrogen(carbons({Vec3(1, 2, 3)}))), 3u);
  const Molecule chain = saturated_with_hydrogen(carbons({Vec3(0, 0, 0), Vec3(1.3, 0, 0), Vec3(2.6, 0, 0)}));
  EXPECT_EQ(hydrogens(chain), 5u);
  EXPECT_TRUE(test::with_bonds_by_distance(chain).bonds == chain.bonds);
}

}  // namespace
}  // namespace nanocarbon::molecule
