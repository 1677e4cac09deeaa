// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/failed_molecule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"
#include "support/facing_benzenes.h"

namespace nanocarbon::building {
namespace {

using ::testing::HasSubstr;

TEST(DescribeFailure, NamesTheBondAndItsPlaceInTheMesh) {
  Molecule molecule = structures::fullerene(1, 1);
  const Bond bond = molecule.bonds.front();
  const Vec3 outwards = molecule.positions[bond.first].normalized();
  molecule.positions[bond.first] += 4 * outwards;
  const SizedSurface surface{shapes::make_sphere(3.55, 8), 10.0, 60};
  const std::string said = describe_failure(molecule, surface);
  EXPECT_THAT(said, HasSubstr("a bond stretched to 4."));
  // Ten Angstrom for each unit of the mesh.
  const Vec3 middle = 0.05 * (molecule.positions[bond.first] + molecule.positions[bond.second]);
  const auto near = said.find("near (");
  ASSERT_NE(near, std::string::npos);
  EXPECT_NEAR(std::stod(said.substr(near + 6)), middle.x(), 0.25);
}

TEST(DescribeFailure, NamesAtomsThatAreTooClose) {
  Molecule molecule = structures::fullerene(1, 1);
  for (Vec3& p : molecule.positions) p *= 0.7;
  const std::string said = describe_failure(molecule, {shapes::make_sphere(3.55, 8), 1.0, 60});
  EXPECT_THAT(said, HasSubstr("two unbonded atoms pressed to within"));
}

TEST(WhyItDoesNotHold, IsNotThatHydrogensFaceEachOtherUnlessTheyBind) {
  const SizedSurface surface{shapes::make_sphere(3.55, 8), 1.0, 60};
  EXPECT_THAT(describe_failure(test::hydrogen_to_hydrogen(1.0), surface),
              HasSubstr("two unbonded atoms pressed to within 1.00 A"));
  Molecule molecule = test::hydrogen_to_hydrogen(1.4);
  molecule.positions.back() *= 1.2;  // a hydrogen at the far end: its bond is too long
  EXPECT_THAT(describe_failure(molecule, surface), HasSubstr("a bond stretched to"));
}

}  // namespace
}  // namespace nanocarbon::building
