// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/multilevel/sheet_preconditioner.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "nanocarbon/minimisation/minimise_molecule.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon::multilevel {
namespace {

SheetPreconditioner preconditioner_of(const Molecule& molecule) {
  SheetPreconditioner result(Space(), molecule.positions, bonded_atoms(molecule.size(), molecule.bonds));
  result.renew(molecule.positions);
  return result;
}

std::vector<Vec3> waves(std::size_t atoms, double phase) {
  std::vector<Vec3> result;
  for (std::size_t a = 0; a < atoms; ++a) {
    const double t = static_cast<double>(a) + phase;
    result.emplace_back(std::sin(0.1 * t), std::sin(1.3 * t), std::cos(0.01 * t));
  }
  return result;
}

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += a[k].dot(b[k]);
  return sum;
}

minimisation::LbfgsResult minimised(Molecule& molecule, SheetPreconditioner* preconditioner,
                                    double tolerance) {
  rebo2::Rebo2 rebo2;
  return minimisation::minimise_lbfgs(
      molecule.positions, minimisation::energy_of(molecule, rebo2),
      {.max_iterations = 20000, .force_tolerance = tolerance, .preconditioner = preconditioner});
}

// Bonds are up to a tenth too long or too short.
Molecule stretched_fullerene(int h) {
  Molecule molecule = structures::fullerene(h, h);
  for (Vec3& p : molecule.positions) p.x() *= 1.1, p.z() *= 0.95;
  return molecule;
}

TEST(SheetPreconditioner, IsSymmetricAndPositive) {
  const Molecule molecule = structures::fullerene(8, 8);
  const SheetPreconditioner preconditioner = preconditioner_of(molecule);
  const std::vector<Vec3> a = waves(molecule.size(), 0), b = waves(molecule.size(), 0.4);
  std::vector<Vec3> of_a(a.size()), of_b(b.size());
  preconditioner.apply(a, of_a);
  preconditioner.apply(b, of_b);
  EXPECT_GT(dot(a, of_a), 0);
  EXPECT_GT(dot(b, of_b), 0);
  EXPECT_NEAR(dot(a, of_b), dot(b, of_a), 1e-4 * std::sqrt(dot(a, of_a) * dot(b, of_b)));
}

TEST(SheetPreconditioner, LeadsToThatMinimumOfC2160ThatPlainLbfgsFindsInAFewSteps) {
  Molecule plain = stretched_fullerene(6), preconditioned = plain;
  SheetPreconditioner preconditioner = preconditioner_of(preconditioned);
  const minimisation::LbfgsResult one = minimised(plain, nullptr, 1e-5),
                                  other = minimised(preconditioned, &preconditioner, 1e-5);
  EXPECT_TRUE(one.converged);
  EXPECT_TRUE(other.converged);
  EXPECT_NEAR(one.energy / 2160, other.energy / 2160, 1e-8);
  EXPECT_LT(5 * other.iterations, one.iterations);
}

TEST(SheetPreconditioner, FourTimesTheAtomsTakeHardlyMoreIterations) {
  Molecule small = stretched_fullerene(6), large = stretched_fullerene(12);
  SheetPreconditioner for_small = preconditioner_of(small), for_large = preconditioner_of(large);
  const minimisation::LbfgsResult one = minimised(small, &for_small, 1e-3),
                                  other = minimised(large, &for_large, 1e-3);
  EXPECT_TRUE(one.converged);
  EXPECT_TRUE(other.converged);
  EXPECT_LT(other.iterations, 1.5 * one.iterations + 10);
}

TEST(SheetPreconditioner, BondedAtomsNeverMoveFartherThanTheStrainAgainstEachOther) {
  Molecule molecule = stretched_fullerene(6);
  SheetPreconditioner preconditioner = preconditioner_of(molecule);
  std::vector<Vec3> former = molecule.positions;
  double former_energy = std::numeric_limits<double>::infinity();
  rebo2::Rebo2 rebo2;
  const auto look = [&](int, double energy, std::span<const Vec3> now) {
    EXPECT_LE(energy, former_energy + 1e-8);
    former_energy = energy;
    for (const Bond& bond : molecule.bonds)
      EXPECT_LE(((now[bond.first] - former[bond.first]) - (now[bond.second] - former[bond.second])).norm(),
                0.1 * (1 + 1e-9));
    former.assign(now.begin(), now.end());
    return false;
  };
  Molecule moving = molecule;
  minimisation::minimise_lbfgs(
      moving.positions, minimisation::energy_of(moving, rebo2),
      {.max_iterations = 30, .preconditioner = &preconditioner, .max_strain = 0.1, .stop = look});
}

TEST(SheetPreconditioner, TakesMoleculesOfAnyKind) {
  Molecule pieces = structures::fullerene(1, 1);  // one level only
  for (int k = 0; k < 3; ++k) {                   // and atoms that are bonded to nothing
    pieces.positions.emplace_back(20.0 + k, 0, 0);
    pieces.elements.push_back(Element::carbon);
  }
  const SheetPreconditioner preconditioner = preconditioner_of(pieces);
  const std::vector<Vec3> right = waves(pieces.size(), 0);
  std::vector<Vec3> step(right.size());
  preconditioner.apply(right, step);
  EXPECT_GT(dot(right, step), 0);
  EXPECT_NEAR((step.back() - right.back()).norm(), 0, 1e-5);
}

// No spring resists that: rounding would send them anywhere.
TEST(SheetPreconditioner, LeavesMoleculesWhereTheyAreAsAWhole) {
  const Molecule molecule = structures::fullerene(8, 8);
  ASSERT_GE(molecule.size(), least_atoms);
  const SheetPreconditioner preconditioner = preconditioner_of(molecule);
  const std::vector<Vec3> gradient = waves(molecule.size(), 0);
  std::vector<Vec3> step(gradient.size());
  preconditioner.apply(gradient, step);
  Vec3 centre = Vec3::Zero(), shift = Vec3::Zero(), turn = Vec3::Zero();
  const auto n = static_cast<double>(step.size());
  for (const Vec3& p : molecule.positions) centre += p / n;
  double size = 0, size_of_turn = 0;
  for (std::size_t a = 0; a < step.size(); ++a) {
    const Vec3 arm = molecule.positions[a] - centre;
    shift += step[a];
    turn += arm.cross(step[a]);
    size += step[a].norm();
    size_of_turn += arm.norm() * step[a].norm();
  }
  EXPECT_GT(size / n, 1e-4);
  EXPECT_LT(shift.norm(), 1e-9 * size);
  EXPECT_LT(turn.norm(), 1e-9 * size_of_turn);
  EXPECT_GT(dot(gradient, step), 0);
}

// No spring ties them to each other, and a small force between them must not send them off.
TEST(SheetPreconditioner, MovesComponentsByLittle) {
  Molecule shells = structures::fullerene(8, 8);
  const std::size_t inner = shells.size();
  Molecule outer = structures::fullerene(9, 9);
  shells.positions.insert(shells.positions.end(), outer.positions.begin(), outer.positions.end());
  shells.elements.insert(shells.elements.end(), outer.elements.begin(), outer.elements.end());
  for (const Bond& b : outer.bonds)
    shells.bonds.push_back(
        {b.first + static_cast<AtomIndex>(inner), b.second + static_cast<AtomIndex>(inner)});
  const SheetPreconditioner preconditioner = preconditioner_of(shells);
  std::vector<Vec3> gradient(shells.size(), Vec3::Zero()), step(shells.size());
  std::fill_n(gradient.begin(), inner, Vec3(0.01, 0, 0));
  preconditioner.apply(gradient, step);
  double farthest = 0;
  for (const Vec3& d : step) farthest = std::max(farthest, d.norm());
  EXPECT_GT(farthest, 0.01);
  EXPECT_LT(farthest, 1);
  EXPECT_GE(preconditioner.strain(step), 0.2 * farthest);
}

}  // namespace
}  // namespace nanocarbon::multilevel
