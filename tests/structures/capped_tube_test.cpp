// SPDX-License-Identifier: GPL-2.0-or-later
#include "nanocarbon/structures/capped_tube.h"

#include <gmock/gmock.h>

#include <cmath>
#include <complex>
#include <numbers>

#include "nanocarbon/core/error.h"
#include "nanocarbon/structures/tube.h"
#include "structures/facts.h"

namespace nanocarbon::structures {
namespace {

using test::facts;
using test::Facts;
using testing::ElementsAre;
using testing::Pair;

//! Bonds shared by two pentagons.
std::size_t neighbouring_pentagons(const Molecule& molecule) {
  std::map<std::pair<AtomIndex, AtomIndex>, int> pentagons;
  std::size_t count = 0;
  for (std::size_t r = 0; r < molecule.rings.size(); ++r) {
    const auto ring = molecule.rings[r];
    for (std::size_t i = 0; ring.size() == 5 && i < 5; ++i)
      count += ++pentagons[std::minmax(ring[i], ring[(i + 1) % 5])] == 2;
  }
  return count;
}

TEST(CappedTube, EveryChiralityIsAFullerene) {
  for (int n = 0; n <= 12; ++n)
    for (int m = 0; m <= 12; ++m) {
      const bool half_dodecahedron = n + m == 5 && n * m == 0;
      if (n + m < 6 && !half_dodecahedron) continue;
      SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
      const Molecule tube = capped_tube(n, m, 10.0);
      const Facts f = facts(tube);
      EXPECT_THAT(f.coordination, ElementsAre(Pair(3, tube.size())));
      EXPECT_THAT(f.rings, ElementsAre(Pair(5, 12), Pair(6, tube.size() / 2 - 10)));
      EXPECT_EQ(f.euler_characteristic, 2);
      EXPECT_TRUE(f.bonds_sorted && f.rings_follow_bonds && f.sides_agree);
      EXPECT_GT(f.shortest_bond, 1.35);
      EXPECT_LT(f.longest_bond, 1.50);
      EXPECT_GT(f.nearest_unbonded, 2.2);
      if (tube_cap(n, m).isolated) {
        EXPECT_EQ(neighbouring_pentagons(tube), 0u);
      }
    }
}

// Tubes whose caps are known: halves of C60 along its five- and threefold axes, of C240 and C540 along
// fivefold ones.
TEST(CappedTube, KnownCapsAreFound) {
  for (const double length : {0.5, 8.0, 25.0}) {
    EXPECT_EQ(capped_tube(5, 5, length).size() % 10, 60u % 10);
    EXPECT_EQ(capped_tube(9, 0, length).size() % 18, 60u % 18);
    EXPECT_EQ(capped_tube(10, 10, length).size() % 20, 240u % 20);
    EXPECT_EQ(capped_tube(15, 15, length).size() % 30, 540u % 30);
  }
  EXPECT_TRUE(tube_cap(5, 5).isolated && tube_cap(9, 0).isolated && tube_cap(10, 10).isolated);
  // C60 and C70 are the smallest fullerenes without neighbouring pentagons.
  EXPECT_EQ(capped_tube(5, 5, 0.5).size(), 60u);
  EXPECT_EQ(capped_tube(5, 5, 4.92).size(), 70u);
  // (9, 0) is the thinnest zigzag tube with such a cap.
  EXPECT_FALSE(tube_cap(8, 0).isolated);
}

//! Mean angle (degrees, -30 to 30) between the axis and the bonds around the middle of a tube that runs along
//! z: folded into one sixth of a turn, it tells the chirality and the hand.
double chiral_angle(const Molecule& tube, double radius) {
  std::complex<double> sum = 0.0;
  for (const Bond& b : tube.bonds) {
    const Vec3 p = tube.positions[b.first], d = tube.positions[b.second] - p;
    if (std::abs(p.z()) > 8.0 || std::hypot(p.x(), p.y()) < 0.9 * radius) continue;
    const double turn = (p.x() * d.y() - p.y() * d.x()) / std::hypot(p.x(), p.y());
    sum += std::polar(1.0, 6.0 * std::atan2(turn, d.z()));
  }
  return std::arg(sum) / 6.0 * 180.0 / std::numbers::pi;
}

TEST(CappedTube, ChiralityHandAndRadiusAreThoseOfTheOpenTube) {
  for (const auto& [n, m] : {std::pair(7, 3), {3, 7}, {8, 4}, {6, 5}, {11, 2}, {2, 11}}) {
    SCOPED_TRACE(testing::Message() << "(" << n << ", " << m << ")");
    const double radius = tube_geometry(n, m).radius;
    const Molecule capped = capped_tube(n, m, 40.0);
    const double angle = chiral_angle(capped, radius);
    EXPECT_NEAR(angle, chiral_angle(open_tube(n, m, 60.0), radius), 1.0);
    // Textbook: tan = sqrt(3) m / (2 n + m) from zigzag, whose bonds run along the axis.
    const int large = std::max(n, m), small = std::min(n, m);
    EXPECT_NEAR(std::abs(angle),
                std::atan(std::numbers::sqrt3 * small / (2.0 * large + small)) * 180.0 / std::numbers::pi,
                1.0);
    for (const Vec3& p : capped.positions)
      // The springs hardly resist a little flattening.
      if (std::abs(p.z()) < 8.0) {
        EXPECT_NEAR(std::hypot(p.x(), p.y()), radius, 0.10 * radius);
      }
  }
}

TEST(CappedTube, RefusesWhatCannotBeCapped) {
  EXPECT_THROW(capped_tube(3, 0, 10.0), UserError);
  EXPECT_THROW(capped_tube(2, 2, 10.0), UserError);
  EXPECT_THROW(capped_tube(4, 1, 10.0), UserError);
  EXPECT_THROW(capped_tube(3, 2, 10.0), UserError);
  EXPECT_THROW(capped_tube(-1, 9, 10.0), UserError);
  EXPECT_THROW(capped_tube(5, 5, 0.0), UserError);
}

}  // namespace
}  // namespace nanocarbon::structures
