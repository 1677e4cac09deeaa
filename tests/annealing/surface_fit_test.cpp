// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/annealing/surface_fit.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "nanocarbon/shapes/shapes.h"

namespace nanocarbon::annealing {
namespace {

double mean_distance(std::span<const Vec3> positions, const TetherSurface& surface) {
  double sum = 0;
  for (const Vec3& p : positions) sum += surface.distance(p) / static_cast<double>(positions.size());
  return sum;
}

// No two of its axes alike, so that every motion shows.
TriangleMesh ellipsoid() {
  TriangleMesh mesh = shapes::make_sphere(1.0, 4);
  for (Vec3& p : mesh.points) p = Vec3(20 * p.x(), 15 * p.y(), 10 * p.z());
  return mesh;
}

TEST(SurfaceFit, FindsTheMotionThatWasMade) {
  const TriangleMesh mesh = ellipsoid();
  const Mat3 turn = Eigen::AngleAxisd(0.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
  std::vector<Vec3> moved;
  for (const Vec3& p : mesh.points) moved.push_back(1.03 * (turn * p) + Vec3(0.5, -0.3, 0.8));
  const TetherSurface surface(mesh, 1);
  const Similarity fit = fit_to_surface(moved, surface, true);
  std::vector<Vec3> back;
  for (const Vec3& p : moved) back.push_back(fit(p));
  EXPECT_NEAR(fit.scale, 1 / 1.03, 1e-3);
  EXPECT_LT(mean_distance(back, surface), 0.02);
  EXPECT_GT(mean_distance(moved, surface), 0.4);
}

TEST(SurfaceFit, KeepsTheSizeWhereThatIsAsked) {
  const TriangleMesh mesh = ellipsoid();
  std::vector<Vec3> larger;
  for (const Vec3& p : mesh.points) larger.push_back(1.05 * p);
  EXPECT_EQ(fit_to_surface(larger, TetherSurface(mesh, 1), false).scale, 1.0);
}

// A wedge of six degrees: the nearest planes turn over between its sides, and steps by them led 60 Angstrom
// away.
TEST(SurfaceFit, NeverLeadsAwayFromAThinShape) {
  TriangleMesh wedge;
  wedge.points = {{0, 0, 0}, {20, 0, 1.05}, {20, 0, -1.05}, {0, 30, 0}, {20, 30, 1.05}, {20, 30, -1.05}};
  wedge.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {0, 2, 5}, {0, 5, 3}, {1, 4, 5}, {1, 5, 2}};
  const TetherSurface surface(wedge, 1.5);
  std::mt19937_64 random(7);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  const auto sum_of_squares = [&](const std::vector<Vec3>& atoms, const Similarity& fit) {
    double sum = 0;
    for (const Vec3& p : atoms) sum += std::pow(surface.distance(fit(p)), 2);
    return sum;
  };
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<Vec3> atoms;
    for (int k = 0; k < 300; ++k)
      atoms.push_back(Vec3(25 * uniform(), 45 * uniform(), 0.3 * trial * (2 * uniform() - 1)));
    const Similarity fit = fit_to_surface(atoms, surface, true);
    EXPECT_LE(sum_of_squares(atoms, fit), sum_of_squares(atoms, Similarity{}) + 1e-9) << trial;
  }
}

TEST(SurfaceFit, LeavesSymmetriesOfTheSurfaceAlone) {
  const TriangleMesh sphere = shapes::make_sphere(10.0, 5);
  std::vector<Vec3> positions = sphere.points;
  for (Vec3& p : positions) p = 1.02 * p + Vec3(0, 0, 0.2);
  const Similarity fit = fit_to_surface(positions, TetherSurface(sphere, 1), true);
  EXPECT_LT((fit.turn - Mat3::Identity()).norm(), 1e-6);
  EXPECT_NEAR(fit.scale, 1 / 1.02, 1e-3);
}

TEST(BringBack, FindsMoleculesThatHaveDriftedFarFromTheirSurface) {
  const TriangleMesh mesh = ellipsoid();
  std::mt19937 random(7);
  std::normal_distribution<double> wobble(0, 0.3);
  const Mat3 turn = Eigen::AngleAxisd(0.4, Vec3(3, -1, 2).normalized()).toRotationMatrix();
  std::vector<Vec3> drifted, shifted, wobbled;
  for (const Vec3& p : mesh.points) {
    const Vec3 there = p + Vec3(wobble(random), wobble(random), wobble(random));
    wobbled.push_back(there);
    drifted.push_back(turn * there + Vec3(30, -20, 10));
    shifted.push_back(there + Vec3(30, -20, 10));
  }
  drifted.push_back(turn * Vec3(1, 2, 3) + Vec3(30, -20, 10));  // one that follows
  bring_back(drifted, mesh.points, true);
  bring_back(shifted, mesh.points, false);
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    EXPECT_NEAR((drifted[i] - wobbled[i]).norm(), 0, 0.1);
    EXPECT_NEAR((shifted[i] - wobbled[i]).norm(), 0, 0.1);
  }
  EXPECT_NEAR((drifted.back() - Vec3(1, 2, 3)).norm(), 0, 0.1);
  const std::vector<Vec3> before = wobbled;
  bring_back(wobbled, mesh.points, true);
  EXPECT_EQ(wobbled, before);
}

}  // namespace
}  // namespace nanocarbon::annealing
