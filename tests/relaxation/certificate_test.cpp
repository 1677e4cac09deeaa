#include "nanocarbon/relaxation/certificate.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "nanocarbon/rebo2/rebo2.h"
#include "nanocarbon/relaxation/hessian_spectrum.h"
#include "nanocarbon/structures/fullerene.h"

namespace nanocarbon {
namespace {

// All eigenvalues of the Hessian, from the matrix itself.
Eigen::VectorXd dense_spectrum(const Molecule& molecule) {
  const auto n = static_cast<Eigen::Index>(3 * molecule.size());
  Eigen::MatrixXd hessian(n, n);
  Rebo2 rebo2;
  const double h = 1e-4;
  for (Eigen::Index k = 0; k < n; ++k) {
    std::vector<Vec3> moved = molecule.positions;
    moved[static_cast<std::size_t>(k / 3)][k % 3] += h;
    const std::vector<Vec3> ahead = rebo2.evaluate(moved, molecule.elements).forces;
    moved[static_cast<std::size_t>(k / 3)][k % 3] -= 2 * h;
    const std::vector<Vec3> behind = rebo2.evaluate(moved, molecule.elements).forces;
    for (Eigen::Index m = 0; m < n; ++m)
      hessian(m, k) =
          (behind[static_cast<std::size_t>(m / 3)][m % 3] - ahead[static_cast<std::size_t>(m / 3)][m % 3]) /
          (2 * h);
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(0.5 * (hessian + hessian.transpose())).eigenvalues();
}

TEST(Certify, C60IsAMinimumWithTheEigenvaluesOfTheFullMatrix) {
  Molecule molecule = fullerene(1, 1);
  const Certificate certificate = certify(molecule);
  EXPECT_TRUE(certificate.minimum());
  EXPECT_TRUE(certificate.intact);
  EXPECT_NEAR(certificate.energy / 60, -6.8420645371, 1e-9);
  const Eigen::VectorXd all = dense_spectrum(molecule);
  for (int rigid = 0; rigid < 6; ++rigid) EXPECT_NEAR(all[rigid], 0, 1e-3);
  ASSERT_EQ(certificate.eigenvalues.size(), 3u);
  // The lowest vibration of C60, H_g(1), is five-fold.
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(certificate.eigenvalues[static_cast<std::size_t>(k)], all[6 + k], 2e-3);
  EXPECT_GT(all[6], 0.1);
}

TEST(SmallestHessianEigenvalues, ASaddleHasANegativeOne) {
  // Springs from the corners of a tetrahedron to its centre hold it, but one direction of one corner is
  // unstable.
  std::vector<Vec3> corners = {Vec3(1, 1, 1), Vec3(1, -1, -1), Vec3(-1, 1, -1), Vec3(-1, -1, 1)};
  const std::vector<Vec3> rest = corners;
  const auto saddle = [&](std::span<const Vec3> x, std::span<Vec3> g) {
    double sum = 0;
    for (std::size_t a = 0; a < x.size(); ++a) {
      const Vec3 d = x[a] - rest[a];
      const Vec3 stiffness = a == 0 ? Vec3(-30, 5, 6) : Vec3(7, 8, 9);
      g[a] += stiffness.cwiseProduct(d);
      sum += 0.5 * d.dot(stiffness.cwiseProduct(d));
    }
    return sum;
  };
  const HessianSpectrum spectrum = smallest_hessian_eigenvalues(corners, saddle, {.count = 1});
  EXPECT_TRUE(spectrum.converged);
  ASSERT_EQ(spectrum.smallest.size(), 1u);
  EXPECT_LT(spectrum.smallest[0], 0);
}

}  // namespace
}  // namespace nanocarbon
