// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/building/failed_molecule.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "nanocarbon/shapes/shapes.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::building {
namespace {

using ::testing::HasSubstr;

TEST(WhyItDoesNotHold, NamesTheBondAndItsPlaceInTheMesh) {
  Molecule molecule = structures::fullerene(1, 1);
  const Bond bond = molecule.bonds.front();
  const Vec3 outwards = molecule.positions[bond.first].normalized();
  molecule.positions[bond.first] += 4 * outwards;
  const SizedSurface surface{shapes::make_sphere(3.55, 8), 10.0, 60};
  const std::string said = describe_failure(molecule, surface);
  EXPECT_THAT(said, HasSubstr("a bond stretched at 4."));
  // Ten Angstrom for each unit of the mesh.
  const Vec3 middle = 0.05 * (molecule.positions[bond.first] + molecule.positions[bond.second]);
  const auto near = said.find("near (");
  ASSERT_NE(near, std::string::npos);
  EXPECT_NEAR(std::stod(said.substr(near + 6)), middle.x(), 0.25);
}

TEST(WhyItDoesNotHold, NamesAtomsThatAreTooClose) {
  Molecule molecule = structures::fullerene(1, 1);
  for (Vec3& p : molecule.positions) p *= 0.7;
  const std::string said = describe_failure(molecule, {shapes::make_sphere(3.55, 8), 1.0, 60});
  EXPECT_THAT(said, HasSubstr("without a bond pressed together"));
}

TEST(WhyItDoesNotHold, AsksForMoreAtoms) {
  const Molecule molecule = structures::fullerene(1, 1);
  const std::string wide = describe_failure(molecule, {shapes::make_sphere(12, 10), 1.0, 690});
  EXPECT_THAT(wide, HasSubstr("--atoms 1035 or more"));
  // A torus whose tube should be 3.4 Angstrom wide and is 2 wants nearly three times the atoms.
  const std::string narrow = describe_failure(molecule, {shapes::make_torus(15, 2, 0.6), 1.0, 452});
  const double more = std::stod(narrow.substr(narrow.find("--atoms ") + 8));
  // Chords from side to side are up to 8% shorter than the diameter, and two digits are given.
  EXPECT_GE(more, 452 * 3.4 * 3.4 / 4);
  EXPECT_LE(more, 452 * 3.4 * 3.4 / 4 * 1.08 * 1.08 + 100);
}

}  // namespace
}  // namespace nanocarbon::building
