// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/sheet_springs.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>

#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

double energy_of_displacement(const SheetSprings& springs, const std::vector<Vec3>& u) {
  double sum = 0;
  std::vector<Block> row;
  for (std::size_t i = 0; i < u.size(); ++i) {
    springs.row(i, row);
    for (std::size_t k = 0; k < row.size(); ++k) {
      const Block& b = row[k];
      Mat3 full;
      full << b[0], b[1], b[2], b[1], b[3], b[4], b[2], b[4], b[5];
      sum += 0.5 * u[i].dot(full * u[springs.pattern().of(i)[k]]);
    }
  }
  return sum;
}

class SpringsOfC540 : public testing::Test {
 protected:
  SpringsOfC540() : springs(bonded_atoms(540, molecule.bonds), {}) {
    springs.set(Space(), molecule.positions, {});
  }
  std::vector<Vec3> displaced(const std::function<Vec3(const Vec3&)>& by) const {
    std::vector<Vec3> result;
    for (const Vec3& x : molecule.positions) result.push_back(by(x));
    return result;
  }
  Molecule molecule = structures::fullerene(3, 3);
  SheetSprings springs;
};

TEST_F(SpringsOfC540, RigidMotionsCostNextToNothing) {
  const double shift = energy_of_displacement(springs, displaced([](const Vec3&) { return Vec3(1, 2, 3); })),
               turn = energy_of_displacement(
                   springs, displaced([](const Vec3&x) { return Vec3(Vec3(0.1, 0.2, -0.3).cross(x)); }));
  EXPECT_NEAR(shift, 0, 1e-5);
  EXPECT_NEAR(turn, 0, 0.1);  // stretching all springs by as much would cost 10,000 eV
}

// Breathing stretches each bond by 1% of 1.43 Angstrom and each pair of second neighbours by 1% of about 2.46.
TEST_F(SpringsOfC540, BreathingStretchesEverySpring) {
  const double energy =
      energy_of_displacement(springs, displaced([](const Vec3& x) { return Vec3(0.01 * x); }));
  const double bonds = 810 * 0.5 * 60 * std::pow(0.0143, 2), second = 1620 * 0.5 * 6 * std::pow(0.0246, 2);
  EXPECT_NEAR(energy, bonds + second, 0.05 * (bonds + second));
}

TEST_F(SpringsOfC540, AHoldResistsInItsDirectionOnly) {
  Holds holds(540, Vec3::Zero());
  holds[7] = Vec3(0, 0, 2);
  const auto cost = [&](const Vec3& by) {
    springs.set(Space(), molecule.positions, holds);
    return energy_of_displacement(springs, std::vector<Vec3>(540, by));
  };
  EXPECT_NEAR(cost(Vec3(1, 1, 0)), 0, 1e-5);
  EXPECT_NEAR(cost(Vec3(0, 0, 1)), 2, 1e-5);
}

TEST(SheetSprings, AtomsOfNoSheetAreHeldToTheirNeighbours) {
  SheetSprings chain(bonded_atoms(3, std::vector<Bond>{{0, 1}, {1, 2}}), {});
  chain.set(Space(), std::vector<Vec3>{Vec3(0, 0, 0), Vec3(1.3, 0, 0), Vec3(2.6, 0, 0)}, {});
  EXPECT_GT(energy_of_displacement(chain, {Vec3(0, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, 0)}), 0.5);
}

}  // namespace
}  // namespace nanocarbon::multilevel
