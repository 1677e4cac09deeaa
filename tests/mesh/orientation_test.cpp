// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/mesh/orientation.h"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

namespace nanocarbon::mesh {
namespace {

// Small integers, for which the determinant is exact in 64-bit arithmetic.
std::int64_t integer_determinant(const std::array<std::array<std::int64_t, 3>, 4>& p) {
  std::array<std::array<std::int64_t, 3>, 3> m;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t d = 0; d < 3; ++d) m[i][d] = p[i][d] - p[3][d];
  return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
         m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
         m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
}

TEST(Orientation, IsPositiveWhereTheTriangleLooksCounterClockwise) {
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)), 1);
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(0, 1, 0), Vec3(1, 0, 0), Vec3(0, 0, 1)), -1);
  EXPECT_EQ(orientation(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(5, 7, 0)), 0);
  EXPECT_EQ(orientation_2d(Vec3(0, 0, 0), Vec3(1, 0, 5), Vec3(0, 1, 9), 2), 1);
  EXPECT_EQ(orientation_2d(Vec3(0, 0, 0), Vec3(0, 1, 5), Vec3(1, 0, 9), 2), -1);
}

TEST(Orientation, AgreesWithIntegerArithmeticAlsoWhereFloatingPointFails) {
  std::mt19937_64 random(1);
  const auto coordinate = [&] { return static_cast<std::int64_t>(random() % 200001) - 100000; };
  int zeros = 0;
  for (int i = 0; i < 20000; ++i) {
    std::array<std::array<std::int64_t, 3>, 4> p;
    for (auto& point : p)
      for (auto& x : point) x = coordinate();
    // Every other time the fourth point is in the plane, or one unit off it.
    if (i % 2 == 0) {
      const std::int64_t s = static_cast<std::int64_t>(random() % 3),
                         t = static_cast<std::int64_t>(random() % 3);
      for (std::size_t d = 0; d < 3; ++d)
        p[3][d] = p[0][d] + s * (p[1][d] - p[0][d]) + t * (p[2][d] - p[0][d]);
      p[3][0] += static_cast<std::int64_t>(i % 6 == 0) - static_cast<std::int64_t>(i % 6 == 2);
    }
    const std::int64_t determinant = integer_determinant(p);
    const int expected = determinant < 0 ? 1 : determinant > 0 ? -1 : 0;
    zeros += expected == 0;
    // A tiny unit, so that no coordinate is an integer for the filter to profit from; it scales exactly.
    std::array<Vec3, 4> q;
    for (std::size_t k = 0; k < 4; ++k)
      for (std::size_t d = 0; d < 3; ++d)
        q[k][static_cast<int>(d)] = std::ldexp(static_cast<double>(p[k][d]), -40);
    ASSERT_EQ(orientation(q[0], q[1], q[2], q[3]), expected);
  }
  EXPECT_GT(zeros, 1000);
}

TEST(Orientation, OneUnitInTheLastPlaceOffThePlaneIsSeen) {
  // Points of the plane x + y + z = 0 far apart; the fourth is moved by the smallest step a double can take.
  const Vec3 a(1e5, -1e5, 0), b(0, 1e5, -1e5), c(-1e5, 0, 1e5);
  const double x = 1.0 / 3.0;
  const Vec3 in_plane(x, -x, 0);
  EXPECT_EQ(orientation(a, b, c, in_plane), 0);
  const int above = orientation(a, b, c, Vec3(std::nextafter(x, 1.0), -x, 0));
  const int below = orientation(a, b, c, Vec3(std::nextafter(x, 0.0), -x, 0));
  EXPECT_EQ(above, -below);
  EXPECT_NE(above, 0);
}

TEST(Orientation, TurnsWithTheOrderOfThePoints) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int i = 0; i < 1000; ++i) {
    std::array<Vec3, 4> p;
    for (Vec3& q : p) q = Vec3(uniform(random), uniform(random), 1e-17 * uniform(random));
    const int sign = orientation(p[0], p[1], p[2], p[3]);
    EXPECT_EQ(orientation(p[1], p[0], p[2], p[3]), -sign);
    EXPECT_EQ(orientation(p[0], p[1], p[3], p[2]), -sign);
    EXPECT_EQ(orientation(p[1], p[2], p[0], p[3]), sign);
  }
}

}  // namespace
}  // namespace nanocarbon::mesh
