// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/tube.h"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "nanocarbon/core/error.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::_;
using testing::ElementsAre;
using testing::Pair;

TEST(Tube, GeometryFollowsTheTextbookFormulas) {
  for (int n = 1; n <= 12; ++n)
    for (int m = 0; m <= n; ++m) {
      const TubeGeometry g = tube_geometry(n, m);
      const double lattice = std::sqrt(3.0) * 1.4204, root = std::sqrt(n * n + n * m + m * m);
      const int divisor = std::gcd(2 * n + m, 2 * m + n);
      EXPECT_NEAR(2.0 * g.radius, lattice * root / std::numbers::pi, 1e-9);
      EXPECT_NEAR(g.period, std::sqrt(3.0) * lattice * root / divisor, 1e-9);
      EXPECT_EQ(g.atoms_per_period, static_cast<std::size_t>(4 * (n * n + n * m + m * m) / divisor));
    }
}

// Atoms in one period of tubes that every textbook lists.
TEST(Tube, PeriodsHoldTheKnownNumbersOfAtoms) {
  EXPECT_EQ(periodic_tube(5, 5, 1).size(), 20u);
  EXPECT_EQ(periodic_tube(10, 10, 1).size(), 40u);
  EXPECT_EQ(periodic_tube(9, 0, 1).size(), 36u);
  EXPECT_EQ(periodic_tube(7, 3, 1).size(), 316u);
  EXPECT_EQ(periodic_tube(6, 5, 1).size(), 364u);
  EXPECT_EQ(periodic_tube(8, 2, 1).size(), 56u);
}

TEST(Tube, EveryPeriodicTubeIsATorusOfHexagons) {
  for (int n = 0; n <= 11; ++n)
    for (int m = 0; m <= 11; ++m) {
      if (n * n + n * m + m * m < 9) continue;
      SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
      // Two periods, so that no two atoms are bonded twice, through different images.
      const Molecule tube = periodic_tube(n, m, 2);
      const Facts f = facts(tube);
      EXPECT_EQ(tube.size(), 2 * tube_geometry(n, m).atoms_per_period);
      EXPECT_THAT(f.coordination, ElementsAre(Pair(3, tube.size())));
      EXPECT_THAT(f.rings, ElementsAre(Pair(6, tube.size() / 2)));
      EXPECT_EQ(f.euler_characteristic, 0);
      EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
      EXPECT_GT(f.shortest_bond, 1.35);
      EXPECT_LT(f.longest_bond, 1.50);
      // Tubes thinner than (4, 0) are so thin that second neighbours face each other across them.
      EXPECT_GT(f.nearest_unbonded, n * n + n * m + m * m < 16 ? 2.0 : 2.2);
    }
}

TEST(Tube, OpenTubesAreCylindersOfTheLengthAskedFor) {
  for (const auto& [n, m] : {std::pair(5, 5), {10, 10}, {9, 0}, {7, 3}, {3, 7}, {10, 1}}) {
    SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
    const Molecule tube = open_tube(n, m, 40.0);
    const Facts f = facts(tube);
    EXPECT_EQ(f.euler_characteristic, 0);
    EXPECT_THAT(f.coordination, ElementsAre(Pair(2, _), Pair(3, _)));
    EXPECT_THAT(f.rings, ElementsAre(Pair(6, _)));
    EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
    double low = 0.0, high = 0.0;
    for (const Vec3& p : tube.positions) {
      low = std::min(low, p.z()), high = std::max(high, p.z());
      EXPECT_NEAR(std::hypot(p.x(), p.y()), tube_geometry(n, m).radius, 1e-9);
    }
    EXPECT_LE(high - low, 40.0);
    EXPECT_GT(high - low, 35.0);
  }
}

// Going round the circumference of (n, m) turns one way, of (m, n) the other: their positions are mirror
// images.
TEST(Tube, SwappedIndicesAreMirrorImages) {
  const Molecule left = periodic_tube(7, 3, 1), right = periodic_tube(3, 7, 1);
  ASSERT_EQ(left.size(), right.size());
  const auto handedness = [](const Molecule& tube) {
    // Sum over bonds of (turn x rise): which way the steep bonds wind.
    double winding = 0.0;
    for (const Bond& b : tube.bonds) {
      const Vec3 p = tube.positions[b.first],
                 d = tube.positions[b.second] + image_shift(*tube.cell, b.image) - p;
      const double turn = (p.x() * d.y() - p.y() * d.x()) / std::hypot(p.x(), p.y());
      winding += turn * d.z() * (d.z() * d.z() - turn * turn);
    }
    return winding / static_cast<double>(tube.size());
  };
  EXPECT_GT(std::abs(handedness(left)), 0.01);
  EXPECT_NEAR(handedness(left), -handedness(right), 1e-6);
  EXPECT_NEAR(handedness(periodic_tube(5, 5, 1)), 0.0, 1e-9);
}

TEST(Tube, RefusesWhatIsNoTube) {
  EXPECT_THROW(periodic_tube(-1, 5, 1), UserError);
  EXPECT_THROW(periodic_tube(0, 0, 1), UserError);
  EXPECT_THROW(periodic_tube(2, 1, 1), UserError);
  EXPECT_THROW(periodic_tube(5, 5, 0), UserError);
  EXPECT_THROW(open_tube(5, 5, 1.0), UserError);
}

}  // namespace
}  // namespace nanocarbon::structures
