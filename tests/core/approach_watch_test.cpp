// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/core/approach_watch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

namespace nanocarbon {
namespace {

constexpr double reach = 2, margin = 0.4;  // Angstrom

std::vector<Vec3> grid(int side) {
  std::vector<Vec3> points;
  for (int x = 0; x < side; ++x)
    for (int y = 0; y < side; ++y) points.emplace_back(2.5 * x, 2.5 * y, 0);
  return points;
}

TEST(ApproachWatch, RestIsNoApproach) {
  const std::vector<Vec3> points = grid(20);
  ApproachWatch watch(reach, margin);
  EXPECT_TRUE(watch.may_be_closer(points, true));  // of nothing known
  watch.set(points);
  EXPECT_FALSE(watch.may_be_closer(points, true));
}

TEST(ApproachWatch, WhatMovesAsAWholeComesNoCloser) {
  std::vector<Vec3> points = grid(20);
  ApproachWatch watch(reach, margin), in_cell(reach, margin);
  watch.set(points);
  in_cell.set(points);
  const Mat3 turn = Eigen::AngleAxisd(0.02, Vec3::UnitZ()).toRotationMatrix();
  for (Vec3& p : points) p = turn * p + Vec3(30, -20, 5);
  EXPECT_FALSE(watch.may_be_closer(points, true));
  EXPECT_TRUE(in_cell.may_be_closer(points, false));
}

TEST(ApproachWatch, AGentleBendComesNoCloser) {
  std::vector<Vec3> points = grid(20);
  ApproachWatch watch(reach, margin);
  watch.set(points);
  for (Vec3& p : points) p.z() += 5e-4 * p.x() * p.x();  // by 1.1 Angstrom at the end
  EXPECT_FALSE(watch.may_be_closer(points, true));
}

// Against all pairs: no approach is missed, of whatever kind the motion is.
TEST(ApproachWatch, NeverMissesAnApproach) {
  std::mt19937_64 random(3);
  const auto uniform = [&] { return static_cast<double>(random() >> 11) * 0x1p-52 - 1; };
  int closer = 0, quiet = 0;
  for (int trial = 0; trial < 100; ++trial) {
    std::vector<Vec3> reference;
    for (int k = 0; k < 300; ++k) reference.emplace_back(8 * uniform(), 8 * uniform(), 8 * uniform());
    ApproachWatch watch(reach, margin);
    watch.set(reference);
    const double turn = 0.05 * uniform(), noise = 0.2 * (1 + uniform()), shift = 10 * uniform();
    const Mat3 rotation = Eigen::AngleAxisd(turn, Vec3::UnitY()).toRotationMatrix();
    std::vector<Vec3> moved;
    for (const Vec3& p : reference)
      moved.push_back(rotation * p + Vec3(shift, 0, 0) + noise * Vec3(uniform(), uniform(), uniform()));
    bool closer_now = false;
    for (std::size_t a = 0; a < moved.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
        closer_now |=
            (reference[a] - reference[b]).norm() > reach + margin && (moved[a] - moved[b]).norm() < reach;
    const bool told = watch.may_be_closer(moved, true);
    EXPECT_TRUE(told || !closer_now);
    closer += closer_now;
    quiet += !told;
  }
  EXPECT_GT(closer, 0);  // both happen
  EXPECT_GT(quiet, 0);
}

}  // namespace
}  // namespace nanocarbon
