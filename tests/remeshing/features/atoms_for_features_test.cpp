// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/remeshing/features/atoms_for_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>

#include "nanocarbon/mesh/formats/load_surface.h"
#include "nanocarbon/mesh/measures.h"
#include "remeshing/shapes.h"
#include "support/models.h"

namespace nanocarbon::features {
namespace {

constexpr double area_per_atom = 2.6195;

TriangleMesh stretched(TriangleMesh mesh, double factor) {
  for (Vec3& p : mesh.points) p *= factor;
  return mesh;
}

//! A surface enlarged until it has room for a number of atoms.
TriangleMesh for_atoms(const TriangleMesh& surface, double atoms) {
  return stretched(surface, std::sqrt(atoms * area_per_atom / mesh::area(surface)));
}

bool accepted(const TriangleMesh& surface, double atoms) {
  return check_features(for_atoms(surface, atoms)).ok();
}

std::optional<std::size_t> advice(const TriangleMesh& surface, double atoms) {
  return atoms_for_features(surface, atoms, check_features(surface)).atoms;
}

//! The largest number of two digits below one.
double below(double number) {
  const double unit = std::pow(10.0, std::ceil(std::log10(number)) - 2);
  return number - unit;
}

//! What is asked for is held, and the next smaller number of two digits is not.
void expect_smallest_that_is_accepted(const TriangleMesh& surface, double atoms) {
  ASSERT_FALSE(accepted(surface, atoms));
  const auto advised = advice(for_atoms(surface, atoms), atoms);
  ASSERT_TRUE(advised);
  const auto number = static_cast<double>(*advised);
  EXPECT_TRUE(accepted(surface, number)) << number;
  EXPECT_FALSE(accepted(surface, below(number))) << number;
}

//! A torus whose limb has rings around it, like a stack of beads.
TriangleMesh beads(double limb, double depth, int count) {
  TriangleMesh mesh = test::torus(20, 1, 360, 12);
  for (Vec3& p : mesh.points) {
    const double round = std::atan2(p.y(), p.x());
    const Vec3 axis(20 * std::cos(round), 20 * std::sin(round), 0);
    p = axis + (limb + depth * std::cos(count * round)) * (p - axis);
  }
  return mesh;
}

TEST(AtomsForFeatures, AThinTorusNeedsWhatItsRadiusAsksFor) {
  const TriangleMesh surface = test::torus(20, 1.5, 160, 20);
  const double atoms = mesh::area(surface) / area_per_atom;
  expect_smallest_that_is_accepted(surface, atoms);
  // Lengths grow with the root of the atoms; the ratio follows from the radius alone, up to rounding to two
  // digits.
  const double ratio = FeatureLimits().tube_radius / 1.5;
  EXPECT_NEAR(std::sqrt(static_cast<double>(*advice(surface, atoms)) / atoms), ratio, 0.1 * ratio);
}

// Smoothed normals hide the waists between beads while they are short: the enlargement that the narrowest
// of them asks for is twice what is needed.
TEST(AtomsForFeatures, BeadsNeedNoMoreThanIsAccepted) {
  expect_smallest_that_is_accepted(beads(1.5, 0.5, 60), 800);
}

// The edge of a wedge of 20 degrees is thinner than two sheets at any size.
TEST(AtomsForFeatures, NoNumberIsEnoughForAWedge) {
  const double half = 20 * std::tan(10 * std::numbers::pi / 180);
  const TriangleMesh wedge{
      {Vec3(0, 0, 0), Vec3(20, 0, half), Vec3(20, 0, -half), Vec3(0, 30, 0), Vec3(20, 30, half),
       Vec3(20, 30, -half)},
      {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}}};
  const double atoms = mesh::area(wedge) / area_per_atom;
  ASSERT_FALSE(accepted(wedge, atoms));
  EXPECT_FALSE(advice(wedge, atoms));
}

TEST(AtomsForFeatures, RealMeshesAreAcceptedAtWhatIsAdvised) {
  NANOCARBON_NEEDS_MODELS();
  for (const auto& entry : std::filesystem::directory_iterator(test::models_folder())) {
    const std::string file = entry.path().filename().string();
    const std::string kind = entry.path().extension().string();
    if (file.starts_with("bad-") || (kind != ".off" && kind != ".obj")) continue;
    SCOPED_TRACE(file);
    const TriangleMesh surface = mesh::load_surface(entry.path()).mesh;
    // The smallest is only sought where looking is quick.
    if (accepted(surface, 3000)) continue;
    const auto advised = advice(for_atoms(surface, 3000), 3000);
    if (!advised) continue;
    EXPECT_TRUE(accepted(surface, static_cast<double>(*advised))) << *advised;
  }
}

}  // namespace
}  // namespace nanocarbon::features
