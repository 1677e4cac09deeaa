// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/minimisation/certificate.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "nanocarbon/molecule/hydrogens.h"
#include "nanocarbon/potential/airebo/airebo.h"
#include "nanocarbon/potential/rebo2/rebo2.h"
#include "nanocarbon/structures/fullerene.h"
#include "nanocarbon/structures/graphene.h"
#include "nanocarbon/structures/onion.h"

namespace nanocarbon::minimisation {
namespace {

// All eigenvalues of the Hessian, from the matrix itself.
Eigen::VectorXd dense_spectrum(const Molecule& molecule, potential::Potential& potential) {
  const auto n = static_cast<Eigen::Index>(3 * molecule.size());
  Eigen::MatrixXd hessian(n, n);
  const double h = 1e-6;
  for (Eigen::Index k = 0; k < n; ++k) {
    std::vector<Vec3> moved = molecule.positions;
    moved[static_cast<std::size_t>(k / 3)][k % 3] += h;
    const std::vector<Vec3> ahead = potential.evaluate(moved, molecule.elements, nullptr, {}).forces;
    moved[static_cast<std::size_t>(k / 3)][k % 3] -= 2 * h;
    const std::vector<Vec3> behind = potential.evaluate(moved, molecule.elements, nullptr, {}).forces;
    for (Eigen::Index m = 0; m < n; ++m)
      hessian(m, k) =
          (behind[static_cast<std::size_t>(m / 3)][m % 3] - ahead[static_cast<std::size_t>(m / 3)][m % 3]) /
          (2 * h);
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (hessian + hessian.transpose())).eigenvalues();
}

void expect_eigenvalues_of_dense_matrix(const Molecule& molecule, const Certificate& certificate, int rigid,
                                        potential::Potential& potential) {
  const Eigen::VectorXd all = dense_spectrum(molecule, potential);
  for (int k = 0; k < rigid; ++k) EXPECT_NEAR(all[k], 0, 1e-4);
  ASSERT_EQ(certificate.eigenvalues.size(), 3u);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(certificate.eigenvalues[static_cast<std::size_t>(k)], all[rigid + k], 1e-4);
}

// C20H10, laid out flat: a pentagon, five spokes, ten atoms of the rim.
Molecule flat_corannulene() {
  Molecule molecule;
  const auto add = [&](double radius, double fifths) {
    const double angle = 2 * std::numbers::pi / 5 * fifths;
    molecule.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), 0);
  };
  for (int k = 0; k < 5; ++k) add(1.21, k);
  for (int k = 0; k < 5; ++k) add(2.60, k);
  for (int k = 0; k < 5; ++k) {
    add(3.3, k - 0.29);
    add(3.3, k + 0.29);
  }
  const auto bond = [&](AtomIndex a, AtomIndex b) {
    molecule.bonds.push_back({std::min(a, b), std::max(a, b)});
  };
  for (AtomIndex k = 0; k < 5; ++k) {
    bond(k, (k + 1) % 5);
    bond(k, 5 + k);
    bond(5 + k, 10 + 2 * k);
    bond(5 + k, 11 + 2 * k);
    bond(11 + 2 * k, 10 + 2 * ((k + 1) % 5));
  }
  std::sort(molecule.bonds.begin(), molecule.bonds.end());
  molecule.elements.assign(20, Element::carbon);
  return molecule::saturated_with_hydrogen(molecule);
}

TEST(Certify, C60IsAMinimumWithTheEigenvaluesOfTheFullMatrix) {
  Molecule molecule = structures::fullerene(1, 1);
  rebo2::Rebo2 rebo2;
  const Certificate certificate = certify(molecule, rebo2);
  EXPECT_TRUE(certificate.minimum());
  EXPECT_TRUE(certificate.intact);
  EXPECT_EQ(certificate.pushes, 0);
  EXPECT_LT(certificate.uncertainty, 5e-5);
  EXPECT_NEAR(certificate.energy / 60, -6.8420645371, 1e-9);
  expect_eigenvalues_of_dense_matrix(molecule, certificate, 6, rebo2);
}

TEST(Certify, PiecesMoveOnTheirOwn) {
  Molecule two = structures::fullerene(1, 1);
  const Molecule other = structures::fullerene(1, 1);
  for (std::size_t a = 0; a < 60; ++a) {
    two.positions.push_back(other.positions[a] + Vec3(15, 0, 0));
    two.elements.push_back(Element::carbon);
  }
  for (const Bond& bond : other.bonds) two.bonds.push_back({bond.first + 60, bond.second + 60});
  rebo2::Rebo2 rebo2;
  const Certificate certificate = certify(two, rebo2);
  EXPECT_TRUE(certificate.minimum());
  expect_eigenvalues_of_dense_matrix(two, certificate, 12, rebo2);
}

// Flat, corannulene is the saddle between its two bowls, and by symmetry no force leads out of the plane.
TEST(Certify, LeavesASaddle) {
  Molecule molecule = flat_corannulene();
  rebo2::Rebo2 rebo2;
  const Certificate certificate = certify(molecule, rebo2);
  EXPECT_GE(certificate.pushes, 1);
  EXPECT_TRUE(certificate.minimum());
  EXPECT_TRUE(certificate.intact);
  const double depth = std::abs(molecule.positions[0].z() - molecule.positions[10].z());
  EXPECT_GT(depth, 0.5);  // measured by X-ray: 0.87 Angstrom (Hanson and Nordman 1976)
  EXPECT_LT(depth, 1.2);
  expect_eigenvalues_of_dense_matrix(molecule, certificate, 6, rebo2);
}

TEST(Certify, StaysWithASaddleWhereItMayNotPush) {
  Molecule molecule = flat_corannulene();
  rebo2::Rebo2 rebo2;
  const Certificate certificate = certify(molecule, rebo2, {.pushes = 0});
  EXPECT_FALSE(certificate.minimum());
  EXPECT_LT(certificate.eigenvalues.front(), 0);
  for (const Vec3& p : molecule.positions) EXPECT_NEAR(p.z(), 0, 1e-9);
}

// REBO2 lets them drift apart; by AIREBO they are one molecule with six rigid motions.
TEST(Certify, TwoBenzenesComeToAMinimumOfAirebo) {
  const Molecule benzene = molecule::saturated_with_hydrogen(structures::graphene_flake(1.5));
  Molecule two = benzene;
  structures::append(two, benzene);
  for (std::size_t a = benzene.size(); a < two.size(); ++a) two.positions[a] += Vec3(0.3, 0.1, 3.5);
  airebo::Airebo airebo;
  const Certificate certificate = certify(two, airebo);
  EXPECT_TRUE(certificate.minimum());
  EXPECT_TRUE(certificate.intact);
  EXPECT_LE(certificate.energy, 2 * -59.0751381406 - 0.1);  // two apart: LAMMPS's airebo, eV
  expect_eigenvalues_of_dense_matrix(two, certificate, 6, airebo);
}

}  // namespace
}  // namespace nanocarbon::minimisation
